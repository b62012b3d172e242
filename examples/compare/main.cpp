// graze-compare: what each number type costs and loses on the collisions of a scene.

#include "answer.hpp"
#include "diff.hpp"
#include "extremes.hpp"
#include "families.hpp"
#include "input_error.hpp"
#include "inputs.hpp"
#include "json_results.hpp"
#include "machine.hpp"
#include "options.hpp"
#include "report.hpp"
#include "run.hpp"
#include "run/interruption.hpp"
#include "stopwatch.hpp"
#include "table.hpp"
#include "text_table.hpp"
#include "type_list.hpp"
#include "whole_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>

namespace compare {

namespace {

constexpr int worse = 1, failed = 2, stopped = 130; // the last one as of a program that SIGINT ended

// In the order of all_types(), each once. An alias stands for the type that it names.
std::vector<measurable> types_of(const options& o) {
    std::vector<measurable> all = all_types();
    if (o.types.empty()) {
        return all;
    }
    std::vector<std::string> wanted;
    for (const std::string& name : o.types) {
        const auto place =
            std::find_if(all.begin(), all.end(), [&](const measurable& m) { return m.information.name == name; });
        if (place == all.end()) {
            throw input_error("--types: no number type \"" + printable(name) + "\"; --list-types names them");
        }
        const std::string& alias = place->information.alias_of;
        wanted.push_back(alias.empty() ? name : alias);
    }
    std::vector<measurable> chosen;
    std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), [&](const measurable& m) {
        return std::find(wanted.begin(), wanted.end(), m.information.name) != wanted.end();
    });
    return chosen;
}

// How the user calls this program. A script that starts it sets the variable.
std::string called() {
    const char* script = std::getenv("GRAZE_COMPARE_CALLED");
    return script == nullptr ? "graze-compare" : script;
}

// The options that choose the pairs.
std::string inputs_of(const options& o) {
    std::string text;
    if (!o.family.empty()) {
        text += " --family " + quoted(o.family) + " --count " + std::to_string(o.count) + " --dimension " +
                std::to_string(o.dimension);
    } else if (!o.scene.empty()) {
        text += " " + quoted(o.scene);
    }
    text += o.numbers == number_input::exactly ? " --as exact" : "";
    text += o.all ? " --all" : "";
    return text + (o.seed != 1 ? " --seed " + std::to_string(o.seed) : "");
}

// Whether some output file is the standard output, which then holds nothing else.
bool writes_to_stream(const options& o) {
    return o.json == standard_stream || o.report == standard_stream || o.picture == standard_stream ||
           o.benchmark_json == standard_stream || o.inputs_file == standard_stream;
}

void check_outputs(const options& o) {
    namespace fs = std::filesystem;
    const std::array<std::pair<std::string, std::string>, 6> files = {{{"the scene", o.scene},
                                                                       {"--json", o.json},
                                                                       {"--report", o.report},
                                                                       {"--picture", o.picture},
                                                                       {"--benchmark-json", o.benchmark_json},
                                                                       {"--inputs", o.inputs_file}}};
    if (!o.pairs_folder.empty() && fs::exists(o.pairs_folder) && !fs::is_directory(o.pairs_folder)) {
        throw input_error("--pairs " + printable(o.pairs_folder, 200) + ": is not a folder");
    }
    for (auto one = files.begin() + 1; one != files.end(); ++one) {
        check_writable(one->first, one->second);
        for (auto earlier = files.begin(); earlier != one; ++earlier) {
            std::error_code error;
            if (!one->second.empty() && !earlier->second.empty() &&
                earlier->first + earlier->second != std::string("the scene") + standard_stream &&
                fs::weakly_canonical(fs::absolute(earlier->second), error) ==
                    fs::weakly_canonical(fs::absolute(one->second), error)) {
                throw input_error(earlier->first + " and " + one->first + ": the same file");
            }
        }
    }
}

// Types that take long come last, after a table of the others if `shown`.
void measure_in_two_parts(results& found, const std::vector<measurable>& types, const std::vector<group>& groups,
                          const measurement_plan& plan, const progress_line& line, const table_options* shown) {
    std::vector<measurable> soon = types;
    const auto late = std::stable_partition(soon.begin(), soon.end(), [](const auto& m) { return !m.takes_long; });
    const std::vector<measurable> later(late, soon.end());
    soon.erase(late, soon.end());
    measure_all(found, soon, groups, plan, line);
    line.show("");
    if (shown != nullptr && !soon.empty() && !later.empty() && !run::interrupted()) {
        results first = found;
        draw_conclusions(first);
        std::cout << to_text(first, *shown);
        std::cout << "\nDecimal and rational types take longer, up to some "
                  << std::lround(static_cast<double>(later.size() * groups.size()) *
                                 (plan.scoring_seconds + patience * plan.timing_seconds))
                  << " s for " << (later.size() == 1 ? "this one" : "these " + std::to_string(later.size()))
                  << ". Ctrl-C stops them; what has been measured is kept.\n\n"
                  << std::flush;
    }
    if (!later.empty()) {
        measure_all(found, later, groups, plan, line);
        line.show("");
    }
    // Puts types and rows into the order of the list, as if they had been measured in one part.
    const auto place = [&](const std::string& name) {
        return std::find_if(types.begin(), types.end(), [&](const auto& m) { return m.information.name == name; });
    };
    std::stable_sort(found.types.begin(), found.types.end(),
                     [&](const auto& x, const auto& y) { return place(x.name) < place(y.name); });
    std::stable_sort(found.rows.begin(), found.rows.end(),
                     [&](const row& x, const row& y) { return place(x.type) < place(y.type); });
}

