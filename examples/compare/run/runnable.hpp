// The number types that a scene is run in.
#pragma once

#include "interruption.hpp"
#include "sequence.hpp"

#include <functional>
#include <string>
#include <vector>

namespace compare::run {

// timing: how many seconds, at least, to measure a type's events per second; 0: not at all. with_paths: record paths
// for pictures, in 2D. show_progress(events, time) is called now and then.
struct run_plan {
    extent how_far;
    double timing = 0.1;
    bool with_paths = false;
    std::function<void(std::uint64_t, double)> show_progress{};
};

struct runnable {
    std::string type, library;
    history (*in_plane)(const exact_scene<2>&, const true_sequence<2>&, const run_plan&);
    history (*in_space)(const exact_scene<3>&, const true_sequence<3>&, const run_plan&);
};

// The types of this build, in the order of the list of types.
[[nodiscard]] std::vector<runnable> all_runnables();

namespace types {

runnable of_graze(); // exact decisions, correctly rounded contacts
runnable of_float();
runnable of_double();
runnable of_long_double();
runnable of_float128();          // libquadmath
runnable of_double_double();     // QD
runnable of_cpp_bin_float_50();  // Boost
runnable of_cpp_bin_float_100(); //
runnable of_mpfr_float_50();     // Boost on MPFR

} // namespace types
} // namespace compare::run
