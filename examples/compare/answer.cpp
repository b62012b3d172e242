#include "answer.hpp"

#include "text_table.hpp"

#include <graze/formula/encounter.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace compare {

namespace {

std::size_t times_of(const row& r) { return r.error(quantity::time).count + r.error(quantity::crossing).count; }

// Whether wrong or open decisions left no time of this row to measure: then nothing is known of its times.
bool nothing_left(const row& r) { return times_of(r) == 0 && r.decisions.wrong() + r.decisions.undecided > 0; }

double fewest_time_bits(const row& r) {
    if (nothing_left(r)) {
        return -infinity;
    }
    double bits = infinity;
    for (const quantity q : {quantity::time, quantity::crossing}) {
        if (r.error(q).unscaled > 0) {
            return -infinity;
        }
        if (r.error(q).count > 0) {
            bits = std::min(bits, r.error(q).fewest_bits);
        }
    }
    return bits;
}

bool without_error(const row& r) {
    bool exact = r.decisions.wrong() == 0 && r.decisions.undecided == 0;
    for (const error_statistics& e : r.errors) {
        exact = exact && e.exact == e.count && e.unscaled == 0;
    }
    return exact;
}

// How wrong a row is: the share of wrong or open decisions, then the largest error.
std::tuple<double, double> badness(const row& r) {
    const auto evaluated = static_cast<double>(std::max<std::size_t>(r.decisions.evaluated, 1));
    return {static_cast<double>(r.decisions.wrong() + r.decisions.undecided) / evaluated, largest_time_error(r)};
}

void mark_front(results& found) {
    for (row& r : found.rows) {
        r.on_front =
            r.nanoseconds.has_value() && std::none_of(found.rows.begin(), found.rows.end(), [&](const row& other) {
                if (other.group != r.group || !other.nanoseconds) {
                    return false;
                }
                const bool as_good = badness(other) <= badness(r) && *other.nanoseconds <= *r.nanoseconds;
                return as_good && (badness(other) < badness(r) || *other.nanoseconds < *r.nanoseconds);
            });
    }
}

// Times whose ratio is below this count as the same: one run cannot tell them apart.
constexpr double same_time = 1.1;

// The cheapest type, and of its variants that cost about the same the most precise.
template <class Good>
std::optional<choice> cheapest(const std::vector<overall>& candidates, Good good) {
    const auto qualifies = [&](const overall& o) { return o.complete && o.how.nanoseconds < infinity && good(o); };
    const overall* least = nullptr;
    for (const overall& o : candidates) {
        if (qualifies(o) && (least == nullptr || o.how.nanoseconds < least->how.nanoseconds)) {
            least = &o;
        }
    }
    const overall* best = least;
    for (const overall& o : candidates) {
        if (qualifies(o) && o.how.type == least->how.type && o.how.nanoseconds <= same_time * least->how.nanoseconds &&
            o.fewest_bits > best->fewest_bits) {
            best = &o;
        }
    }
    return best == nullptr ? std::nullopt : std::optional<choice>(best->how);
}

std::string in_words(const choice& c) {
    const std::string form = c.variant.empty() ? "" : c.variant + ", " + c.root + " root, ";
    return c.type + " (" + form + short_time(c.nanoseconds) + " a pair)";
}

std::string sentence_of(const results& found) {
    const auto timed = [](const row& r) { return r.nanoseconds.has_value(); };
    if (std::none_of(found.rows.begin(), found.rows.end(), timed)) {
        return "Nothing was timed, so no type is the cheapest.";
    }
    const auto some = [&](graze::encounter what) {
        return std::any_of(found.groups.begin(), found.groups.end(),
                           [&](const auto& g) { return g.encounters.contains(graze::to_string(what)); });
    };
    const bool times_are_due = some(graze::encounter::hit) || some(graze::encounter::graze);
    const std::string wanted = std::to_string(found.digits) + (found.digits == 1 ? " digit" : " digits");
    std::string text = times_are_due                     ? ""
                       : some(graze::encounter::overlap) ? "What collides overlaps at the start, so no time is needed. "
                                                         : "No pair collides, so no time is needed. ";
    if (!found.good_enough) {
        text += "No measured type gets every decision right";
        text += times_are_due ? ", and every time right to " + wanted : "";
    } else {
        text += "The cheapest type with no wrong decision";
        text += (times_are_due ? " and every time right to " + wanted : "") + " is " + in_words(*found.good_enough);
    }
    if (!found.exact) {
        return text + "; no measured type has exact values.";
    }
    if (found.good_enough && found.exact->type == found.good_enough->type) {
        return text + ", and its values are exact.";
    }
    return text + "; the cheapest with exact values is " + in_words(*found.exact) + ".";
}

} // namespace

