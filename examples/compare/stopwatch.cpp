#include "stopwatch.hpp"

#include <algorithm>
#include <utility>

namespace compare {

namespace {

constexpr std::size_t most_pairs = 256, fewest_pairs = 24, most_repeats = 15, fewest_repeats = 3;

struct schedule {
    std::size_t pairs = 0, passes = 1;
    std::vector<double> nanoseconds;
};

} // namespace

std::vector<timing> time_interleaved(const std::vector<timed_candidate>& candidates, double seconds) {
    std::vector<schedule> schedules;
    double round_seconds = 0;
    for (const timed_candidate& c : candidates) {
        schedule s;
        const std::size_t trial = std::min(c.available, fewest_pairs);
        c.run(trial); // the first run warms caches and allocators
        const stopwatch watch;
        c.run(trial);
        const double each = std::max(watch.seconds() / static_cast<double>(std::max<std::size_t>(trial, 1)), 1e-9);
        const double share = seconds / static_cast<double>(candidates.size() * most_repeats);
        const auto affordable = static_cast<std::size_t>(share / each);
        s.pairs = std::min(c.available, std::clamp(affordable, fewest_pairs, most_pairs));
        const double pass = each * static_cast<double>(std::max<std::size_t>(s.pairs, 1));
        s.passes = std::max<std::size_t>(1, static_cast<std::size_t>(share / pass));
        round_seconds += pass * static_cast<double>(s.passes);
        schedules.push_back(std::move(s));
    }
    const auto affordable = static_cast<std::size_t>(patience * seconds / std::max(round_seconds, 1e-9));
    const std::size_t repeats = std::clamp(affordable, fewest_repeats, most_repeats);
    for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            schedule& s = schedules[i];
            const stopwatch watch;
            for (std::size_t pass = 0; pass < s.passes; ++pass) {
                candidates[i].run(s.pairs);
            }
            const auto solved = static_cast<double>(std::max<std::size_t>(s.passes * s.pairs, 1));
            s.nanoseconds.push_back(watch.seconds() * 1e9 / solved);
        }
    }
    std::vector<timing> result;
    for (schedule& s : schedules) {
        std::vector<double> sorted = s.nanoseconds;
        std::sort(sorted.begin(), sorted.end());
        const auto at = [&](std::size_t quarter) { return sorted[(sorted.size() - 1) * quarter / 4]; };
        result.push_back({at(2), at(1), at(3), s.pairs, std::move(s.nanoseconds)});
    }
    return result;
}

} // namespace compare
