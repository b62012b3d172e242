// What is reported of the runs of a scene.
#pragma once

#include "runnable.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace compare::run {

struct judged_history {
    history found;
    first_mistake mistake;
};

// A moving ball at the end, in decimals.
struct end_state {
    int ball;
    std::vector<std::string> position, velocity;
};

struct proved_event {
    graze::scene_pair who;
    std::string time; // in decimals
    double about;
    bool tied, either_order, chosen;
};

// What stands still in a picture of the plane: a circle for a mirror, a segment for a wall, a long one for a plane.
struct outline {
    std::vector<std::array<double, 2>> points;
};

struct run_report {
    std::string command, scene;
    std::vector<proved_event> events;
    std::string end; // the time of the end, in decimals
    graze::ending why{};
    std::vector<graze::participant> jammed; // of a cascade
    std::string problem;                    // what ended the certified run early
    bool interrupted = false;
    std::uint64_t choices = 0;
    long bits = 0;
    int attempts = 0;
    double seconds = 0;
    int digits_wanted = 0;
    int digits = 0; // that the states at the end have
    std::vector<end_state> states;
    std::optional<int> distance_of; // the number of a ball
    std::string distance;           // of that ball from the origin, at the end
    std::vector<judged_history> types;
    std::vector<path> paths; // the true ones, in 2D
    std::vector<double> radii;
    std::vector<outline> outlines;
};

// For the terminal. with_events: list the proved sequence, too.
[[nodiscard]] std::string to_text(const run_report& report, bool with_events);

// For programs.
[[nodiscard]] std::string to_json(const run_report& report);

// "double is right for 14 collisions, to 5 digits; for 10 digits take dd_real."
[[nodiscard]] std::string conclusion(const run_report& report);

// Correct digits against collisions, a line for each type; and the true paths beside a type's, with the balls at the
// start and the end, the collisions, and where the two part. Both are SVG elements; the first is empty if no type has a
// right event. Both throw report::gnuplot_error.
[[nodiscard]] std::string digits_picture(const run_report& report);
[[nodiscard]] std::string paths_picture(const run_report& report, const judged_history& beside);

} // namespace compare::run
