#include "figures.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>
#include <tuple>

namespace search {

namespace {

using graze::precision::subject;
using precision::quantity;

constexpr std::size_t starts_a_family = 400;

struct told {
    std::set<quantity> of;
    bool decides = false;
};

// What a formula answers to these pairs.
told asked_of(const subject& s, const std::vector<precision::family>& families) {
    told all;
    const auto ask = [&](const auto& p) {
        try {
            const auto held = precision::held(p, s.type);
            const auto given = held ? s(*held) : std::nullopt;
            if (given && given->what) {
                all.of.insert(quantity::encounter);
                all.decides = true;
            }
            for (const auto& v : given ? given->values : std::vector<graze::precision::value>{}) {
                all.of.insert(v.of);
            }
            // It decides, too, if it is about times and gives none: there is no collision.
            all.decides = all.decides || (given && given->values.empty() && s.measures == quantity::time);
        } catch (const std::exception&) { // the formula is not about this pair
        }
    };
    for (const auto& f : families) {
        for (const any_pair& p : f.pairs) {
            std::visit(ask, p);
        }
    }
    return all;
}

std::size_t letters_between(const std::string& x, const std::string& y) {
    std::vector<std::size_t> costs(y.size() + 1);
    std::iota(costs.begin(), costs.end(), std::size_t{0});
    for (const char letter : x) {
        std::size_t diagonal = costs[0]++;
        for (std::size_t j = 0; j < y.size(); ++j) {
            const std::size_t changed = diagonal + (letter == y[j] ? 0 : 1);
            diagonal = costs[j + 1];
            costs[j + 1] = std::min({changed, costs[j] + 1, costs[j + 1] + 1});
        }
    }
    return costs.back();
}

} // namespace

std::string nearest_to(const std::string& word, const std::vector<std::string>& names) {
    constexpr std::size_t few = 4;
    std::vector<std::pair<std::size_t, std::string>> sorted;
    for (const std::string& name : names) {
        sorted.emplace_back(letters_between(word, name), name);
    }
    std::ranges::sort(sorted);
    std::string text;
    for (std::size_t i = 0; i < std::min(few, sorted.size()); ++i) {
        text += (i == 0 ? "" : ", ") + sorted[i].second;
    }
    return text;
}

std::vector<figure> figures_of(const graze::precision::subjects& formulas) {
    constexpr std::size_t few = 8;
    const auto families = precision::drawn_families(few, 1);
    std::vector<figure> all;
    for (const auto& s : formulas) {
        told t = asked_of(*s, families);
        if (s->measures == quantity::order) {
            t = {{quantity::order}, true};
        }
        for (const quantity q : t.of) {
            const std::string name = std::string(to_string(q)) + "/" + s->variant + "/" + s->type.name;
            auto known = std::ranges::find(all, name, &figure::name);
            if (known == all.end()) {
                known = all.insert(all.end(), {name, q, {}, false});
            }
            known->formulas.push_back(s.get());
            known->decides =
                known->decides || (t.decides && (q == quantity::encounter || !t.of.contains(quantity::encounter)));
        }
    }
    return all;
}

goal goal_of(const terms& t, const graze::precision::subjects& formulas) {
    const aim what = aim_from(t.goal);
    magnitudes within;
    for (const auto& [option, text, range] : {std::tuple("--lengths", &t.lengths, &within.lengths),
                                              std::tuple("--velocities", &t.velocities, &within.velocities),
                                              std::tuple("--masses", &t.masses, &within.masses)}) {
        *range = text->empty() ? magnitudes::range{} : range_from(option, *text);
    }
    const auto fits = [&](const figure& f) {
        // No borders for a decimal type, whose numbers no pair of doubles holds.
        const bool is_binary = f.formulas.front()->type.decimal_digits == 0;
        const bool is_decision = f.of == quantity::encounter || f.of == quantity::order;
        return what == aim::error      ? !is_decision
               : what == aim::fallback ? f.of != quantity::order // the work is that for one pair
                                       : f.decides && is_binary;
    };
    std::vector<std::string> fitting;
    const std::vector<figure> all = figures_of(formulas);
    for (const figure& f : all) {
        if (f.name == t.figure && fits(f)) {
            return {what, f.of, f.formulas, within};
        }
        if (fits(f)) {
            fitting.push_back(f.name);
        }
    }
    const bool is_known = std::ranges::find(all, t.figure, &figure::name) != all.end();
    const char* const lack = what == aim::error ? " has no numbers" : " is about no decisions in binary numbers";
    throw std::invalid_argument(
        (is_known ? "the figure " + t.figure + lack : "there is no figure \"" + t.figure + "\"") +
        (fitting.empty() ? ", and none that is for the goal " + t.goal
                         : "; the nearest for the goal " + t.goal + ": " + nearest_to(t.figure, fitting)));
}

std::vector<precision::family> families_of(const terms& t) {
    std::vector<precision::family> all = precision::drawn_families(starts_a_family, t.seed);
    if (t.families.empty()) {
        return all;
    }
    all.push_back(precision::drawn_triangles(starts_a_family, t.seed));
    std::vector<std::string> known;
    std::ranges::transform(all, std::back_inserter(known), &precision::family::name);
    for (const std::string& name : t.families) {
        if (std::ranges::count(known, name) == 0) {
            throw std::invalid_argument("there is no family \"" + name + "\"; the nearest: " + nearest_to(name, known));
        }
    }
    std::erase_if(all, [&](const precision::family& f) { return std::ranges::count(t.families, f.name) == 0; });
    return all;
}

} // namespace search
