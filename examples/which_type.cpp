// Which number type does my scene need? The compiler answers.
#include <graze/formula/exact_in.hpp>
#include <graze/graze.hpp>

#include <cstdint>
#include <iostream>

namespace {

// A billiard table of 2.54 m: positions and radii in steps of 1/2 mm, velocities in steps of 1/64 m/s up to 8 m/s.
constexpr graze::grid table{.length = 13, .velocity = 10};
// The same with positions in steps of 1/64 mm, as a float's 24 bits would hold them.
constexpr graze::grid fine_table{.length = 18, .velocity = 10};

// In doubles no number that a decision rests on is ever rounded: solve is exact, and nothing else is needed.
static_assert(graze::exact_in<double, 2>(table));
static_assert(!graze::exact_in<float, 2>(table));
// On the fine grid doubles might round, and 64-bit integers do not overflow: classify takes their place.
static_assert(!graze::exact_in<double, 2>(fine_table));
static_assert(graze::exact_in<std::int64_t, 2>(fine_table));

template <graze::grid G>
void tell(const char* name) {
    std::cout << name << ": decisions take " << graze::bits_to_decide<2>(G) << " bits, exact in"
              << (graze::exact_in<float, 2>(G) ? " float" : "") << (graze::exact_in<double, 2>(G) ? " double" : "")
              << (graze::exact_in<std::int64_t, 2>(G) ? " int64" : " no machine type") << '\n';
}

} // namespace

int main() {
    tell<table>("table");
    tell<fine_table>("fine table");

    // Two balls of 57 mm that just touch in passing, in half millimetres: told from a hit and from a miss.
    const graze::ball<2> cue{{{0, 0}}, {{512, 0}}, 57};
    for (const double aside : {113.0, 114.0, 115.0}) {
        const graze::ball<2> eight{{{2540, aside}}, {{0, 0}}, 57};
        std::cout << aside << " steps aside: " << to_string(graze::solve(cue, eight).what) << '\n';
    }
}
