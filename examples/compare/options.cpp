#include "options.hpp"

#include "input_error.hpp"
#include "machine.hpp"
#include "option_checks.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace compare {

namespace {

std::string list_of_variants() {
    std::string text, last;
    for (const method& m : all_methods()) {
        const std::string variant = to_string(m.variant);
        text += variant == last ? "" : (text.empty() ? "" : ", ") + variant;
        last = variant;
    }
    return text;
}

// "lagrange" means both of its roots, "lagrange/stable" one.
std::vector<method> methods_of(const std::vector<std::string>& names) {
    const std::vector<method> all = all_methods();
    std::vector<method> chosen;
    for (const std::string& name : names) {
        const std::size_t before = chosen.size();
        for (const method& m : all) {
            const std::string variant = to_string(m.variant);
            if (name == variant || name == variant + "/" + to_string(m.root)) {
                chosen.push_back(m);
            }
        }
        if (chosen.size() == before) {
            throw input_error("--variants: \"" + printable(name) + "\" is no form; the forms are " +
                              list_of_variants() + ", each alone or with /printed or /stable");
        }
    }
    return names.empty() ? all : chosen;
}

std::vector<quantity> quantities_of(const std::vector<std::string>& names) {
    std::vector<quantity> chosen;
    for (const std::string& name : names) {
        const auto place = std::find(quantity_names.begin(), quantity_names.end(), name);
        if (place == quantity_names.end()) {
            throw input_error("--quantity: \"" + printable(name) +
                              "\" is no quantity; the quantities are discriminant, time, crossing, position, velocity");
        }
        chosen.push_back(static_cast<quantity>(place - quantity_names.begin()));
    }
    return chosen;
}

// An option of a subcommand must stand after it: before it, it would have no effect.
void expect_nothing_before(const CLI::App& app, const std::string& subcommand, const std::string& usage) {
    for (const CLI::Option* option : app.get_options()) {
        if (option->count() > 0) {
            throw input_error(option->get_name(false, false) + ": stands before the command " + subcommand +
                              ", which takes its own arguments after it: " + usage);
        }
    }
}

} // namespace

