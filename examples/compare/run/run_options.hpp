// The command line of `graze-compare run`.
#pragma once

#include "../scene_reader.hpp"
#include "extent.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace compare::run {

struct run_options {
    std::string scene;
    extent how_far;
    certainty wanted;
    number_input numbers = number_input::exactly;
    std::vector<std::string> types; // all types, if empty
    bool certified_alone = false;
    bool with_events = false;
    std::optional<int> distance; // from the origin, of the ball of this number
    double timing = 0.1;
    std::string json, picture, paths;
    std::string beside = "double"; // the type whose paths are drawn beside the true ones
};

// The options as CLI11 fills them, before they are checked.
struct raw_run_options {
    run_options parsed;
    std::string until, as = "exact";
    std::uint64_t collisions = 0;
    int distance = -1;
};

// Adds the subcommand; `to` must live until the command line has been parsed.
[[nodiscard]] CLI::App* add_run_command(CLI::App& app, raw_run_options& to);

// Throws input_error, which names the option.
[[nodiscard]] run_options checked(const raw_run_options& raw, const CLI::App& command);

} // namespace compare::run
