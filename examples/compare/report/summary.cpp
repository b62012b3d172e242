#include "summary.hpp"

#include "../answer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace compare::report {
namespace {

// The results of one group.
[[nodiscard]] results only(const results& found, const std::string& group) {
    results one = found;
    std::erase_if(one.groups, [&](const group_information& g) { return g.name != group; });
    std::erase_if(one.rows, [&](const row& r) { return r.group != group; });
    return one;
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
    if (variant.empty()) {
        return type;
    }
    return type + " · " + variant + (root == "printed" ? "/printed" : "");
}

std::string candidate::name() const { return name_of(type, variant, root); }

std::string short_name_of(const std::string& type) {
    const auto scope = type.rfind("::");
    return scope == std::string::npos ? type : type.substr(scope + 2);
}

const type_information* information_of(const results& found, const std::string& type) {
    const auto at = std::ranges::find(found.types, type, &type_information::name);
    return at == found.types.end() ? nullptr : &*at;
}

std::vector<candidate> candidates(const results& found, const std::string& group) {
    std::vector<candidate> all;
    for (const auto& o : overall_of(group.empty() ? found : only(found, group))) {
        if (!o.complete) {
            continue;
        }
        auto& c = all.emplace_back();
        c.type = o.how.type, c.variant = o.how.variant, c.root = o.how.root;
        c.information = information_of(found, c.type);
        c.fewest_bits = o.fewest_bits;
        if (std::isfinite(o.how.nanoseconds)) {
            c.nanoseconds = o.how.nanoseconds;
        }
        std::size_t evaluated = 0, misrounded = 0;
        for (const auto& r : found.rows) {
            if (r.type == c.type && r.variant == c.variant && r.root == c.root && (group.empty() || r.group == group)) {
                c.wrong += r.decisions.wrong();
                c.undecided += r.decisions.undecided;
                evaluated += r.decisions.evaluated;
                for (const quantity q : {quantity::time, quantity::crossing}) {
                    c.times += r.error(q).count;
                    misrounded += r.error(q).count - r.error(q).correctly_rounded;
                }
            }
        }
        c.imperfect = evaluated == 0
                          ? 0
                          : static_cast<double>(c.wrong + c.undecided + misrounded) / static_cast<double>(evaluated);
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
                              add(t->name, "textbook", "stable") || add(t->name, "textbook", "printed") ||
                              add(t->name, "", ""));
        }
    }
    return lines;
}

} // namespace compare::report
