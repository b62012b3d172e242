// graze-soak: many hard pairs, decided by the library and by exact arithmetic that shares no code with it.
#include "soak.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <numeric>
#include <thread>

namespace soak {

tally& tally::operator+=(const tally& other) {
    pairs += other.pairs;
    exact += other.exact;
    hard += other.hard;
    wrong += other.wrong;
    for (std::size_t i = 0; i < encounters.size(); ++i) {
        encounters[i] += other.encounters[i];
    }
    orders += other.orders;
    exact_orders += other.exact_orders;
    ties += other.ties;
    wrong_orders += other.wrong_orders;
    return *this;
}

namespace {

constexpr std::uint64_t block_size = 64;

struct result {
    std::array<tallies, 2> seen{}; // in the plane, in space
    std::vector<std::string> complaints;

    void add(const result& other) {
        for (std::size_t d = 0; d < seen.size(); ++d) {
            for (std::size_t i = 0; i < families_drawn.size(); ++i) {
                seen[d][i] += other.seen[d][i];
            }
        }
        complaints.insert(complaints.end(), other.complaints.begin(), other.complaints.end());
    }
};

// Pairs 0 to count - 1 of every family, in the plane and in space. The answer does not depend on the threads.
result run(drawn what, std::uint64_t seed, std::uint64_t count, unsigned threads) {
    result total;
    std::mutex guard;
    std::atomic<std::uint64_t> next = 0;
    const auto work = [&] {
        result mine;
        for (;;) {
            const std::uint64_t first = next.fetch_add(block_size);
            if (first >= count) {
                break;
            }
            const std::uint64_t size = std::min(block_size, count - first);
            run_block<2>(what, seed, first, size, mine.seen[0], mine.complaints);
            run_block<3>(what, seed, first, size, mine.seen[1], mine.complaints);
        }
        const std::lock_guard lock(guard);
        total.add(mine);
    };
    std::vector<std::jthread> workers;
    for (unsigned i = 1; i < threads; ++i) {
        workers.emplace_back(work);
    }
    work();
    workers.clear();
    return total;
}

double percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void print_row(const char* name, const char* space, const tally& t) {
    std::printf("| %s | %s | %ju |", name, space, static_cast<std::uintmax_t>(t.pairs));
    for (const std::uint64_t n : t.encounters) {
        std::printf(" %.1f |", percent(n, t.pairs));
    }
    std::printf(" %.1f | %ju | %ju | %.1f | %.1f | %ju |\n", percent(t.exact, t.pairs),
                static_cast<std::uintmax_t>(t.wrong), static_cast<std::uintmax_t>(t.orders), percent(t.ties, t.orders),
                percent(t.exact_orders, t.orders), static_cast<std::uintmax_t>(t.wrong_orders));
}

tally print_table(const result& r) {
    std::puts("| family | in | pairs | overlap % | recede % | miss % | graze % | hit % | exact % | wrong | orders | "
              "ties % | exact % | wrong |");
    std::puts("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    tally all;
    for (std::size_t i = 0; i < families_drawn.size(); ++i) {
        for (std::size_t d = 0; d < r.seen.size(); ++d) {
            print_row(std::string(families_drawn[i].name).c_str(), d == 0 ? "2D" : "3D", r.seen[d][i]);
            all += r.seen[d][i];
        }
    }
    print_row("all", "", all);
    return all;
}

// Each encounter is at least 1% of all pairs, the filter leaves at least 30% open, and integers decide at least 5%.
bool promises_are_kept(const tally& all) {
    const std::uint64_t least = *std::min_element(all.encounters.begin(), all.encounters.end());
    const bool kept =
        percent(least, all.pairs) >= 1 && percent(all.hard, all.pairs) >= 30 && percent(all.exact, all.pairs) >= 5;
    if (!kept) {
        std::printf(
            "\nthe pairs are not hard enough: each encounter should be 1%% of them, 30%% beyond the filter, 5%% "
            "decided by integers\n");
    }
    return kept;
}

} // namespace
} // namespace soak

int main(int argc, char** argv) {
    CLI::App app{"Decides pairs of every hard family, in the plane and in space, and orders their times; compares each "
                 "answer with exact arithmetic in GMP integers. Prints a table in Markdown; ends with 1 if an answer "
                 "is wrong.\n\nThe whole soak: graze-soak",
                 "graze-soak"};
    std::uint64_t count = 10'200'000;
    std::uint64_t seed = 1;
    unsigned threads = 1;
    app.add_option("--count", count, "Pairs in all, the same number of each family")->capture_default_str();
    app.add_option("--seed", seed, "The seed of the pairs")->capture_default_str();
    app.add_option("--threads", threads, "Threads; the answer does not depend on them")
        ->check(CLI::Range(1U, 1024U))
        ->capture_default_str();
    bool triangles = false;
    app.add_flag("--triangles", triangles, "Only the walls in space, as triangles");
    CLI11_PARSE(app, argc, argv);

    const std::uint64_t rows = 2 * soak::families_drawn.size();
    const soak::result r =
        soak::run(triangles ? soak::drawn::triangles : soak::drawn::all, seed, (count + rows - 1) / rows, threads);
    const soak::tally all = soak::print_table(r);
    const std::size_t shown = std::min<std::size_t>(r.complaints.size(), 100);
    for (std::size_t i = 0; i < shown; ++i) {
        std::printf("wrong: %s\n", r.complaints[i].c_str());
    }
    return (triangles || soak::promises_are_kept(all)) && all.wrong == 0 && all.wrong_orders == 0 ? 0 : 1;
}
