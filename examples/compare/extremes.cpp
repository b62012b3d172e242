#include "extremes.hpp"

#include "text_table.hpp"
#include "whole_file.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace compare {

namespace {

const pair_information* pair_of(const results& found, const std::string& group, std::size_t number) {
    for (const group_information& g : found.groups) {
        const auto at = std::find_if(g.shown.begin(), g.shown.end(), [&](const auto& p) { return p.number == number; });
        if (g.name == group && at != g.shown.end()) {
            return &*at;
        }
    }
    return nullptr;
}

bool is_error(const extreme_pair& e) { return e.which == "largest"; }
bool is_time(const extreme_pair& e) { return e.what == "time" || e.what == "crossing"; }

std::string form_of(const row& r) { return r.variant + "/" + r.root; }

std::string with_spaces(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string error_text(const extreme_pair& e) { return short_number(e.error); }

struct found_extreme {
    const row* of;
    const extreme_pair* what;
    const pair_information* pair;
};

std::vector<found_extreme> all_extremes(const results& found) {
    std::vector<found_extreme> all;
    for (const row& r : found.rows) {
        for (const extreme_pair& e : r.extremes) {
            if (const pair_information* p = pair_of(found, r.group, e.pair)) {
                all.push_back({&r, &e, p});
            }
        }
    }
    return all;
}

// A table, and the pair in its first line.
struct told_pairs {
    std::string text;
    std::size_t first = 0;
};

told_pairs wrong_pairs(const results& found, const std::vector<found_extreme>& all, std::size_t most) {
    std::vector<found_extreme> wrong;
    std::copy_if(all.begin(), all.end(), std::back_inserter(wrong),
                 [](const found_extreme& f) { return !is_error(*f.what) && f.what->what != "undecided"; });
    if (wrong.empty()) {
        return {};
    }
    // The farther from the border, the worse the mistake.
    std::stable_sort(wrong.begin(), wrong.end(),
                     [](const auto& x, const auto& y) { return x.pair->border > y.pair->border; });
    text_table table;
    table.column("pair");
    table.column("which", true);
    table.column("type", true);
    table.column("variant/root", true);
    table.column("says", true);
    table.column("in truth", true);
    table.column("from the border");
    // Forms of a type that give the same answer to a pair share a line.
    std::vector<std::pair<found_extreme, std::vector<std::string>>> told;
    for (const found_extreme& w : wrong) {
        const auto same = std::find_if(told.begin(), told.end(), [&](const auto& t) {
            return t.first.pair == w.pair && t.first.of->type == w.of->type && t.first.what->said == w.what->said;
        });
        if (same == told.end()) {
            told.push_back({w, {form_of(*w.of)}});
        } else if (std::find(same->second.begin(), same->second.end(), form_of(*w.of)) == same->second.end()) {
            same->second.push_back(form_of(*w.of));
        }
    }
    for (std::size_t i = 0; i < std::min(most, told.size()); ++i) {
        const auto& [w, forms] = told[i];
        table.line({std::to_string(w.pair->number),
                    w.pair->name + (found.groups.size() > 1 ? " of " + w.of->group : ""), w.of->type,
                    forms.front() + (forms.size() > 1 ? " and " + std::to_string(forms.size() - 1) + " more" : ""),
                    w.what->said, w.what->right, short_number(w.pair->border)});
    }
    std::string text = "Wrong decisions, those farthest from the border first.\n\n" + table.text();
    if (told.size() > most) {
        text += "and " + std::to_string(told.size() - most) + " more\n";
    }
    return {text + "\n", told.front().first.pair->number};
}

told_pairs worst_pairs(const results& found, const std::vector<found_extreme>& all) {
    text_table table;
    table.column("pair");
    table.column("which", true);
    table.column("type", true);
    table.column("variant/root", true);
    table.column("error");
    table.column("says", true);
    table.column("in truth", true);
    std::size_t first = 0;
    for (const type_information& t : found.types) {
        // Of the type's forms, the one whose largest error is smallest.
        const found_extreme* best = nullptr;
        std::set<std::string> forms;
        for (const found_extreme& f : all) {
            if (f.of->type == t.name && is_error(*f.what) && is_time(*f.what) && forms.insert(form_of(*f.of)).second) {
                const found_extreme* worst = &f;
                for (const found_extreme& other : all) {
                    if (other.of->type == t.name && form_of(*other.of) == form_of(*f.of) && is_error(*other.what) &&
                        is_time(*other.what) && other.what->error > worst->what->error) {
                        worst = &other;
                    }
                }
                best = best == nullptr || worst->what->error < best->what->error ? worst : best;
            }
        }
        if (best != nullptr) {
            table.line({std::to_string(best->pair->number),
                        best->pair->name + (found.groups.size() > 1 ? " of " + best->of->group : ""), t.name,
                        form_of(*best->of), error_text(*best->what), best->what->said, best->what->right});
            first = first == 0 ? best->pair->number : first;
        }
    }
    if (first == 0) {
        return {};
    }
    return {"The largest error of the time, in each type's best form, in units in the last place of a double.\n\n" +
                table.text() + "\n",
            first};
}

} // namespace

std::string repeat_command(const results& found, const row& r, std::size_t pair) {
    return found.program + found.inputs + " --pair " + std::to_string(pair) + " --types " + quoted(r.type) +
           " --variants " + r.variant + "/" + r.root;
}

std::string in_words(const extreme_pair& e) {
    static const std::array<std::pair<const char*, const char*>, 6> kinds = {
        {{"approaching", "wrong on whether they come closer"},
         {"overlap", "wrong on whether they overlap"},
         {"hit_or_miss", "wrong on hit or miss"},
         {"feature", "wrong on the feature"},
         {"failed", "no answer"},
         {"undecided", "left open"}}};
    for (const auto& [kind, words] : kinds) {
        if (e.what == kind) {
            return std::string(words) +
                   (e.which == "nearest" ? ", nearest to the border" : ", farthest from the border");
        }
    }
    const auto which = std::find(quantity_names.begin(), quantity_names.end(), e.what) - quantity_names.begin();
    return std::string("largest error of ") + quantity_words.at(static_cast<std::size_t>(which));
}

std::string extremes_text(const results& found) {
    constexpr std::size_t most = 10;
    const std::vector<found_extreme> all = all_extremes(found);
    const told_pairs wrong = wrong_pairs(found, all, most), worst = worst_pairs(found, all);
    if (wrong.text.empty() && worst.text.empty()) {
        return "";
    }
    return wrong.text + worst.text +
           wrapped("For all numbers of a pair, add --pair and its number: " + found.program + found.inputs +
                   " --pair " + std::to_string(wrong.text.empty() ? worst.first : wrong.first) +
                   ". --pairs FOLDER writes the scenes of all these pairs; --json and --report hold them too.") +
           "\n";
}

namespace {

// The answers to one pair. Forms of a type that give the same answer share a line.
std::string answers_text(const results& found, const std::string& group, std::size_t pair) {
    std::vector<std::pair<std::string, std::string>> told; // an answer, and who gave it
    for (const row& r : found.rows) {
        std::string said;
        for (const extreme_pair& e : r.extremes) {
            if (r.group == group && e.pair == pair) {
                said += wrapped((is_error(e) ? with_spaces(e.what) : "decision") + ": " + e.said + ", in truth " +
                                    e.right + (is_error(e) ? ", error " + error_text(e) : ""),
                                "    ");
            }
        }
        if (said.empty()) {
            continue;
        }
        const auto same = std::find_if(told.begin(), told.end(), [&](const auto& t) {
            return t.second == said && t.first.starts_with(r.type + ", ");
        });
        if (same == told.end()) {
            told.emplace_back(r.type + ", " + form_of(r), said);
        } else {
            same->first += ", " + form_of(r);
        }
    }
    std::string text = "Errors are in units in the last place of a double.\n";
    for (const auto& [who, what] : told) {
        text += wrapped(who + ":") + what;
    }
    return text;
}

} // namespace

std::string one_pair_text(const results& found) {
    std::string text;
    for (const group_information& g : found.groups) {
        for (const pair_information& p : g.shown) {
            text += "Pair " + std::to_string(p.number) + " of " + g.name + ", " + p.name + ": " + p.encounter;
            text += p.time.empty() ? "" : " at " + p.time;
            text += ", " + short_number(p.border) + " from the border, relative\n\n";
            text_table numbers;
            numbers.column("", true);
            numbers.column("decimal", true);
            numbers.column("hexadecimal", true);
            for (const named_number& n : p.numbers) {
                numbers.line({n.name, n.decimal, n.hexadecimal});
            }
            text += numbers.text() + "\n";
            const bool all_right = std::none_of(found.rows.begin(), found.rows.end(), [&](const row& r) {
                return std::any_of(r.extremes.begin(), r.extremes.end(),
                                   [&](const auto& e) { return e.pair == p.number; });
            });
            text += all_right ? "Every type that was measured is right on this pair, and without any error.\n"
                              : answers_text(found, g.name, p.number);
            text += "\nAs a scene:\n" + p.scene + "\n";
        }
    }
    return text;
}

void write_pairs(const results& found, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw std::runtime_error(folder.string() + ": cannot be made: " + error.message());
    }
    std::string list;
    for (const group_information& g : found.groups) {
        for (const pair_information& p : g.shown) {
            const std::filesystem::path file = folder / ("pair-" + std::to_string(p.number) + ".json");
            write_whole_file(file.string(), p.scene);
            list += file.filename().string() + ": " + g.name + ", " + p.name + ", in truth " + p.encounter + ", " +
                    short_number(p.border) + " from the border\n";
            for (const row& r : found.rows) {
                for (const extreme_pair& e : r.extremes) {
                    if (r.group == g.name && e.pair == p.number) {
                        list += "  " + r.type + " " + form_of(r) + ": " + in_words(e) +
                                (is_error(e) ? ", " + error_text(e) + " units in the last place" : "") + ": " + e.said +
                                ", in truth " + e.right + "\n    " + repeat_command(found, r, p.number) + "\n    " +
                                found.program + " " + quoted(file.string()) + " --as exact --types " + quoted(r.type) +
                                " --variants " + form_of(r) + "\n";
                    }
                }
            }
        }
    }
    write_whole_file((folder / "pairs.txt").string(), list);
}

} // namespace compare
