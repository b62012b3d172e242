// When does the cue ball meet the eight, and how do they leave? Lengths in metres, times in seconds.
#include <graze/graze.hpp>
#include <iostream>

int main() {
    const graze::ball<2> cue{{0, 0}, {2.5, 0}, 0.028575, 0.17}; // position, velocity, radius, mass
    const graze::ball<2> eight{{1.27, 0.02}, {0, 0}, 0.028575, 0.17};
    const auto s = graze::solve(cue, eight);
    std::cout << to_string(s.what) << " after " << s.time << " s\n"
              << "cue: " << s.velocity_a[0] << ", " << s.velocity_a[1] << " m/s\n"
              << "eight: " << s.velocity_b[0] << ", " << s.velocity_b[1] << " m/s\n";
}
