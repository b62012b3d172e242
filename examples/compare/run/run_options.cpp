#include "run_options.hpp"

#include "../exact_text.hpp"
#include "../input_error.hpp"
#include "../option_checks.hpp"

#include <CLI/CLI.hpp>

namespace compare::run {

CLI::App* add_run_command(CLI::App& app, raw_run_options& to) {
    run_options& o = to.parsed;
    CLI::App* run =
        app.add_subcommand("run", "Proves the sequence of a scene's collisions and finds how long each number "
                                  "type follows it.");
    run->add_option("scene,--scene", o.scene, "A scene file in JSON; - reads it from the standard input")
        ->required()
        ->check(named());
    run->add_option("--until", to.until, "Stop at this time, a number as in a scene file");
    run->add_option("--collisions", to.collisions, "Stop after this number of collisions")
        ->check(whole_from(1, 10'000'000));
    run->add_option("--jam", o.how_far.jam,
                    "End the run when five things or fewer have met this often while time hardly advances (10000)")
        ->check(whole_from(1, 10'000'000));
    run->add_option("--digits", o.wanted.digits, "Decimal digits of positions and velocities at the end")
        ->capture_default_str()
        ->check(whole_from(1, 1'000'000));
    run->add_option("--most-bits", o.wanted.most_bits,
                    "The precision at which a decision that is still open is given up and reported")
        ->capture_default_str()
        ->check(whole_from(64, 1U << 26U));
    run->add_option("--as", to.as, "exact: take the scene's numbers as written; double: round them to doubles first")
        ->capture_default_str()
        ->check(CLI::IsMember({"double", "exact"}));
    run->add_option("--types", o.types, "Run only these number types, separated by commas")->delimiter(',');
    run->add_flag("--certified", o.certified_alone, "Make the proved run alone, without number types");
    run->add_flag("--events", o.with_events, "List the proved sequence");
    run->add_option("--distance", to.distance, "Print this ball's distance from the origin at the end");
    run->add_option("--timing", o.timing, "Seconds to spend on timing a type; 0 times nothing")
        ->capture_default_str()
        ->check(seconds_up_to(3600));
    run->add_option("--json", o.json, "Write the results to this file; - writes them to the standard output")
        ->check(named());
    run->add_option("--picture", o.picture, "Write a picture of correct digits against collisions to this file, as SVG")
        ->check(named());
    run->add_option("--paths", o.paths,
                    "Write a picture of the true paths beside a type's to this file, as SVG (2D only)")
        ->check(named());
    run->add_option("--beside", o.beside, "The type in the picture of --paths")->capture_default_str()->check(named());
    return run;
}

run_options checked(const raw_run_options& raw, const CLI::App& command) {
    run_options o = raw.parsed;
    const auto given = [&](const char* option) { return command.get_option(option)->count() > 0; };
    if (!given("--until") && !given("--collisions")) {
        throw input_error("run: --until or --collisions is needed: where does the run stop?");
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
    if (o.certified_alone && !o.types.empty()) {
        throw input_error("--certified: runs no number type, so --types does not go with it");
    }
    if (given("--beside") && o.paths.empty()) {
        throw input_error("--beside: needs --paths, the picture that the type is for");
    }
    if (o.certified_alone && (!o.picture.empty() || !o.paths.empty())) {
        throw input_error("--certified: runs no number type, so --picture and --paths do not go with it");
    }
    o.numbers = raw.as == "exact" ? number_input::exactly : number_input::as_double;
    return o;
}

} // namespace compare::run
