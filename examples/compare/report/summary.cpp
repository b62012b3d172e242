#include "summary.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace compare::report {
namespace {

// The worse of two rows' times joins the candidate.
void take_errors(candidate& c, const error_statistics& e) {
    if (e.count == 0) {
        return;
    }
    c.times += e.count;
    const bool no_number = e.not_finite != 0 || e.unscaled != 0;
    c.fewest_bits = std::min(c.fewest_bits, no_number ? -std::numeric_limits<double>::infinity() : e.fewest_bits);
    c.median_bits = std::min(c.median_bits, e.median_bits);
}

void mark_front(std::vector<candidate>& all) {
    const bool some_right = std::ranges::any_of(all, &candidate::decides_right);
    const auto plays = [&](const candidate& c) {
        return c.nanoseconds && c.times != 0 && (c.decides_right() || !some_right);
    };
    for (auto& c : all) {
        c.on_front = plays(c) && std::ranges::none_of(all, [&](const candidate& other) {
                         return plays(other) && *other.nanoseconds <= *c.nanoseconds &&
                                other.fewest_bits >= c.fewest_bits &&
                                (*other.nanoseconds < *c.nanoseconds || other.fewest_bits > c.fewest_bits);
                     });
    }
}

} // namespace

std::string name_of(const std::string& type, const std::string& variant, const std::string& root) {
    return type + " · " + variant + (root == "printed" ? ", root as printed" : "");
}

std::string candidate::name() const { return name_of(type, variant, root); }

const type_information* information_of(const results& found, const std::string& type) {
    const auto at = std::ranges::find(found.types, type, &type_information::name);
    return at == found.types.end() ? nullptr : &*at;
}

std::vector<candidate> candidates(const results& found, const std::vector<std::string>& groups) {
    std::vector<candidate> all;
    std::vector<std::pair<double, double>> weighted; // nanoseconds × pairs, pairs
    for (const auto& r : found.rows) {
        if (!groups.empty() && std::ranges::find(groups, r.group) == groups.end()) {
            continue;
        }
        auto at = std::ranges::find_if(all, [&](const candidate& c) {
            return std::tie(c.type, c.variant, c.root) == std::tie(r.type, r.variant, r.root);
        });
        if (at == all.end()) {
            at = all.emplace(all.end());
            at->type = r.type, at->variant = r.variant, at->root = r.root;
            at->information = information_of(found, r.type);
            weighted.emplace_back();
        }
        at->evaluated += r.decisions.evaluated;
        at->wrong += r.decisions.wrong();
        at->undecided += r.decisions.undecided;
        take_errors(*at, r.error(quantity::time));
        take_errors(*at, r.error(quantity::crossing));
        if (r.nanoseconds) {
            auto& [sum, pairs] = weighted[static_cast<std::size_t>(at - all.begin())];
            const auto n = static_cast<double>(std::max<std::size_t>(r.decisions.evaluated, 1));
            sum += *r.nanoseconds * n;
            pairs += n;
            at->nanoseconds = sum / pairs;
        }
    }
    mark_front(all);
    return all;
}

bool is_plain_double(const std::string& type, const std::string& variant, const std::string& root) {
    return type == "double" && variant == "textbook" && root == "printed";
}

std::vector<line> chosen_lines(const results& found) {
    static constexpr std::size_t most = 7;
    static constexpr std::array inks = {ink::one, ink::two, ink::three, ink::four, ink::five, ink::six, ink::seven};
    std::vector<line> lines;
    const auto add = [&](const std::string& type, const std::string& variant, const std::string& root) {
        const auto* t = information_of(found, type);
        const bool there = std::ranges::any_of(
            found.rows, [&](const row& r) { return r.type == type && r.variant == variant && r.root == root; });
        const bool drawn = std::ranges::any_of(
            lines, [&](const line& l) { return l.type == type && l.variant == variant && l.root == root; });
        if (there && !drawn && t != nullptr && t->digits > 0 && !t->is_interval && lines.size() < most) {
            lines.push_back({type, variant, root, t->digits, inks[lines.size()], root == "printed"});
            return true;
        }
        return false;
    };
    add("double", "textbook", "printed");
    add("double", "halved", "stable");
    std::vector<const type_information*> types;
    for (const auto& t : found.types) {
        types.push_back(&t);
    }
    std::ranges::stable_sort(types, {}, [](const type_information* t) { return t->digits; });
    for (const auto* t : types) {
        if (!t->is_exact && t->alias_of.empty()) {
            static_cast<void>(add(t->name, "lagrange", "stable") || add(t->name, "halved", "stable") ||
                              add(t->name, "textbook", "stable") || add(t->name, "textbook", "printed"));
        }
    }
    return lines;
}

} // namespace compare::report
