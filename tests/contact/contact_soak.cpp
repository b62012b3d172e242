// graze-contact-soak: many contacts of hard pairs, each component judged by exact arithmetic that shares no code.
#include "contact_soak.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <mutex>
#include <thread>

namespace contact_soak {
namespace {

constexpr std::size_t rows = 4 * soak::families_drawn.size();
constexpr std::uint64_t block_size = 64;

tally run_row(soak::drawn what, std::size_t row, std::uint64_t seed, std::uint64_t first, std::uint64_t count,
              std::vector<std::string>& complaints) {
    const std::size_t family = row / 4;
    switch (row % 4) {
    case 0:
        return run<2, double>(what, family, seed, first, count, complaints);
    case 1:
        return run<3, double>(what, family, seed, first, count, complaints);
    case 2:
        return run<2, float>(what, family, seed, first, count, complaints);
    default:
        return run<3, float>(what, family, seed, first, count, complaints);
    }
}

struct result {
    std::array<tally, rows> seen{};
    std::vector<std::string> complaints;
};

// `count` contacts for each row, in blocks. Each block draws its own random numbers, so the answer does not depend on
// the threads.
result run_all(soak::drawn what, std::uint64_t seed, std::uint64_t count, unsigned threads) {
    result total;
    std::mutex guard;
    std::atomic<std::uint64_t> next = 0;
    const std::uint64_t blocks = (count + block_size - 1) / block_size;
    const auto work = [&] {
        for (;;) {
            const std::uint64_t job = next.fetch_add(1);
            if (job >= blocks * rows) {
                break;
            }
            const std::size_t row = job % rows;
            const std::uint64_t block = job / rows;
            std::vector<std::string> complaints;
            const tally seen = run_row(what, row, seed, block * 16 * block_size,
                                       std::min(block_size, count - block * block_size), complaints);
            const std::lock_guard lock(guard);
            total.seen[row] += seen;
            total.complaints.insert(total.complaints.end(), complaints.begin(), complaints.end());
        }
    };
    std::vector<std::jthread> workers;
    for (unsigned i = 1; i < threads; ++i) {
        workers.emplace_back(work);
    }
    work();
    workers.clear();
    std::sort(total.complaints.begin(), total.complaints.end());
    return total;
}

void print_row(const char* name, const char* kind, const tally& t) {
    const auto number = [](std::uint64_t n) { return static_cast<std::uintmax_t>(n); };
    std::printf("| %s | %s | %ju | %ju | %ju | %ju | %ju | %ju |\n", name, kind, number(t.pairs), number(t.contacts),
                number(t.components), number(t.ties), number(t.exact), number(t.wrong));
}

tally print_table(const result& r) {
    std::puts("| family | of | pairs | contacts | components | ties | by integers | wrong |");
    std::puts("|---|---|--:|--:|--:|--:|--:|--:|");
    constexpr const char* kinds[4] = {"2D double", "3D double", "2D float", "3D float"};
    tally all;
    for (std::size_t row = 0; row < rows; ++row) {
        print_row(std::string(soak::families_drawn[row / 4].name).c_str(), kinds[row % 4], r.seen[row]);
        all += r.seen[row];
    }
    print_row("all", "", all);
    return all;
}

} // namespace
} // namespace contact_soak

int main(int argc, char** argv) {
    CLI::App app{"Draws contacts of every hard family, in the plane and in space, in doubles and floats, and judges "
                 "each component by the exact sign at the two boundaries of its rounding. Prints a table in Markdown; "
                 "ends with 1 if a component is wrong.\n\nThe whole soak: graze-contact-soak",
                 "graze-contact-soak"};
    std::uint64_t count = 6'000'000;
    std::uint64_t seed = 1;
    unsigned threads = 1;
    app.add_option("--count", count, "Contacts in all, about the same number of each family")->capture_default_str();
    app.add_option("--seed", seed, "The seed of the pairs")->capture_default_str();
    app.add_option("--threads", threads, "Threads; the answer does not depend on them")
        ->check(CLI::Range(1U, 1024U))
        ->capture_default_str();
    bool triangles = false;
    app.add_flag("--triangles", triangles, "Only the walls in space, as triangles");
    CLI11_PARSE(app, argc, argv);

    using namespace contact_soak;
    const result r =
        run_all(triangles ? soak::drawn::triangles : soak::drawn::all, seed, (count + rows - 1) / rows, threads);
    const tally all = print_table(r);
    const std::size_t shown = std::min<std::size_t>(r.complaints.size(), 100);
    for (std::size_t i = 0; i < shown; ++i) {
        std::printf("wrong: %s\n", r.complaints[i].c_str());
    }
    const bool enough = triangles || 2 * all.contacts >= count;
    if (!enough) {
        std::puts("\nfewer than half of the contacts asked for came about");
    }
    return all.wrong == 0 && enough ? 0 : 1;
}
