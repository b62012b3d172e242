// graze-compare run: the program that graze-compare starts for this command.

#include "input_error.hpp"
#include "run/run_command.hpp"
#include "whole_file.hpp"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <exception>
#include <iostream>
#include <string>
#include <utility>

namespace compare {

namespace {

constexpr int incomplete = 1, failed = 2;

int act(int argc, char** argv) {
    std::string command = "graze-compare";
    for (int i = 1; i < argc; ++i) {
        command += std::string(" ") + argv[i];
    }
    CLI::App app("Proves the sequence of a scene's collisions.", "graze-compare");
    app.require_subcommand(1);
    run::raw_run_options raw;
    const CLI::App* running = run::add_run_command(app, raw);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << running->help(app.get_name());
        return 0;
    } catch (const CLI::ParseError& error) {
        throw input_error(one_line(error.what()));
    }
    const run::run_options o = run::checked(raw, *running);
    for (const auto& [option, path] :
         {std::pair("--json", o.json), std::pair("--picture", o.picture), std::pair("--paths", o.paths)}) {
        check_writable(option, path);
    }
    const progress_line line(::isatty(STDERR_FILENO) != 0);
    return run::run_scene(o, command, line) ? 0 : incomplete;
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
