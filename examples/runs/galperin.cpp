// Two balls and a wall that spell π: the number of their collisions, for mass ratios of 100^n (G. Galperin, 2003).
#include "exact_runs.hpp"

#include <cstdlib>
#include <iostream>

namespace {

// A light ball at rest between a wall, x = 0, and a heavy ball that moves towards it.
std::uint64_t collisions(double mass_ratio) {
    const std::vector<graze::ball<2>> balls = {{{1, 0}, {0, 0}, 0.125, 1}, {{2, 0}, {-1, 0}, 0.125, mass_ratio}};
    const std::vector<graze::plane<2>> wall = {{{0, 0}, {1, 0}}};
    graze::run_limits<double> limits;
    limits.jam = 10'000'000; // the two meet many times, and nothing else is there
    const auto finished = run_exactly<2>({balls, wall, {}}, limits);
    if (finished.outcome.why != graze::ending::exhausted) {
        throw std::runtime_error("the balls still meet");
    }
    return finished.outcome.events;
}

} // namespace

// galperin [n]: for mass ratios up to 100^n.
int main(int argc, char** argv) {
    const int most = argc > 1 ? std::atoi(argv[1]) : 3;
    double mass_ratio = 1;
    for (int n = 0; n <= most; ++n) {
        std::cout << "100^" << n << ": " << collisions(mass_ratio) << " collisions\n";
        mass_ratio *= 100;
    }
}
