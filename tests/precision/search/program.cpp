// The command line of a search.
#include "program.hpp"

#include "run.hpp"

#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdio>
#include <exception>

namespace search {

namespace {

std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free); // so that a signal handler may set it

void on_signal(int) { stop_asked = true; }

struct options {
    terms of;
    std::string out = "found.txt", shard = "0/1";
    std::uint64_t tries = 100, climbs = 1;
    std::optional<std::uint64_t> attempt;
    std::string merged_into;
    std::vector<std::string> merged_from;
};

void split_shard(options& o) {
    const auto slash = o.shard.find('/');
    try {
        std::size_t used = 0, used_after = 0;
        const std::string before = o.shard.substr(0, slash),
                          after = o.shard.substr(std::min(slash, o.shard.size() - 1) + 1);
        o.of.shard = std::stoull(before, &used);
        o.of.shards = std::stoull(after, &used_after);
        if (used == before.size() && used_after == after.size() && o.of.shard < o.of.shards && before[0] != '-') {
            return;
        }
    } catch (const std::logic_error&) { // reported below
    }
    throw std::invalid_argument("--shard " + o.shard + ": i/n with 0 <= i < n expected");
}

// Of the words of an option.
CLI::Validator whole_from(std::uint64_t least) {
    return {[least](std::string& word) -> std::string {
                const bool is_whole = !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
                if (is_whole && word.size() < 20 && std::stoull(word) >= least) {
                    return {};
                }
                return "\"" + word + "\" is not a whole number" + (least > 0 ? " above 0" : "");
            },
            ""};
}

int make_one_try(const options& o, const goal& g) {
    const auto f = repeat(g, families_of(o.of), o.of, *o.attempt, o.climbs, &stop_asked);
    if (!f || !g.is_found(f->score)) {
        std::puts("nothing found");
        return 1;
    }
    std::printf("# %s%s\n# origin: %s --try %ju --climbs %ju\n%s\n", g.tell(f->score).c_str(),
                f->climbing ? ", still climbing" : ", no changed bit is worse", command_of(o.of).c_str(),
                static_cast<std::uintmax_t>(*o.attempt), static_cast<std::uintmax_t>(o.climbs), f->lines().c_str());
    return 0;
}

std::string shard_of(const terms& t) { return " --shard " + std::to_string(t.shard) + "/" + std::to_string(t.shards); }

void check_in(const std::string& path, const kept_file& file, const goal& g) {
    try {
        check(file, g);
    } catch (const std::runtime_error& e) {
        throw std::runtime_error(path + ": " + e.what());
    }
}

int search_on(const options& o, const goal& g) {
    const auto families = families_of(o.of);
    kept_file file;
    file.of = o.of;
    if (std::filesystem::is_directory(o.out)) {
        throw std::runtime_error(o.out + ": is a folder");
    }
    const file_lock alone(o.out);
    if (std::filesystem::exists(o.out)) {
        file = read_kept(o.out);
        file.of.program = o.of.program;
        const bool is_shard = file.of.shard == o.of.shard && file.of.shards == o.of.shards;
        if (file.merged || !is_shard || !same_search(file.of, o.of)) {
            throw std::runtime_error(o.out + ": holds what \"" + command_of(file.of) + "\"" +
                                     (file.merged ? ", merged," : shard_of(file.of)) +
                                     " found; another --out is needed");
        }
        check_in(o.out, file, g);
    }
    write(o.out, file, g); // before any work that could then not be saved
    plan p;
    p.tries = o.tries;
    p.stop = &stop_asked;
    p.saved = [&](const kept_file& f) { write(o.out, f, g); };
    p.told = [](const std::string& line) {
        std::puts(line.c_str());
        std::fflush(stdout);
    };
    const bool done = go_on(file, g, families, p);
    write(o.out, file, g);
    if (!done) {
        std::printf("stopped before try %ju of %ju; the same command goes on from %s\n",
                    static_cast<std::uintmax_t>(file.next), static_cast<std::uintmax_t>(o.tries), o.out.c_str());
        return 3;
    }
    if (file.pairs.empty()) {
        std::puts("nothing found");
        return 1;
    }
    const auto climbing = std::ranges::count_if(file.pairs, [](const kept_pair& k) { return k.at.climbing; });
    std::printf("%zu kept in %s, the first: %s\n", file.pairs.size(), o.out.c_str(),
                g.tell(file.pairs.front().at.score).c_str());
    if (climbing != 0) {
        std::printf("still climbing: %ju of them; the same command climbs on\n", static_cast<std::uintmax_t>(climbing));
    }
    return 0;
}

int merge(const options& o, const graze::precision::subjects& formulas) {
    std::vector<kept_file> files;
    for (const std::string& path : o.merged_from) {
        files.push_back(read_kept(path));
        files.back().of.program = o.of.program;
    }
    const kept_file all = merged(files);
    const goal g = goal_of(all.of, formulas);
    for (std::size_t i = 0; i < files.size(); ++i) {
        check_in(o.merged_from[i], files[i], g);
    }
    if (std::filesystem::exists(o.merged_into)) {
        kept_file before = read_kept(o.merged_into);
        before.of.program = o.of.program;
        if (!before.merged || !same_search(before.of, all.of)) {
            throw std::runtime_error(o.merged_into + ": is to be written, but holds what \"" + command_of(before.of) +
                                     (before.merged ? "\", merged," : shard_of(before.of) + "\"") + " found");
        }
    }
    write(o.merged_into, all, g);
    std::printf("%zu %s of %zu files kept in %s\n", all.pairs.size(), all.pairs.size() == 1 ? "pair" : "pairs",
                files.size(), o.merged_into.c_str());
    return 0;
}

int chosen(const CLI::App& merging, options& o, const graze::precision::subjects& formulas) {
    if (merging.parsed()) {
        return merge(o, formulas);
    }
    if (o.of.figure.empty()) {
        throw std::invalid_argument("--figure is missing (see --help)");
    }
    split_shard(o);
    const goal g = goal_of(o.of, formulas);
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    return o.attempt ? make_one_try(o, g) : search_on(o, g);
}

} // namespace

