// graze-compare: what each number type costs and loses on the collisions of a scene.

#include "answer.hpp"
#include "diff.hpp"
#include "families.hpp"
#include "input_error.hpp"
#include "inputs.hpp"
#include "json_results.hpp"
#include "machine.hpp"
#include "options.hpp"
#include "report.hpp"
#include "run.hpp"
#if COMPARE_HAS_MPFI
#include "run/run_command.hpp"
#endif
#include "stopwatch.hpp"
#include "table.hpp"
#include "text_table.hpp"
#include "whole_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>

namespace compare {

namespace {

constexpr int worse = 1, incomplete = 1, failed = 2;

// In the order of the list, each once; another name stands for what it names.
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

// Throws if a file cannot be written, before hours of measuring.
void check_writable(const std::string& option, const std::string& path) {
    namespace fs = std::filesystem;
    if (path.empty()) {
        return;
    }
    std::error_code error;
    if (fs::is_directory(path, error)) {
        throw input_error(option + " " + printable(path, 200) + ": is a directory");
    }
    if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
        if (::access(path.c_str(), W_OK) != 0) {
            throw input_error(option + " " + printable(path, 200) + ": cannot be written");
        }
        return;
    }
    const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
    const fs::path folder = error ? fs::path() : real.parent_path();
    if (!fs::is_directory(folder, error)) {
        throw input_error(option + " " + printable(path, 200) + ": no such directory");
    }
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        throw input_error(option + " " + printable(path, 200) + ": the directory cannot be written to");
    }
}

void check_outputs(const options& o) {
    namespace fs = std::filesystem;
    const std::array<std::pair<std::string, std::string>, 4> files = {
        {{"the scene", o.scene}, {"--json", o.json}, {"--report", o.report}, {"--picture", o.picture}}};
    for (auto one = files.begin() + 1; one != files.end(); ++one) {
        check_writable(one->first, one->second);
        for (auto earlier = files.begin(); earlier != one; ++earlier) {
            std::error_code error;
            if (!one->second.empty() && !earlier->second.empty() &&
                fs::weakly_canonical(fs::absolute(earlier->second), error) ==
                    fs::weakly_canonical(fs::absolute(one->second), error)) {
                throw input_error(earlier->first + " and " + one->first + ": the same file");
            }
        }
    }
}

int run_comparison(const options& o) {
    check_outputs(o);
    const stopwatch watch;
    const progress_line line(::isatty(STDERR_FILENO) != 0);
    results found;
    const std::vector<measurable> types = types_of(o);
    const std::vector<group> groups = groups_of(o, line);
    found.command = o.command;
    found.machine = this_machine();
    found.source = !o.family.empty() ? "family " + o.family : !o.scene.empty() ? o.scene : "default";
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
    measure_all(found, types, groups, plan, line);
    line.show("");
    draw_conclusions(found);
    found.seconds = watch.seconds();
    if (!o.json.empty()) {
        write_whole_file(o.json, to_json(found));
    }
    if (!o.report.empty()) {
        write_report(found, o.report);
    }
    std::cout << to_text(found, o.table);
    if (!o.picture.empty()) { // last: without gnuplot this one fails
        write_picture(found, o.picture);
    }
    return 0;
}

int run_diff(const options& o) {
    const difference found = compare_results(read_results(o.old_results), read_results(o.new_results));
    if (found.compared == 0) {
        throw input_error(o.new_results + ": no row in common with " + o.old_results);
    }
    std::cout << to_text(found);
    return found.worse.empty() ? 0 : worse;
}

int run_run(const options& o) {
#if COMPARE_HAS_MPFI
    for (const auto& [option, path] :
         {std::pair("--json", o.run_of_scene.json), std::pair("--picture", o.run_of_scene.picture),
          std::pair("--paths", o.run_of_scene.paths)}) {
        check_writable(option, path);
    }
    const progress_line line(::isatty(STDERR_FILENO) != 0);
    return run::run_scene(o.run_of_scene, o.command, line) ? 0 : incomplete;
#else
    throw input_error("run: " + printable(o.run_of_scene.scene) +
                      ": this build has no certified runs, libmpfi was not found");
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

int act(int argc, const char* const* argv) {
    const options o = parse_options(argc, argv);
    switch (o.what) {
    case action::compare:
        return run_comparison(o);
    case action::diff:
        return run_diff(o);
    case action::run:
        return run_run(o);
    case action::list_types:
        list_types();
        break;
    case action::list_families:
        list_families();
        break;
    case action::help:
        std::cout << o.help;
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
