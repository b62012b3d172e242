#include "group.hpp"

#include "scene_writer.hpp"
#include "statistics.hpp"
#include "told.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace compare {

namespace {

using stratum_key = std::tuple<pair_kind, graze::encounter>;

// Pair i of the n of its kind and encounter stands at (i + 1/2)/n of the whole.
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
        const bool has_time = graze::is_collision(t.what) && t.what != graze::encounter::overlap;
        information.places.push_back({problems[i].number, problems[i].name, problems[i].hardness,
                                      has_time ? std::optional(t.time.nearest()) : std::nullopt,
                                      nearest_border(t.what, t.borders)});
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

std::optional<pair_information> pair_of(const group& of, std::size_t number) {
    return std::visit(
        [&]<int N>(const group_pairs<N>& pairs) -> std::optional<pair_information> {
            const auto at = std::find_if(pairs.problems.begin(), pairs.problems.end(),
                                         [&](const auto& p) { return p.number == number; });
            if (at == pairs.problems.end()) {
                return std::nullopt;
            }
            const truth& right = pairs.truths[static_cast<std::size_t>(at - pairs.problems.begin())];
            pair_information result;
            result.number = number;
            result.name = at->name;
            result.kind = key_of(at->kind);
            result.hardness = at->hardness;
            result.encounter = told_decision(right);
            const bool has_time = graze::is_collision(right.what) && right.what != graze::encounter::overlap;
            result.time = has_time ? told_number(right.time) : "";
            result.border = nearest_border(right.what, right.borders);
            result.numbers = numbers_of_pair(*at);
            result.scene = scene_of_pair(*at, of.information.name + ", " + at->name);
            return result;
        },
        of.pairs);
}

std::string lines_of_pairs(const std::vector<group>& groups, const std::string& command) {
    std::string text;
    for (const group& g : groups) {
        std::visit(
            [&](const auto& pairs) {
                for (const auto& p : pairs.problems) {
                    text +=
                        "# origin: " + command + " --pair " + std::to_string(p.number) + "\n" + line_of_pair(p) + "\n";
                }
            },
            g.pairs);
    }
    return text;
}

void show_extremes(results& found, const std::vector<group>& groups) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
        std::set<std::size_t> numbers;
        if (groups[i].information.places.size() == 1) { // asked for by --pair, right or wrong
            numbers.insert(groups[i].information.places.front().number);
        }
        for (const row& r : found.rows) {
            for (const extreme_pair& e : r.extremes) {
                if (r.group == groups[i].information.name) {
                    numbers.insert(e.pair);
                }
            }
        }
        for (const std::size_t number : numbers) {
            if (auto shown = pair_of(groups[i], number)) {
                found.groups[i].shown.push_back(std::move(*shown));
            }
        }
    }
}

template group make_group(group_information, std::vector<problem<2>>, const progress_line&);
template group make_group(group_information, std::vector<problem<3>>, const progress_line&);

} // namespace compare