int run(int argc, char** argv, const graze::precision::subjects& formulas, const std::string& name) {
    CLI::App app{
        "Searches for pairs that are worse for a formula than random ones. From many starts, it halves the ranges of "
        "the inputs and keeps the worse half, then changes single bits as long as that makes the pair worse, then "
        "makes the numbers simpler. The precision suite reads the file of what it finds. After SIGINT, SIGTERM or its "
        "last try, the same command goes on.",
        name};
    options o;
    o.of.goal = "error";
    o.of.program = name;
    app.add_option("--goal", o.of.goal,
                   "error: the largest error; nearest, farthest: the wrong decision nearest to the border, or farthest "
                   "from it; fallback: the most basic blocks executed")
        ->capture_default_str();
    app.add_option("--figure", o.of.figure, "The figure, quantity/variant/type, such as time/lagrange.stable/double");
    app.add_option("--families", o.of.families, "Start from these families, separated by commas (all)")->delimiter(',');
    app.add_option("--lengths", o.of.lengths,
                   "The least and the greatest magnitude of lengths that are not 0, such as 1e-3:1e3 (any)");
    app.add_option("--velocities", o.of.velocities, "The same of velocities");
    app.add_option("--masses", o.of.masses, "The same of masses");
    app.add_option("--seed", o.of.seed, "The seed of the tries")->check(whole_from(0))->capture_default_str();
    app.add_option("--evaluations", o.of.evaluations, "Evaluations of one try")
        ->check(whole_from(1))
        ->capture_default_str();
    auto* const tries = app.add_option("--tries", o.tries, "The number of tries, of all shards together")
                            ->check(whole_from(1))
                            ->capture_default_str();
    auto* const shard =
        app.add_option("--shard", o.shard, "i/n: make every n-th try, from the i-th on; merge joins the files")
            ->capture_default_str();
    auto* const out =
        app.add_option("--out", o.out, "Keep what is found in this file, and go on from it")->capture_default_str();
    auto* const attempt =
        app.add_option("--try", o.attempt, "Make only this try and print it, as an origin's command does")
            ->check(whole_from(0))
            ->excludes(tries)
            ->excludes(shard)
            ->excludes(out);
    app.add_option("--climbs", o.climbs, "With --try: how often the try gets --evaluations")
        ->needs(attempt)
        ->check(whole_from(1))
        ->capture_default_str();
    CLI::App* const merging = app.add_subcommand("merge", "Keep the worst pairs of several files in one");
    merging->add_option("out", o.merged_into, "The file to write: a new one, or an earlier merge")->required();
    merging->add_option("in", o.merged_from, "The files of one search's shards")->required();
    try {
        app.parse(argc, argv);
        const bool has_options = std::ranges::any_of(app.get_options(), [](const auto* x) { return x->count() != 0; });
        if (merging->parsed() && has_options) {
            throw std::invalid_argument("merge: takes files and no options");
        }
        return chosen(*merging, o, formulas);
    } catch (const CLI::Success& asked) { // help was asked for
        return app.exit(asked);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), e.what());
        return 2;
    }
}

} // namespace search
