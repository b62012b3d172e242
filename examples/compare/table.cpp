#include "table.hpp"

#include "answer.hpp"
#include "extremes.hpp"
#include "printable_results.hpp"
#include "text_table.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace compare {

namespace {

constexpr double notable_bits = 1.0; // a smaller gain earns no line among the best

std::string percent(std::size_t part, std::size_t whole) {
    if (whole == 0) {
        return "-";
    }
    const double share = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    // 100% and 0% are reserved for all and none.
    const double shown = part == whole ? 100 : part == 0 ? 0 : std::clamp(std::round(share), 1.0, 99.0);
    return std::to_string(static_cast<int>(shown)) + "%";
}

std::string method_of(const row& r) { return r.variant + "/" + r.root; }

const type_information* find_type(const results& found, const std::string& name) {
    const auto place =
        std::find_if(found.types.begin(), found.types.end(), [&](const type_information& t) { return t.name == name; });
    return place == found.types.end() ? nullptr : &*place;
}

const row* find_row(const results& found, const row& like, const std::string& group) {
    const auto place = std::find_if(found.rows.begin(), found.rows.end(), [&](const row& r) {
        return r.type == like.type && r.variant == like.variant && r.root == like.root && r.group == group;
    });
    return place == found.rows.end() ? nullptr : &*place;
}

std::string list_of(const std::map<std::string, std::size_t>& counts) {
    std::string text;
    for (const auto& [name, count] : counts) {
        std::string words = name;
        std::replace(words.begin(), words.end(), '_', '-');
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + words;
    }
    return text;
}

std::string heading(const results& found, bool one_pair) {
    std::ostringstream out;
    out << "graze-compare " << found.machine.graze << ": " << found.source << ", numbers "
        << (found.as == "exact" ? "as written" : "rounded to double first") << "\n";
    out << found.machine.compiler << " " << found.machine.flags << ", " << found.machine.processor << "\n\n";
    for (const group_information& g : found.groups) {
        std::string text = g.name + " (" + std::to_string(g.dimension) + "D): " + std::to_string(g.pairs);
        if (one_pair) {
            text += " pair of " + std::to_string(g.pairs_of);
        } else if (g.pairs_of > g.pairs) {
            text += " pairs, a sample of " + std::to_string(g.pairs_of) + " (seed " + std::to_string(found.seed) +
                    "; --all takes every pair)";
        } else {
            text += g.pairs == 1 ? " pair" : " pairs";
        }
        text += ": " + list_of(g.kinds) + "; in truth " + list_of(g.encounters);
        out << wrapped(text) << (g.description.empty() ? "" : wrapped(g.description, "  "));
    }
    for (const missing_type& m : found.missing) {
        out << wrapped("Not measured: " + m.name + " (" + m.reason + ").");
    }
    return out.str() + "\n";
}

// A row's errors over all quantities of the table.
struct shown_error {
    std::size_t count = 0, rounded = 0;
    double largest = 0, median = 0;
};

shown_error error_of(const row& r, const std::vector<quantity>& quantities) {
    shown_error shown;
    std::size_t most = 0;
    for (const quantity q : quantities) {
        const error_statistics& e = r.error(q);
        shown.count += e.count + e.unscaled;
        shown.rounded += e.correctly_rounded;
        shown.largest = std::max(shown.largest, e.unscaled > 0 ? infinity : e.largest);
        if (e.count > most) {
            most = e.count;
            shown.median = e.median;
        }
    }
    return shown;
}

std::string wrong_text(const row& r, std::size_t pairs) {
    std::string text = std::to_string(r.decisions.wrong());
    if (r.decisions.undecided > 0) {
        text += "+" + std::to_string(r.decisions.undecided) + "?";
    }
    return r.decisions.evaluated < pairs ? text + "/" + std::to_string(r.decisions.evaluated) : text;
}

bool is_told_by_others(const results& found, const row& r) {
    const type_information* type = find_type(found, r.type);
    if (type == nullptr || !type->is_exact) {
        return r.root == "printed" && r.variant != "textbook";
    }
    // Exact types differ in time only, so the fastest row stands for all.
    return std::any_of(found.rows.begin(), found.rows.end(), [&](const row& other) {
        return other.type == r.type && other.group == found.groups.front().name &&
               other.nanoseconds.value_or(infinity) < r.nanoseconds.value_or(infinity);
    });
}

std::string main_table(const results& found, const std::vector<quantity>& quantities, bool every_row) {
    text_table table;
    table.column("type", true);
    table.column("variant/root", true);
    for (std::size_t i = 0; i < found.groups.size(); ++i) {
        const std::size_t first = 2 + 4 * i;
        table.span(found.groups[i].name, first, 4);
        table.column("wrong");
        table.column("worst");
        table.column("CR");
        table.column("time ");
    }
    std::string last;
    for (const row& r : found.rows) {
        if (found.groups.empty() || r.group != found.groups.front().name ||
            (!every_row && is_told_by_others(found, r))) {
            continue;
        }
        std::vector<std::string> cells = {r.type == last ? "" : r.type, method_of(r)};
        last = r.type;
        for (const group_information& g : found.groups) {
            const row* there = find_row(found, r, g.name);
            if (there == nullptr) {
                cells.insert(cells.end(), {"", "", "", ""});
                continue;
            }
            const shown_error error = error_of(*there, quantities);
            cells.push_back(wrong_text(*there, g.pairs));
            cells.push_back(error.count == 0 ? "-" : short_number(error.largest));
            cells.push_back(percent(error.rounded, error.count));
            cells.push_back(there->nanoseconds ? short_time(*there->nanoseconds) + (there->on_front ? "*" : " ")
                                               : "- ");
        }
        table.line(std::move(cells));
    }
    return table.text();
}

std::string front_table(const results& found) {
    std::vector<overall> candidates = overall_of(found);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const overall& x, const overall& y) { return x.how.nanoseconds < y.how.nanoseconds; });
    text_table table;
    table.column("type", true);
    table.column("variant/root", true);
    table.column("time a pair");
    table.column("wrong");
    table.column("correct bits");
    const overall* best = nullptr;
    for (const overall& o : candidates) {
        const auto share = [](const overall& x) {
            return static_cast<double>(x.wrong) / static_cast<double>(std::max<std::size_t>(x.evaluated, 1));
        };
        const bool better = best == nullptr || share(o) < share(*best) ||
                            (share(o) == share(*best) && o.fewest_bits > best->fewest_bits + notable_bits);
        if (!better || !o.complete || o.how.nanoseconds == infinity) {
            continue;
        }
        best = &o;
        table.line({o.how.type, o.how.variant + "/" + o.how.root, short_time(o.how.nanoseconds),
                    std::to_string(o.wrong),
                    o.fewest_bits == infinity    ? (o.times > 0 ? "exact" : "-")
                    : o.fewest_bits == -infinity ? "none"
                                                 : short_number(o.fewest_bits)});
    }
    return table.text();
}

