#include "diff.hpp"

#include "answer.hpp"
#include "input_error.hpp"
#include "significance.hpp"
#include "text_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace compare {

namespace {

bool same_row(const row& x, const row& y) {
    return x.group == y.group && x.type == y.type && x.variant == y.variant && x.root == y.root;
}

const row* match(const std::vector<row>& rows, const row& like) {
    const auto place = std::find_if(rows.begin(), rows.end(), [&](const row& r) { return same_row(r, like); });
    return place == rows.end() ? nullptr : &*place;
}

std::string name_of_row(const row& r) { return r.group + ": " + r.type + " " + r.variant + "/" + r.root; }

// How many doublings lead from one to the other.
double doublings(double before, double after) {
    if (before == after) {
        return 0;
    }
    return before > 0 && after > 0 && std::isfinite(before) && std::isfinite(after)
               ? std::fabs(std::log2(after / before))
               : infinity;
}

// Notes each figure of a row that changed in the list that it belongs to.
class row_difference {
  public:
    row_difference(difference& all, const row& before) : all_(all), name_(name_of_row(before)) {}

    // A figure of which more is worse.
    void note(const std::string& what, double before, double after) {
        if (before != after) {
            const auto [x, y] = told_apart(before, after);
            add(after > before, {name_, what, x, y, doublings(before, after)});
        }
    }
    void note(const std::string& what, std::size_t before, std::size_t after) {
        if (before != after) {
            add(after > before, {name_, what, std::to_string(before), std::to_string(after),
                                 doublings(static_cast<double>(before), static_cast<double>(after))});
        }
    }
    [[nodiscard]] bool changed() const { return changed_; }

  private:
    difference& all_;
    std::string name_;
    bool changed_ = false;

