// Runs gnuplot without a shell: the script goes in through one unnamed file, the picture comes out through another.
#pragma once

#include <stdexcept>
#include <string>

namespace compare::report {

// gnuplot is missing or did not draw. what() says which, in words for the report's reader.
struct gnuplot_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// gnuplot's output for the script. Throws gnuplot_error if gnuplot cannot be started, fails or prints nothing.
[[nodiscard]] std::string run_gnuplot(const std::string& script);

} // namespace compare::report