double largest_time_error(const row& r) {
    if (nothing_left(r)) {
        return infinity;
    }
    double largest = 0;
    for (const quantity q : {quantity::time, quantity::crossing}) {
        largest = std::max(largest, r.error(q).unscaled > 0 ? infinity : r.error(q).largest);
    }
    return largest;
}

std::vector<overall> overall_of(const results& found) {
    std::vector<overall> result;
    std::vector<std::size_t> groups;
    for (const row& r : found.rows) {
        const auto same = [&](const overall& o) {
            return o.how.type == r.type && o.how.variant == r.variant && o.how.root == r.root;
        };
        auto place = std::find_if(result.begin(), result.end(), same);
        if (place == result.end()) {
            overall o;
            o.how = {r.type, r.variant, r.root, 0};
            o.fewest_bits = infinity;
            o.exact = true;
            result.push_back(o);
            groups.push_back(0);
            place = result.end() - 1;
        }
        const auto group = std::find_if(found.groups.begin(), found.groups.end(),
                                        [&](const group_information& g) { return g.name == r.group; });
        const double pairs = group == found.groups.end() ? 0.0 : static_cast<double>(group->pairs);
        place->how.nanoseconds += r.nanoseconds.value_or(infinity) * pairs; // divided below
        place->wrong += r.decisions.wrong() + r.decisions.undecided;
        place->evaluated += r.decisions.evaluated;
        place->times += times_of(r);
        place->fewest_bits = std::min(place->fewest_bits, fewest_time_bits(r));
        place->exact = place->exact && without_error(r);
        ++groups[static_cast<std::size_t>(place - result.begin())];
    }
    double all_pairs = 0;
    for (const group_information& g : found.groups) {
        all_pairs += static_cast<double>(g.pairs);
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i].how.nanoseconds /= std::max(all_pairs, 1.0);
        result[i].complete = groups[i] == found.groups.size();
    }
    return result;
}

void draw_conclusions(results& found) {
    mark_front(found);
    const std::vector<overall> candidates = overall_of(found);
    const auto right_to = [](int digits) {
        return [bits = digits * std::log2(10.0)](const overall& o) { return o.wrong == 0 && o.fewest_bits >= bits; };
    };
    const auto is_exact = [&](const overall& o) {
        const auto type = std::find_if(found.types.begin(), found.types.end(),
                                       [&](const type_information& t) { return t.name == o.how.type; });
        return o.exact && type != found.types.end() && type->is_exact;
    };
    std::vector<int> digits = {3, 6, 9, 12, 15, 18, 24, 30, 45, 90, found.digits};
    std::sort(digits.begin(), digits.end());
    digits.erase(std::unique(digits.begin(), digits.end()), digits.end());
    found.matrix.clear();
    for (const int d : digits) {
        found.matrix.push_back({d, cheapest(candidates, right_to(d))});
    }
    found.good_enough = cheapest(candidates, right_to(found.digits));
    found.exact = cheapest(candidates, is_exact);
    found.sentence = sentence_of(found);
}

} // namespace compare