options parse_options(int argc, const char* const* argv) {
    options o;
    for (int i = 0; i < argc; ++i) {
        o.command += (i == 0 ? "" : " ") + std::string(i == 0 ? "graze-compare" : argv[i]);
    }
    CLI::App app(
        "Solves the collisions of balls in many number types and says what each type costs and what it loses.\n"
        "Without a scene or a family: a pool break, and 2,000 grazing and 2,000 far pairs.",
        "graze-compare");
    std::vector<std::string> variants, quantities;
    std::string as = "double";
    bool list_types = false, list_families = false;
    const auto taking_one = CLI::MultiOptionPolicy::Throw;
    app.set_version_flag("--version", "graze-compare " + this_machine().graze, "Print the version and exit");
    auto* scene = app.add_option("scene,--scene", o.scene, "A scene file in JSON; - reads it from the standard input")
                      ->check(named())
                      ->multi_option_policy(taking_one);
    auto* family = app.add_option("--family", o.family, "A family of hard pairs instead of a scene (--list-families)")
                       ->check(named())
                       ->excludes(scene);
    app.add_option("--count", o.count, "The number of pairs of the family")
        ->capture_default_str()
        ->check(whole_from(1, 200'000))
        ->needs(family);
    app.add_option("--dimension", o.dimension, "The dimension of the family: 2, the plane, or 3, space")
        ->capture_default_str()
        ->check(whole_from(2, 3))
        ->needs(family);
    app.add_option("--seed", o.seed, "The seed of the family, or of the sample of a scene")
        ->capture_default_str()
        ->check(whole_from(0, std::numeric_limits<std::uint64_t>::max()));
    app.add_option("--as", as, "double: round the scene's numbers to doubles first; exact: take them as written")
        ->capture_default_str()
        ->check(CLI::IsMember({"double", "exact"}));
    app.add_flag("--all", o.all, "Measure every pair of the scene, not a sample, with exact types too");
    app.add_option("--pair", o.pair,
                   "Measure only the pair of this number, as tables and reports number them; nothing is timed unless "
                   "--timing says so")
        ->check(whole_from(1, std::numeric_limits<std::uint64_t>::max()));
    app.add_option("--types", o.types, "Measure only these number types, separated by commas (--list-types)")
        ->delimiter(',');
    app.add_option("--variants", variants,
                   "Measure only these forms, separated by commas: " + list_of_variants() +
                       "; with /printed or /stable, only that root")
        ->delimiter(',');
    app.add_option("--quantity", quantities,
                   "Show a table of the errors of each: discriminant, time (of two balls), crossing (the time with a "
                   "plane, wall or "
                   "triangle), position, velocity")
        ->delimiter(',');
    app.add_flag("--every-row", o.table.every_row, "Show every form of every type in the table");
    app.add_option("--digits", o.digits, "The decimal digits of the time that you need")
        ->capture_default_str()
        ->check(whole_from(1, 1000));
    app.add_option("--timing", o.timing, "Seconds to spend on timing a type in a group; 0 times nothing")
        ->capture_default_str()
        ->check(seconds_up_to(3600));
    app.add_option("--json", o.json, "Write the results to this file; - writes them to the standard output")
        ->check(named());
    app.add_option("--report", o.report, "Write a report in HTML to this file")->check(named());
    app.add_option("--benchmark-json", o.benchmark_json, "Write the times to this file, in Google Benchmark's format")
        ->check(named());
    app.add_option("--pairs", o.pairs_folder,
                   "Write the pairs that the types are wrong on, and at their worst on, to this folder, as scene files")
        ->check(named());
    app.add_option("--inputs", o.inputs_file,
                   "Write every pair to this file, for the precision regression of one's own formulas (its INPUTS)")
        ->check(named());
    app.add_option("--picture", o.picture, "Write the picture of speed against error to this file, as SVG")
        ->check(named());
    app.add_flag("--list-types", list_types, "List the number types of this build, and those that it lacks");
    app.add_flag("--list-families", list_families, "List the families of hard pairs");
    CLI::App* diff = app.add_subcommand("diff", "Compare two results that --json wrote, or tell the history of more. "
                                                "Exit code 1: a decision or an error got worse");
    diff->add_option("results", o.result_files, "Result files, the earliest first; - reads the standard input")
        ->expected(0, 1000);
    diff->add_option("--report", o.diff_report, "Write the differences of two results to this file, in HTML")
        ->check(named());
    CLI::App* running = app.add_subcommand("run", "Prove the sequence of a scene's collisions and find how long each "
                                                  "number type follows it (run --help)");
    running->set_help_flag(); // what follows are the other program's options
    running->prefix_command();
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        o.what = action::say;
        o.said = diff->parsed() ? diff->help(app.get_name()) : app.help();
        return o;
    } catch (const CLI::CallForVersion& version) {
        o.what = action::say;
        o.said = std::string(version.what()) + "\n";
        return o;
    } catch (const CLI::ParseError& error) {
        throw input_error(one_line(error.what()));
    }
    if (running->parsed()) {
        expect_nothing_before(app, "run", "graze-compare run SCENE --until T");
    }
    if (diff->parsed()) {
        expect_nothing_before(app, "diff", "graze-compare diff OLD.json NEW.json");
        if (o.result_files.size() < 2) {
            throw input_error("diff: two result files are needed: graze-compare diff OLD.json NEW.json");
        }
    }
    o.numbers = as == "exact" ? number_input::exactly : number_input::as_double;
    if (!o.inputs_file.empty() && o.numbers == number_input::exactly) {
        throw input_error("--inputs: holds doubles; leave out --as exact");
    }
    o.methods = methods_of(variants);
    o.table.quantities = quantities_of(quantities);
    o.table.one_pair = o.pair.has_value();
    if (o.pair && app.get_option("--timing")->count() == 0) {
        o.timing = 0;
    }
    o.what = diff->parsed()      ? action::diff
             : running->parsed() ? action::run
             : list_types        ? action::list_types
             : list_families     ? action::list_families
                                 : action::compare;
    return o;
}

} // namespace compare
