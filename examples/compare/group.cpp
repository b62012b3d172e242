#include "group.hpp"

#include "statistics.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace compare {

namespace {

using stratum_key = std::tuple<pair_kind, graze::encounter>;

// Pair i of a stratum of n stands at (i + 1/2)/n of the whole.
std::vector<std::size_t> interleaved(const std::vector<truth>& truths) {
    std::map<stratum_key, std::size_t> sizes, seen;
    for (const truth& t : truths) {
        ++sizes[{t.kind, t.what}];
    }
    std::vector<double> place;
    place.reserve(truths.size());
    for (const truth& t : truths) {
        const stratum_key key{t.kind, t.what};
        place.push_back((static_cast<double>(seen[key]++) + 0.5) / static_cast<double>(sizes[key]));
    }
    std::vector<std::size_t> order(truths.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return place[i] < place[j]; });
    return order;
}

const char* key_of(pair_kind kind) {
    return kind == pair_kind::ball_ball ? "ball_ball" : kind == pair_kind::ball_plane ? "ball_plane" : "ball_wall";
}

struct condition_samples {
    std::size_t count = 0;
    std::vector<double> times, discriminants;
};

} // namespace

template <int N>
group make_group(group_information information, std::vector<problem<N>> problems, const progress_line& line) {
    std::vector<truth> truths;
    truths.reserve(problems.size());
    for (const problem<N>& pair : problems) {
        if (truths.size() % 64 == 0) {
            line.show("solving " + information.name + " exactly", truths.size(), problems.size());
        }
        truths.push_back(truth_of(pair));
    }
    information.dimension = N;
    information.pairs = problems.size();
    group_pairs<N> pairs;
    std::map<std::pair<pair_kind, int>, condition_samples> conditions;
    for (const std::size_t i : interleaved(truths)) {
        truth& t = truths[i];
        ++information.kinds[key_of(t.kind)];
        ++information.encounters[graze::to_string(t.what)];
        condition_samples& samples = conditions[{t.kind, problems[i].hardness}];
        ++samples.count;
        if (t.time_condition) {
            samples.times.push_back(*t.time_condition);
        }
        if (t.discriminant_condition) {
            samples.discriminants.push_back(*t.discriminant_condition);
        }
        pairs.problems.push_back(std::move(problems[i]));
        pairs.truths.push_back(std::move(t));
    }
    for (auto& [key, samples] : conditions) {
        conditioning written;
        written.kind = key_of(key.first);
        written.hardness = key.second;
        written.count = samples.count;
        if (!samples.times.empty()) {
            written.time_median = median(samples.times);
            written.time_largest = samples.times.back();
        }
        if (!samples.discriminants.empty()) {
            written.discriminant_median = median(samples.discriminants);
            written.discriminant_largest = samples.discriminants.back();
        }
        information.conditions.push_back(written);
    }
    return {std::move(information), std::move(pairs)};
}

template group make_group(group_information, std::vector<problem<2>>, const progress_line&);
template group make_group(group_information, std::vector<problem<3>>, const progress_line&);

} // namespace compare
