// The command line.
#pragma once

#include "method.hpp"
#include "number_input.hpp"
#include "table.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace compare {

enum class action { compare, diff, run, list_types, list_families, say };

struct options {
    action what = action::compare;
    std::string said; // the help or the version
    std::string scene, family;
    std::size_t count = 2000;
    std::uint64_t seed = 1;
    int dimension = 2; // of a family
    number_input numbers = number_input::as_double;
    bool all = false;
    std::vector<std::string> types; // all types, if empty
    std::vector<method> methods;
    table_options table;
    int digits = 15;
    double timing = 0.2;
    std::optional<std::size_t> pair; // only the pair of this number
    std::string json, report, picture, benchmark_json, pairs_folder, inputs_file;
    std::vector<std::string> result_files; // of diff, the earliest first
    std::string diff_report;
    std::string command; // as typed
};

// Throws input_error, which names the option and what is wrong with it.
[[nodiscard]] options parse_options(int argc, const char* const* argv);

} // namespace compare
