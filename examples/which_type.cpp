// Which number type a scene needs, at compile time.
#include <graze/formula/exact_in.hpp>
#include <graze/graze.hpp>

#include <cstdint>
#include <iostream>

namespace {

// A billiard table of 2.54 m: positions and radii in steps of 1/2 mm, velocities in steps of 1/64 m/s up to 8 m/s.
constexpr graze::grid table{.length = 13, .velocity = 10};
// The same table with positions in steps of 1/64 mm. They still fit into a float's 24 bits.
constexpr graze::grid fine_table{.length = 18, .velocity = 10};

// In doubles, no number of a decision is ever rounded: solve decides exactly, and nothing else is needed.
static_assert(graze::exact_in<double, 2>(table));
static_assert(!graze::exact_in<float, 2>(table));
// On the fine grid doubles might round, so classify takes their place. 64-bit integers would not overflow.
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

    // Two balls of 57 mm that just touch in passing, in half millimetres: a graze, neither a hit nor a miss.
    const graze::ball<2> cue{{0, 0}, {512, 0}, 57};
    for (const double aside : {113.0, 114.0, 115.0}) {
        const graze::ball<2> eight{{2540, aside}, {0, 0}, 57};
        std::cout << aside << " steps aside: " << to_string(graze::solve(cue, eight).what) << '\n';
    }
}
