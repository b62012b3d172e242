// The command line of a precision program.
#pragma once

#include "../../examples/compare/quoted.hpp"

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace precision {

struct options {
    std::vector<std::string> only;             // only figures whose key contains one of these
    std::vector<std::filesystem::path> inputs; // instead of the families
    std::vector<std::filesystem::path> kept;   // files, or folders of *.txt, in addition to the families
    std::filesystem::path accepted, results = "precision-results";
    std::string as_variant, as_type; // compare with the accepted figures of these; empty: with the formula's own
    double tolerance = 0;            // percent by which the largest error may exceed the accepted one
    std::size_t pairs = 400;
    std::uint64_t seed = 1;
    unsigned threads = 1;
    bool triangles = false; // of the families, only these
    bool show = false, quiet = false, expect_loss = false, no_update = false, help = false;
    std::vector<std::filesystem::path> flag_results; // for --which-flag
};

extern const char* const usage;

// Throws std::invalid_argument, which names the option.
[[nodiscard]] options parse(const std::vector<std::string>& words);

using compare::quoted;

} // namespace precision
