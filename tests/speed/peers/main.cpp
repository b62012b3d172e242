// graze-peers: graze, plain doubles and alternative libraries, on the same inputs in one run.
#include "book.hpp"
#include "measure.hpp"
#include "sections.hpp"
#include "trials.hpp"

#include <json_results.hpp>
#include <whole_file.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>

namespace {

// Whether graze, the first entry, kept its promise: no decision wrong, every time correctly rounded.
bool keeps_promise(const peers::section& s) {
    for (const auto& scores : s.scores) {
        const peers::score& own = scores.front().value();
        for (const compare::error_statistics& e : own.row.errors) {
            if (e.count != e.correctly_rounded) {
                return false;
            }
        }
        if (own.missed + own.invented != 0) {
            return false;
        }
    }
    return true;
}

int run(int argc, char** argv) {
    CLI::App app{"Asks graze, plain doubles and the continuous collision of FCL, Bullet and Box2D (those that this "
                 "build has) whether and when balls touch balls, boxes and edges. Every answer is held against exact "
                 "arithmetic. Prints tables in Markdown; ends with 1 if graze is wrong.",
                 "graze-peers"};
    std::size_t count = 2000;
    std::uint64_t seed = 1;
    double timing = 0.5;
    bool every = false;
    std::string json, book;
    std::vector<std::string> chapters;
    app.add_option("--count", count, "Questions of each trial")->check(CLI::Range(1, 100'000))->capture_default_str();
    app.add_option("--seed", seed, "The seed of the questions")->capture_default_str();
    app.add_option("--timing", timing, "Seconds to spend on the times of a trial; 0: nothing is timed")
        ->check(CLI::Range(0.0, 3600.0))
        ->capture_default_str();
    app.add_flag("--every", every, "Every variant in every number type of the machine, not double's first and last");
    app.add_option("--json", json, "Write the results to FILE-balls-2d.json and so on, which graze-compare reads");
    app.add_option("--book", book, "Write the picture book to this folder: index.html, and every picture as SVG");
    app.add_option("--with", chapters, "Results of graze-compare (--json) to put into the book first")
        ->check(CLI::ExistingFile);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    std::vector<peers::chapter> all;
    bool kept = true;
    for (const std::string& path : chapters) {
        all.push_back({std::filesystem::path(path).stem().string(), compare::read_results(path)});
    }

    std::vector<std::string> missing;
    const std::vector<peers::entry> entries = peers::all_entries(every, missing);
    std::fputs(peers::description_of(entries, missing, count, seed).c_str(), stdout);
    std::string command = "graze-peers";
    for (int i = 1; i < argc; ++i) {
        command += ' ' + std::string(argv[i]);
    }
    for (const peers::section& s : peers::measure_sections(entries, seed, count, timing)) {
        std::fputs(peers::table_of(s, entries).c_str(), stdout);
        const compare::results found = peers::results_of(s, entries, command, seed);
        if (!json.empty()) {
            compare::write_whole_file(json + '-' + s.file_name + ".json", compare::to_json(found));
        }
        all.push_back({s.file_name, found});
        if (!keeps_promise(s)) {
            std::fprintf(stderr, "graze-peers: graze is wrong on %s\n", s.name.c_str());
            kept = false;
        }
    }
    const auto rates = peers::fallback_rates(seed, count);
    std::fputs(peers::table_of(rates).c_str(), stdout);
    if (!book.empty()) {
        peers::write_book(book, all, rates, command);
    }
    return kept ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "graze-peers: %s\n", e.what());
        return 2;
    }
}
