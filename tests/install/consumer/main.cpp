#include <graze/graze.hpp>

// Two balls of radius 1 whose centres are 10 apart and which approach at speed 2 meet after 4.
int main() {
    const graze::ball<2> a{{0, 0}, {2, 0}, 1};
    const graze::ball<2> b{{10, 0}, {0, 0}, 1};
    const auto s = graze::solve(a, b);
    bool right = s.what == graze::encounter::hit && s.time == 4 && s.velocity_b[0] == 2;
#if defined(GRAZE_COMPILED) || defined(CONSUMER_DECIDES) // header-only it takes the compiler four times as long
    right = right && graze::classify(a, b) == graze::encounter::hit && graze::time_of_impact(a, b) == 4.0;
#endif
    return right ? 0 : 1;
}
