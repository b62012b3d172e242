#include "run_options.hpp"

#include "../exact_text.hpp"
#include "../input_error.hpp"

#include <CLI/CLI.hpp>

namespace compare::run {

CLI::App* add_run_command(CLI::App& app, raw_run_options& to) {
    const CLI::Validator named([](const std::string& name) { return name.empty() ? "an empty name" : std::string(); },
                               "");
    run_options& o = to.parsed;
    CLI::App* run = app.add_subcommand(
        "run", "The proved sequence of a scene's collisions, and how long every number type keeps to it");
    run->add_option("scene,--scene", o.scene, "A scene file in JSON")->required()->check(named);
    run->add_option("--until", to.until, "Up to and with this time, a number as in a scene file");
    run->add_option("--collisions", to.collisions, "Up to so many collisions")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{10'000'000}));
    run->add_option(
           "--jam", o.how_far.jam,
           "End when three or fewer have met so many times while time all but stands still, 10000 if not given")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{10'000'000}));
    run->add_option("--digits", o.wanted.digits, "Decimal digits of positions and velocities at the end")
        ->capture_default_str()
        ->check(CLI::Range(1, 1'000'000));
    run->add_option("--most-bits", o.wanted.most_bits,
                    "The precision after which a decision that is still open is reported")
        ->capture_default_str()
        ->check(CLI::Range(64L, 1L << 26U));
    run->add_option("--as", to.as, "exact: take the scene's numbers as written; double: round them to doubles first")
        ->capture_default_str()
        ->check(CLI::IsMember({"double", "exact"}));
    run->add_option("--types", o.types, "Only these number types, separated by commas")->delimiter(',');
    run->add_flag("--certified", o.certified_alone, "The proved run alone, no number type beside it");
    run->add_flag("--events", o.with_events, "List the proved sequence");
    run->add_option("--distance", to.distance, "Print how far this ball is from the origin at the end");
    run->add_option("--timing", o.timing, "Seconds to spend on each type's events per second; 0: nothing is timed")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 3600.0));
    run->add_option("--json", o.json, "Write everything to this file")->check(named);
    run->add_option("--picture", o.picture, "Write correct digits against collisions to this SVG file")->check(named);
    run->add_option("--paths", o.paths, "Write the paths, true and in a type, to this SVG file (scenes in the plane)")
        ->check(named);
    run->add_option("--beside", o.beside, "The type of that picture")->capture_default_str()->check(named);
    return run;
}

run_options checked(const raw_run_options& raw, const CLI::App& command) {
    run_options o = raw.parsed;
    const auto given = [&](const char* option) { return command.get_option(option)->count() > 0; };
    if (!given("--until") && !given("--collisions")) {
        throw input_error("run: how far? --until or --collisions");
    }
    if (given("--until")) {
        try {
            o.how_far.until = parse_exact(raw.until);
        } catch (const number_text_error& error) {
            throw input_error("--until: " + std::string(error.what()));
        }
        if (o.how_far.until->sign() < 0) {
            throw input_error("--until: " + printable(raw.until) + " is before the start at 0");
        }
    }
    if (given("--collisions")) {
        o.how_far.events = raw.collisions;
    }
    if (given("--distance")) {
        if (raw.distance < 0) {
            throw input_error("--distance: " + std::to_string(raw.distance) + " is not a ball's number");
        }
        o.distance = raw.distance;
    }
    if (!(o.timing >= 0)) {
        throw input_error("--timing: not a number of seconds");
    }
    if (o.certified_alone && !o.types.empty()) {
        throw input_error("--certified: leaves no type for --types");
    }
    if (given("--beside") && o.paths.empty()) {
        throw input_error("--beside: the type of the picture of --paths, which is not asked for");
    }
    if (o.certified_alone && (!o.picture.empty() || !o.paths.empty())) {
        throw input_error("--certified: leaves no type for --picture and --paths");
    }
    o.numbers = raw.as == "exact" ? number_input::exactly : number_input::as_double;
    return o;
}

} // namespace compare::run
