#include "options.hpp"

#include "input_error.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace compare {

namespace {

// "lagrange" is both of its roots, "lagrange/stable" one.
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
            throw input_error("--variants: \"" + printable(name) +
                              "\" is none of textbook, halved, kahan, lagrange, alone or with /printed or /stable");
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
                              "\" is none of discriminant, time, crossing, position, velocity");
        }
        chosen.push_back(static_cast<quantity>(place - quantity_names.begin()));
    }
    return chosen;
}

// CLI11 takes "-1" and what is too large for unsigned numbers too.
const CLI::Validator unsigned_number(
    [](const std::string& text) {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        return error == std::errc() && end == text.data() + text.size() ? std::string()
                                                                        : "not a whole number below 2^64";
    },
    "");
const CLI::Validator named([](const std::string& name) { return name.empty() ? "an empty name" : std::string(); }, "");

} // namespace

options parse_options(int argc, const char* const* argv) {
    options o;
    for (int i = 0; i < argc; ++i) {
        o.command += (i == 0 ? "" : " ") + std::string(i == 0 ? "graze-compare" : argv[i]);
    }
    CLI::App app("Runs the formulas of colliding balls in many number types and says what each costs and loses.\n"
                 "Without a scene or family: a pool break, with 2,000 grazing and 2,000 far pairs beside it.",
                 "graze-compare");
    std::vector<std::string> variants, quantities;
    std::string as = "double";
    bool list_types = false, list_families = false;
    const auto taking_one = CLI::MultiOptionPolicy::Throw;
    auto* scene =
        app.add_option("scene,--scene", o.scene, "A scene file in JSON")->check(named)->multi_option_policy(taking_one);
    auto* family = app.add_option("--family", o.family, "Draw a family of hard pairs instead (--list-families)")
                       ->check(named)
                       ->excludes(scene);
    app.add_option("--count", o.count, "How many pairs of the family")
        ->capture_default_str()
        ->check(CLI::Range(std::size_t{1}, std::size_t{200'000}))
        ->needs(family);
    app.add_option("--dimension", o.dimension, "The family in the plane or in space")
        ->capture_default_str()
        ->check(CLI::IsMember({2, 3}))
        ->needs(family);
    app.add_option("--seed", o.seed, "Of the family, or of a scene's sample")
        ->capture_default_str()
        ->check(unsigned_number);
    app.add_option("--as", as, "double: round the scene's numbers to doubles first; exact: take them as written")
        ->capture_default_str()
        ->check(CLI::IsMember({"double", "exact"}));
    app.add_flag("--all", o.all, "Every pair of a scene, not a sample; exact types take all pairs, however long");
    app.add_option("--types", o.types, "Only these number types, separated by commas (--list-types)")->delimiter(',');
    app.add_option("--variants", variants,
                   "Only these: textbook, halved, kahan, lagrange; with /printed or /stable, one of both roots")
        ->delimiter(',');
    app.add_option("--quantity", quantities,
                   "Tables of the errors of: discriminant, time, crossing, position, velocity")
        ->delimiter(',');
    app.add_flag("--every-row", o.table.every_row, "Every variant of every type in the table");
    app.add_option("--digits", o.digits, "Decimal digits of the time that you want")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    app.add_option("--timing", o.timing, "Seconds to spend on a type's times in a group; 0: nothing is timed")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 3600.0));
    app.add_option("--json", o.json, "Write everything to this file")->check(named);
    app.add_option("--report", o.report, "Write a report in HTML to this file")->check(named);
    app.add_option("--picture", o.picture, "Write the report's picture of speed against error alone to this SVG file")
        ->check(named);
    app.add_flag("--list-types", list_types, "What there is to measure, and what this build lacks");
    app.add_flag("--list-families", list_families, "What there is to draw");
    CLI::App* diff =
        app.add_subcommand("diff", "What got better, worse or stayed between two --json files; exit code 1 "
                                   "when a decision or an error got worse");
    diff->add_option("old", o.old_results, "The earlier results")->required();
    diff->add_option("new", o.new_results, "The later results")->required();
    CLI::App* running = app.add_subcommand("run", "The proved sequence of a scene's collisions, and how long every "
                                                  "number type keeps to it (run --help tells more)");
    running->set_help_flag(); // what follows is another program's
    running->prefix_command();
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        o.what = action::help;
        o.help = diff->parsed() ? diff->help(app.get_name()) : app.help();
        return o;
    } catch (const CLI::ParseError& error) {
        throw input_error(one_line(error.what()));
    }
    o.numbers = as == "exact" ? number_input::exactly : number_input::as_double;
    o.methods = methods_of(variants);
    o.table.quantities = quantities_of(quantities);
    o.what = diff->parsed()      ? action::diff
             : running->parsed() ? action::run
             : list_types        ? action::list_types
             : list_families     ? action::list_families
                                 : action::compare;
    return o;
}

} // namespace compare
