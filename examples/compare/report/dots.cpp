#include "dots.hpp"

#include "../extremes.hpp"
#include "summary.hpp"
#include "text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace compare::report {
namespace {

using dots_json = nlohmann::ordered_json;

// Errors are in tenths of a bit. These numbers beyond the range stand for other cases; the script knows them.
constexpr int is_exact = -9999, is_infinite = 9999, is_wrong = 9998, is_open = 9997;

[[nodiscard]] dots_json dot_of(float error) {
    if (error == dot_absent || std::isnan(error)) {
        return nullptr;
    }
    if (error == dot_wrong || error == dot_open) {
        return error == dot_wrong ? is_wrong : is_open;
    }
    return error == 0          ? is_exact
           : std::isinf(error) ? is_infinite
                               : static_cast<int>(std::lround(10 * std::log2(static_cast<double>(error))));
}

// In hundredths of a decade.
[[nodiscard]] dots_json decades(double x) {
    return x > 0 && std::isfinite(x) ? dots_json(static_cast<int>(std::lround(100 * std::log10(x))))
                                     : dots_json(nullptr);
}

// The places of the pairs that are drawn, in order.
[[nodiscard]] std::vector<std::size_t> drawn(const results& found, const group_information& g, std::size_t most) {
    std::vector<std::size_t> all(g.places.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    if (all.size() <= most) {
        return all;
    }
    std::set<std::size_t> shown, kept;
    for (const pair_information& p : g.shown) {
        shown.insert(p.number);
    }
    for (const std::size_t i : all) {
        if (shown.contains(g.places[i].number)) {
            kept.insert(i);
        }
    }
    constexpr std::size_t worst = 50; // kept for each line
    for (const row& r : found.rows) {
        const auto lines = chosen_lines(found);
        if (r.group != g.name || std::ranges::none_of(lines, [&](const line& l) { return l.is(r); })) {
            continue;
        }
        std::vector<std::size_t> by_error = all;
        std::erase_if(by_error, [&](std::size_t i) { return i >= r.dots.size() || !(r.dots[i] > 0); });
        const auto end = by_error.begin() + static_cast<std::ptrdiff_t>(std::min(worst, by_error.size()));
        std::partial_sort(by_error.begin(), end, by_error.end(),
                          [&](std::size_t i, std::size_t j) { return r.dots[i] > r.dots[j]; });
        kept.insert(by_error.begin(), end);
    }
    const std::size_t left = most > kept.size() ? most - kept.size() : 1;
    const std::size_t step = (all.size() + left - 1) / left;
    for (std::size_t i = 0; i < all.size(); i += step) {
        kept.insert(i);
    }
    return {kept.begin(), kept.end()};
}

[[nodiscard]] dots_json group_data(const group_information& g, const std::vector<std::size_t>& places) {
    dots_json numbers = dots_json::array(), names = dots_json::array(), hardness = dots_json::array(),
              times = dots_json::array(), borders = dots_json::array();
    bool has_hardness = false;
    for (const std::size_t i : places) {
        const pair_place& p = g.places[i];
        numbers.push_back(p.number);
        names.push_back(p.name);
        hardness.push_back(p.hardness >= 0 ? dots_json(p.hardness) : dots_json(nullptr));
        has_hardness = has_hardness || p.hardness >= 0;
        times.push_back(p.time ? decades(*p.time) : dots_json(nullptr));
        borders.push_back(decades(p.border));
    }
    return {{"name", g.name},
            {"k", g.hardness_name},
            {"number", numbers},
            {"names", names},
            {"hardness", has_hardness ? hardness : dots_json(nullptr)},
            {"time", times},
            {"border", borders}};
}

} // namespace

std::string dots_data(const results& found, std::size_t most) {
    if (std::ranges::all_of(found.groups, [](const auto& g) { return g.places.empty(); })) {
        return {};
    }
    dots_json groups = dots_json::array(), lines = dots_json::array(), rows = dots_json::array(),
              pairs = dots_json::object();
    std::vector<std::vector<std::size_t>> places;
    for (const auto& g : found.groups) {
        places.push_back(drawn(found, g, most));
        groups.push_back(group_data(g, places.back()));
        for (const pair_information& p : g.shown) {
            pairs[std::to_string(p.number)] = {{"name", p.name},
                                               {"truth", p.encounter},
                                               {"time", p.time},
                                               {"border", p.border},
                                               {"scene", dots_json::parse(p.scene, nullptr, false)}};
        }
    }
    for (const line& l : chosen_lines(found)) {
        dots_json dots = dots_json::array();
        for (std::size_t g = 0; g < found.groups.size(); ++g) {
            dots_json of_group = dots_json::array();
            const auto r = std::ranges::find_if(
                found.rows, [&](const row& other) { return l.is(other) && other.group == found.groups[g].name; });
            for (const std::size_t i : places[g]) {
                of_group.push_back(r != found.rows.end() && i < r->dots.size() ? dot_of(r->dots[i])
                                                                               : dots_json(nullptr));
            }
            dots.push_back(std::move(of_group));
        }
        lines.push_back(
            {{"name", name_of(l.type, l.variant, l.root)}, {"colour", variable_of(l.colour)}, {"dots", dots}});
    }
    for (const row& r : found.rows) {
        dots_json worst = dots_json::array();
        for (const extreme_pair& e : r.extremes) {
            const bool is_error = e.which == "largest";
            worst.push_back({in_words(e), e.pair, is_error ? dots_json(readable(e.error)) : dots_json(nullptr), e.right,
                             e.said, is_error ? dot_of(static_cast<float>(e.error)) : dots_json(is_wrong)});
        }
        const auto group = std::ranges::find(found.groups, r.group, &group_information::name);
        rows.push_back({{"name", name_of(r.type, r.variant, r.root)},
                        {"group", group - found.groups.begin()},
                        {"form", " --types " + quoted(r.type) + " --variants " + r.variant + "/" + r.root},
                        {"worst", worst}});
    }
    const dots_json all = {{"command", found.program + found.inputs + " --pair "},
                           {"groups", groups},
                           {"lines", lines},
                           {"rows", rows},
                           {"pairs", pairs}};
    std::string text = all.dump(-1, ' ', false, dots_json::error_handler_t::replace), safe;
    for (const char c : text) { // escapes what could end the script
        safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    }
    return safe;
}

std::string dots_remark(const results& found, std::size_t most) {
    std::string text;
    for (const auto& g : found.groups) {
        if (g.places.size() > most) {
            text += (text.empty() ? "" : "; ") + g.name + ": " + readable_count(drawn(found, g, most).size()) + " of " +
                    readable_count(g.places.size());
        }
    }
    return text.empty() ? text
                        : "Not all pairs are drawn. " + text +
                              ". Those on which a row is wrong or at its worst are there, and the worst of each line; "
                              "the others "
                              "are every n-th.";
}

} // namespace compare::report