    void add(bool is_worse, change c) {
        changed_ = true;
        (is_worse ? all_.worse : all_.better).push_back(std::move(c));
    }
};

void compare_errors(row_difference& noted, const std::string& what, const error_statistics& before,
                    const error_statistics& after) {
    noted.note(what + ", values that should be 0 and are not", before.unscaled, after.unscaled);
    noted.note(what + ", values that are not finite", before.not_finite, after.not_finite);
    if (before.count == 0 || after.count == 0) {
        return; // decisions changed then, and are noted as such
    }
    noted.note(what + ", largest error", before.largest, after.largest);
    noted.note(what + ", median error", before.median, after.median);
    if (before.count == after.count) {
        noted.note(what + ", values not correctly rounded", before.count - before.correctly_rounded,
                   after.count - after.correctly_rounded);
    }
}

void compare_rows(difference& all, const row& before, const row& after) {
    row_difference noted(all, before);
    const decision_counts& x = before.decisions;
    const decision_counts& y = after.decisions;
    noted.note("wrong on approaching", x.approaching, y.approaching);
    noted.note("wrong on overlap", x.overlap, y.overlap);
    noted.note("wrong on hit or miss", x.hit_or_miss, y.hit_or_miss);
    noted.note("wrong feature", x.feature, y.feature);
    noted.note("no answer", x.failed, y.failed);
    noted.note("undecided", x.undecided, y.undecided);
    noted.note("not enclosed", before.not_enclosed, after.not_enclosed);
    for (std::size_t i = 0; i < quantity_count; ++i) {
        compare_errors(noted, quantity_names[i], before.errors[i], after.errors[i]);
    }
    if (before.width.count > 0 && after.width.count > 0) {
        noted.note("width, largest", before.width.largest, after.width.largest);
    }
    if (before.momentum.count > 0 && after.momentum.count > 0) {
        noted.note("momentum, largest defect", before.momentum.largest, after.momentum.largest);
    }
    if (before.energy.count > 0 && after.energy.count > 0) {
        noted.note("energy, largest defect", before.energy.largest, after.energy.largest);
    }
    if (!noted.changed()) {
        ++all.same;
    }
}

// The times of one row before and after, and the probability that chance makes such a difference.
struct compared_time {
    std::string name;
    double before, after;             // medians
    double least_before, least_after; // the least of the repeats: other work on the machine disturbs it least
    double chance;
};

constexpr double notable_ratio = 1.1; // a smaller change is not reported, however significant
constexpr double notable_chance = 0.01;

// Old files have no repeats. Of them, times differ if their quartiles do not overlap.
std::optional<compared_time> time_of(const row& x, const row& y) {
    if (!x.nanoseconds || !y.nanoseconds) {
        return std::nullopt;
    }
    if (x.repeated.empty() || y.repeated.empty()) {
        const bool apart = x.nanoseconds_high < y.nanoseconds_low || y.nanoseconds_high < x.nanoseconds_low;
        return compared_time{name_of_row(x),    *x.nanoseconds,    *y.nanoseconds,
                             x.nanoseconds_low, y.nanoseconds_low, apart ? 0.0 : 1.0};
    }
    return compared_time{name_of_row(x),
                         *x.nanoseconds,
                         *y.nanoseconds,
                         *std::min_element(x.repeated.begin(), x.repeated.end()),
                         *std::min_element(y.repeated.begin(), y.repeated.end()),
                         probability_of_no_difference(x.repeated, y.repeated)};
}

// The median ratio. What all rows have in common is due to the machine: its load, its clock.
double common_ratio(const std::vector<compared_time>& times) {
    std::vector<double> ratios;
    for (const compared_time& t : times) {
        ratios.push_back(t.least_after / t.least_before);
    }
    std::sort(ratios.begin(), ratios.end());
    constexpr std::size_t enough = 8; // rows: of fewer, one row that changed would be too large a part
    return ratios.size() < enough ? 1 : ratios[ratios.size() / 2];
}

// Holm's test: of k probabilities the least must be below 1%/k, the next one below 1%/(k - 1), and so on.
void compare_times(difference& all, std::vector<compared_time> times) {
    all.times_compared = times.size();
    all.common_ratio = common_ratio(times);
    const auto is_notable = [&](double from, double to) {
        const double ratio = to / from;
        return ratio > notable_ratio || ratio < 1 / notable_ratio;
    };
    std::stable_sort(times.begin(), times.end(), [](const auto& x, const auto& y) { return x.chance < y.chance; });
    for (std::size_t i = 0; i < times.size(); ++i) {
        const compared_time& t = times[i];
        if (t.chance * static_cast<double>(times.size() - i) >= notable_chance) {
            break;
        }
        const double before = t.before * all.common_ratio, least_before = t.least_before * all.common_ratio;
        const bool slower = t.after > before;
        if (is_notable(before, t.after) && is_notable(least_before, t.least_after) &&
            slower == (t.least_after > least_before)) {
            (slower ? all.slower : all.faster)
                .push_back({t.name, "time", short_time(t.before), short_time(t.after), doublings(before, t.after)});
        }
    }
}

void compare_settings(difference& all, const results& before, const results& after) {
    const auto note = [](std::vector<std::string>& to, const std::string& what, const std::string& x,
                         const std::string& y) {
        if (x != y) {
            to.push_back(what + ": " + (x.empty() ? "none" : x) + " -> " + (y.empty() ? "none" : y));
        }
    };
    note(all.other_pairs, "--as", before.as, after.as);
    note(all.other_pairs, "--seed", std::to_string(before.seed), std::to_string(after.seed));
    note(all.other_pairs, "source", before.source, after.source);
    for (const group_information& g : before.groups) {
        const auto same = std::find_if(after.groups.begin(), after.groups.end(),
                                       [&](const group_information& other) { return other.name == g.name; });
        if (same != after.groups.end()) {
            const std::string of = "pairs of " + g.name;
            note(all.other_pairs, of, std::to_string(g.pairs), std::to_string(same->pairs));
            note(all.other_pairs, "dimension of " + g.name, std::to_string(g.dimension),
                 std::to_string(same->dimension));
            if (g.pairs == same->pairs && g.encounters != same->encounters) {
                all.other_pairs.push_back(of + ": the same number of other pairs");
            }
        }
    }
    note(all.other_build, "compiler", before.machine.compiler, after.machine.compiler);
    note(all.other_build, "flags", before.machine.flags, after.machine.flags);
    note(all.other_build, "processor", before.machine.processor, after.machine.processor);
    note(all.other_build, "graze", before.machine.graze, after.machine.graze);
}

void add_lines(std::string& out, const std::string& heading, const std::vector<std::string>& lines) {
    if (lines.empty()) {
        return;
    }
    out += heading + "\n";
    for (const std::string& line : lines) {
        out += "  " + printable(line, 4096) + "\n";
    }
}

void add_changes(std::string& out, const std::string& heading, const std::vector<change>& changes) {
    std::vector<std::string> lines;
    for (const change& c : changes) {
        lines.push_back(c.row + ": " + c.what + " " + c.before + " -> " + c.after);
    }
    add_lines(out, heading + " (" + std::to_string(lines.size()) + ")", lines);
}

std::string counted_things(std::size_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

// Decimal digits of the worst time.
std::optional<double> digits_of(const row& r) {
    const error_statistics &time = r.error(quantity::time), &crossing = r.error(quantity::crossing);
    double bits = infinity;
    bits = time.count > 0 ? std::min(bits, time.fewest_bits) : bits;
    bits = crossing.count > 0 ? std::min(bits, crossing.fewest_bits) : bits;
    return time.count + crossing.count > 0 ? std::optional(bits / std::log2(10.0)) : std::nullopt;
}

} // namespace

difference compare_results(const results& before, const results& after) {
    difference all;
    compare_settings(all, before, after);
    std::vector<compared_time> times;
    for (const row& old_row : before.rows) {
        const row* new_row = match(after.rows, old_row);
        if (new_row == nullptr) {
            all.only_old.push_back(name_of_row(old_row));
            continue;
        }
        if (old_row.decisions.evaluated != new_row->decisions.evaluated) {
            all.not_comparable.push_back(name_of_row(old_row) + ": " + std::to_string(old_row.decisions.evaluated) +
                                         " -> " + std::to_string(new_row->decisions.evaluated));
            continue;
        }
        ++all.compared;
        compare_rows(all, old_row, *new_row);
        if (auto t = time_of(old_row, *new_row)) {
            all.old_has_repeats = all.old_has_repeats && !old_row.repeated.empty() && !new_row->repeated.empty();
            times.push_back(std::move(*t));
        }
    }
    compare_times(all, std::move(times));
    for (const row& new_row : after.rows) {
        if (match(before.rows, new_row) == nullptr) {
            all.only_new.push_back(name_of_row(new_row));
        }
    }
    for (auto* list : {&all.worse, &all.better, &all.slower, &all.faster}) {
        std::stable_sort(list->begin(), list->end(), [](const change& x, const change& y) { return x.by > y.by; });
    }
    return all;
}

std::string to_text(const difference& d) {
    std::string out;
    add_lines(out,
              "The settings differ. The results are not of the same pairs, so what follows does not compare like with "
              "like:",
              d.other_pairs);
    add_lines(out, "The builds differ:", d.other_build);
    if (!d.worse.empty()) {
        add_changes(out, "Worse, the largest changes first", d.worse);
    }
    if (!d.better.empty()) {
        add_changes(out, "Better, the largest changes first", d.better);
    }
    if (!d.slower.empty()) {
        add_changes(out, "Slower; times do not count", d.slower);
    }
    if (!d.faster.empty()) {
        add_changes(out, "Faster; times do not count", d.faster);
    }
    add_lines(out, "Not compared, measured on different numbers of pairs:", d.not_comparable);
    add_lines(out, "Only in the old results:", d.only_old);
    add_lines(out, "Only in the new results:", d.only_new);
    out += counted_things(d.compared, "row", "rows") + " compared: " + std::to_string(d.same) +
           " the same but for time; " + counted_things(d.worse.size(), "value", "values") + " got worse, " +
           counted_things(d.better.size(), "value", "values") + " better.\n";
    if (d.times_compared > 0) {
        out += counted_things(d.times_compared, "time", "times") + " compared" +
               (d.old_has_repeats ? " over their repeats: " : " by their quartiles: ") +
               std::to_string(d.slower.size()) + " slower, " + std::to_string(d.faster.size()) + " faster";
        out += d.common_ratio > 1.02 || d.common_ratio < 0.98
                   ? ", once the " + short_number(100 * std::fabs(d.common_ratio - 1)) + "% by which all are " +
                         (d.common_ratio > 1 ? "slower" : "faster") + " are left out.\n"
                   : ".\n";
    }
    return out;
}

std::vector<row_history> history_of(const std::vector<results>& all) {
    std::vector<row_history> histories;
    for (auto last = all.rbegin(); last != all.rend(); ++last) {
        for (const row& r : last->rows) {
            const bool known = std::any_of(histories.begin(), histories.end(), [&](const row_history& h) {
                return h.group == r.group && h.type == r.type && h.variant == r.variant && h.root == r.root;
            });
            if (known) {
                continue;
            }
            row_history h{r.group, r.type, r.variant, r.root, {}, {}, {}};
            for (const results& one : all) {
                const row* there = match(one.rows, r);
                h.nanoseconds.push_back(there != nullptr ? there->nanoseconds : std::nullopt);
                h.digits.push_back(there != nullptr ? digits_of(*there) : std::nullopt);
                h.wrong.push_back(there != nullptr
                                      ? std::optional(there->decisions.wrong() + there->decisions.undecided)
                                      : std::nullopt);
            }
            histories.push_back(std::move(h));
        }
    }
    return histories;
}

std::string history_text(const std::vector<results>& all, const std::vector<std::string>& names) {
    std::string out = "Correct digits of the worst time (wrong or open decisions), run by run:\n";
    text_table table;
    table.column("group", true);
    table.column("type", true);
    table.column("variant/root", true);
    for (std::size_t i = 0; i < all.size(); ++i) {
        out += "  " + std::to_string(i + 1) + "  " + printable(names[i], 200) + "  " + printable(all[i].machine.date) +
               "  graze " + printable(all[i].machine.graze) + "\n";
        table.column(std::to_string(i + 1));
    }
    std::size_t unchanged = 0;
    for (const row_history& h : history_of(all)) {
        const auto changes = [](const auto& values) {
            return std::any_of(values.begin(), values.end(), [&](const auto& v) { return v != values.front(); });
        };
        if (!changes(h.digits) && !changes(h.wrong)) {
            ++unchanged;
            continue;
        }
        std::vector<std::string> cells = {printable(h.group), printable(h.type), h.variant + "/" + h.root};
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string digits = !h.digits[i]               ? "-"
                                       : std::isinf(*h.digits[i]) ? (*h.digits[i] > 0 ? "exact" : "none")
                                                                  : short_number(*h.digits[i]);
            cells.push_back(digits + (h.wrong[i].value_or(0) > 0 ? " (" + std::to_string(*h.wrong[i]) + ")" : ""));
        }
        table.line(std::move(cells));
    }
    return out + "\n" + table.text() + counted_things(unchanged, "row", "rows") + " the same in every run\n";
}

} // namespace compare
