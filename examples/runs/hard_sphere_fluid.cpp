// A fluid of 500 hard spheres in a box, checked by code that is independent of the library. The hash of its final state
// is the same on every machine and for every order in which the balls are listed.
#include "exact_runs.hpp"
#include "flight_check.hpp"
#include "fluid_scene.hpp"
#include "state_hash.hpp"

#include <cstdlib>
#include <iostream>
#include <numeric>

// hard_sphere_fluid [events] [permutations]
int main(int argc, char** argv) {
    const std::uint64_t events = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20000;
    const int permutations = argc > 2 ? std::atoi(argv[2]) : 1;
    const graze::run_limits<double> limits{.events = events};
    const auto fluid = make_fluid<3>(500, 1);

    // The clock stays below the time in which a ball of mean speed crosses the box: so times are as fine as positions.
    flight_check<3> check(fluid.scene(), 10);
    constexpr double window = 4;
    const auto finished = run_exactly<3>(fluid.scene(), limits, std::ref(check), graze::cells::where_useful,
                                         {.by = window, .told = [&] { check.set_clock_back(window); }});
    const std::uint64_t hash = hash_of(finished.flights);
    std::cout << finished.outcome.events << " events, none missed, none invented, hash " << std::hex << hash << std::dec
              << '\n';
    if (check.energy_drift() > check.drift_allowed()) {
        std::cout << "energy is off by " << check.energy_drift() << ", allowed " << check.drift_allowed() << '\n';
        return 1;
    }
    if (check.deepest() > 8 * 0x1p-49) { // units in the last place of the largest coordinate
        std::cout << "two balls were " << check.deepest() << " deep in each other\n";
        return 1;
    }
    if (argc > 1) {
        std::cout << "deepest overlap " << check.deepest() << ", rounding explains " << check.depth_allowed()
                  << "; energy off by " << check.energy_drift() << " of itself, rounding explains "
                  << check.drift_allowed() << '\n';
    }

    int same = 0;
    for (int seed = 1; seed <= permutations; ++seed) {
        std::vector<std::size_t> order(fluid.balls.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::mt19937_64 random(static_cast<std::uint64_t>(seed));
        for (std::size_t i = order.size() - 1; i > 0; --i) { // std::shuffle differs between libraries
            std::swap(order[i], order[random() % (i + 1)]);
        }
        auto permuted = fluid;
        for (std::size_t i = 0; i < order.size(); ++i) {
            permuted.balls[i] = fluid.balls[order[i]];
        }
        const auto other = run_exactly<3>(permuted.scene(), limits, {}, graze::cells::where_useful, {.by = window});
        std::vector<graze::flight<3>> flights(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            flights[order[i]] = other.flights[i];
        }
        same += hash_of(flights) == hash ? 1 : 0;
    }
    std::cout << same << " of " << permutations << " permutations end the same\n";
    return same == permutations ? 0 : 1;
}