// The row that stands for a type where variants matter little.
const row* typical_row(const results& found, const std::string& type, const std::string& group) {
    const row* typical = nullptr;
    for (const row& r : found.rows) {
        if (r.type == type && r.group == group && (typical == nullptr || method_of(r) == "lagrange/stable")) {
            typical = &r;
        }
    }
    return typical;
}

std::string text_of_types(const results& found) {
    text_table table;
    table.column("type", true);
    table.column("library", true);
    table.column("bits");
    table.column("bytes");
    table.column("root's");
    table.column("momentum");
    table.column("energy");
    table.column("", true);
    for (const type_information& t : found.types) {
        std::vector<std::string> cells = {t.name, t.library};
        cells.push_back(t.is_exact ? "exact" : t.digits > 0 ? std::to_string(t.digits) : "-");
        cells.push_back(std::to_string(t.bytes) + (t.uses_heap ? "+" : " "));
        cells.push_back(t.has_sqrt ? "" : std::to_string(t.real_bytes) + (t.uses_heap ? "+" : " "));
        double momentum = 0, energy = 0;
        std::size_t of_momentum = 0, of_energy = 0;
        for (const group_information& g : found.groups) {
            if (const row* r = typical_row(found, t.name, g.name)) {
                momentum = std::max(momentum, r->momentum.largest);
                energy = std::max(energy, r->energy.largest);
                of_momentum += r->momentum.count;
                of_energy += r->energy.count;
            }
        }
        cells.push_back(of_momentum > 0 ? short_number(momentum) : "-");
        cells.push_back(of_energy > 0 ? short_number(energy) : "-");
        cells.push_back(t.alias_of.empty() ? "" : "another name of " + t.alias_of + ", not counted");
        table.line(std::move(cells));
    }
    return table.text();
}

} // namespace

std::string to_text(const results& unsafe, const table_options& options) {
    const results found = with_printable_texts(unsafe);
    std::string out = heading(found, options.one_pair);
    out +=
        wrapped(
            "Number types. bits: of the significand; bytes: of a value, + what it has on the heap; root's: of τ where "
            "the type has no root; momentum, energy: the largest relative defect after the collision") +
        "\n" + text_of_types(found) + "\n";
    std::vector<std::vector<quantity>> tables;
    for (const quantity q : options.quantities) {
        tables.push_back({q});
    }
    if (tables.empty()) {
        tables.push_back({quantity::time, quantity::crossing});
    }
    for (const std::vector<quantity>& shown : tables) {
        const std::string what =
            shown.size() > 1 ? "the time of impact" : quantity_words[static_cast<std::size_t>(shown.front())];
        out += wrapped(
                   "Decisions, and the error of " + what +
                   ". wrong: wrong decisions, +n? left open, /n of n pairs; worst: "
                   "the largest error in units in the last place of a double; CR: the share that is correctly rounded; "
                   "time: of a whole solution; *: nothing is both faster and better") +
               "\n" + main_table(found, shown, options.every_row) + "\n";
    }
    if (options.one_pair) {
        return out + one_pair_text(found);
    }
    out += extremes_text(found);
    const auto timed = [](const row& r) { return r.nanoseconds.has_value(); };
    if (std::any_of(found.rows.begin(), found.rows.end(), timed)) {
        out += "Best trade-offs over all pairs: nothing faster is better.\n\n" + front_table(found) + "\n";
    } else {
        out += "There are no trade-offs between time and error: nothing was timed.\n\n";
    }
    return out + wrapped(found.sentence);
}

} // namespace compare