int run_comparison(const options& o) {
    check_outputs(o);
    const stopwatch watch;
    const progress_line line(::isatty(STDERR_FILENO) != 0);
    results found;
    const std::vector<measurable> types = types_of(o);
    const std::vector<group> groups = groups_of(o, line);
    found.command = o.command;
    found.program = called();
    found.inputs = inputs_of(o);
    found.machine = this_machine();
    found.source = !o.family.empty()            ? "family " + o.family
                   : o.scene == standard_stream ? "the standard input"
                   : !o.scene.empty()           ? o.scene
                                                : "default";
    found.as = o.numbers == number_input::exactly ? "exact" : "double";
    found.seed = o.seed;
    found.digits = o.digits;
    found.missing = missing_types();
    for (const group& g : groups) {
        found.groups.push_back(g.information);
    }
    measurement_plan plan;
    plan.methods = o.methods;
    plan.every_pair = o.all;
    plan.timing_seconds = o.timing;
    run::note_interruptions();
    const bool in_two = !writes_to_stream(o) && !o.pair;
    measure_in_two_parts(found, types, groups, plan, line, in_two ? &o.table : nullptr);
    draw_conclusions(found);
    show_extremes(found, groups);
    found.seconds = watch.seconds();
    if (!writes_to_stream(o)) { // before any file: one that cannot be written costs no results
        std::cout << to_text(found, o.table) << std::flush;
    }
    if (!o.pairs_folder.empty()) {
        write_pairs(found, o.pairs_folder);
    }
    if (!o.json.empty()) {
        write_whole_file(o.json, to_json(found));
    }
    if (!o.benchmark_json.empty()) {
        write_whole_file(o.benchmark_json, to_benchmark_json(found));
    }
    if (!o.inputs_file.empty()) {
        write_whole_file(o.inputs_file, lines_of_pairs(groups, found.program + found.inputs));
    }
    if (!o.report.empty()) {
        write_report(found, o.report);
    }
    if (!o.picture.empty()) { // last, since it fails without gnuplot
        write_picture(found, o.picture);
    }
    return run::interrupted() ? stopped : 0;
}

int run_diff(const options& o) {
    check_writable("--report", o.diff_report);
    std::vector<results> all;
    for (const std::string& file : o.result_files) {
        all.push_back(read_results(file));
    }
    const auto shown = [&](std::size_t i) { return printable(o.result_files[i], 200); };
    const std::size_t last = all.size() - 1;
    // Of more than two results, the last is compared with the one before it.
    const difference found = compare_results(all[last - 1], all[last]);
    if (found.compared == 0) {
        throw input_error(shown(last) + ": no row in common with " + shown(last - 1));
    }
    if (!o.diff_report.empty()) {
        write_diff_report(all, o.result_files, found, o.diff_report);
    }
    if (o.diff_report != standard_stream) {
        if (all.size() > 2) {
            std::cout << history_text(all, o.result_files) << "\n"
                      << shown(last) << " beside " << shown(last - 1) << ":\n";
        }
        std::cout << to_text(found);
    }
    return found.worse.empty() ? 0 : worse;
}

// Certified runs are a program of their own, built only when wanted. This returns only by an exception.
[[noreturn]] void hand_over_run(char** argv) {
#if COMPARE_HAS_MPFI
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::string program =
        std::filesystem::path(error ? argv[0] : self.string()).replace_filename("graze-compare-run");
    ::execv(program.c_str(), argv);
    throw input_error("run: " + program + ": " + std::strerror(errno) +
                      "; the target graze-compare-run builds it, as ./graze compare run does");
#else
    static_cast<void>(argv);
    throw input_error("run: this program has no certified runs");
#endif
}

void list_types() {
    text_table table;
    table.column("type", true);
    table.column("library", true);
    table.column("", true);
    std::size_t distinct = 0;
    for (const measurable& m : all_types()) {
        const type_information& t = m.information;
        distinct += t.alias_of.empty() ? 1 : 0;
        table.line({t.name, t.library, t.alias_of.empty() ? t.note : "another name of " + t.alias_of});
    }
    std::cout << table.text() << distinct << " distinct types\n";
    for (const missing_type& m : missing_types()) {
        std::cout << "not in this build: " << m.name << " (" << m.reason << ")\n";
    }
}

void list_families() {
    for (const family_description& f : family_list()) {
        std::cout << f.name << ": " << f.what_makes_it_hard;
        std::cout << (f.has_hardness ? " k: " + f.hardness_meaning + "\n" : "\n");
    }
}

int act(int argc, char** argv) {
    const options o = parse_options(argc, argv);
    switch (o.what) {
    case action::compare:
        return run_comparison(o);
    case action::diff:
        return run_diff(o);
    case action::run:
        hand_over_run(argv);
    case action::list_types:
        list_types();
        break;
    case action::list_families:
        list_families();
        break;
    case action::say:
        std::cout << o.said;
        break;
    }
    return 0;
}

} // namespace

} // namespace compare

int main(int argc, char** argv) {
    try {
        const int code = compare::act(argc, argv);
        std::cout.flush();
        if (!std::cout) {
            std::cerr << "graze-compare: the standard output cannot be written\n";
            return compare::failed;
        }
        return code;
    } catch (const std::exception& error) {
        std::cerr << "graze-compare: " << error.what() << "\n";
        return compare::failed;
    }
}
