#include "tables.hpp"

#include "summary.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace compare::report {
namespace {

[[nodiscard]] std::string counts(const std::map<std::string, std::size_t>& all) {
    std::string text;
    for (const auto& [name, count] : all) {
        std::string said = name;
        std::ranges::replace(said, '_', '-');
        text += (text.empty() ? "" : ", ") + readable_count(count) + " " + escaped(said);
    }
    return text;
}

[[nodiscard]] std::string largest_and_median(const error_statistics& e) {
    if (e.count == 0) {
        return "–";
    }
    return readable(e.largest) + " <small>(" + readable(e.median) + ")</small>";
}

[[nodiscard]] std::string defect(const defect_statistics& d) { return d.count == 0 ? "–" : readable(d.largest); }

// For both kinds of time together.
[[nodiscard]] std::string correctly_rounded(const row& r) {
    const auto& time = r.error(quantity::time);
    const auto& crossing = r.error(quantity::crossing);
    const std::size_t count = time.count + crossing.count;
    if (count == 0) {
        return "–";
    }
    return readable(100.0 * static_cast<double>(time.correctly_rounded + crossing.correctly_rounded) /
                    static_cast<double>(count)) +
           " %";
}

[[nodiscard]] std::string fewest_bits(const row& r) {
    const auto& time = r.error(quantity::time);
    const auto& crossing = r.error(quantity::crossing);
    double bits = std::numeric_limits<double>::infinity();
    bits = time.count == 0 ? bits : std::min(bits, time.fewest_bits);
    bits = crossing.count == 0 ? bits : std::min(bits, crossing.fewest_bits);
    return time.count + crossing.count == 0 ? "–" : std::isinf(bits) && bits > 0 ? "all" : readable(bits);
}

[[nodiscard]] std::string wrong_of(const decision_counts& d) {
    if (d.wrong() + d.undecided == 0) {
        return "0";
    }
    std::string text = "<b class=\"bad\">" + readable_count(d.wrong()) + "</b>";
    if (d.undecided != 0) {
        text += " <span class=\"open\">+ " + readable_count(d.undecided) + " open</span>";
    }
    return text;
}

// The cheapest of those that decide correctly and whose times are all right to 10^-digits.
[[nodiscard]] const candidate* cheapest(const std::vector<candidate>& all, double bits) {
    const candidate* best = nullptr;
    for (const auto& c : all) {
        if (c.nanoseconds && c.decides_right() && c.fewest_bits >= bits &&
            (best == nullptr || *c.nanoseconds < *best->nanoseconds)) {
            best = &c;
        }
    }
    return best;
}

[[nodiscard]] std::string said(const candidate* c) {
    return c == nullptr ? "none" : escaped(c->name()) + " <small>" + readable_time(*c->nanoseconds) + "</small>";
}

} // namespace

std::string table(const std::string& style, const std::vector<std::string>& heads,
                  const std::vector<std::vector<std::string>>& rows, const std::vector<std::string>& ids) {
    std::string html = "<table class=\"" + style + "\"><thead><tr>";
    for (const auto& h : heads) {
        html += "<th scope=\"col\">" + h;
    }
    html += "</thead><tbody>\n";
    for (std::size_t n = 0; n < rows.size(); ++n) {
        const auto& r = rows[n];
        html += n < ids.size() ? "<tr id=\"" + ids[n] + "\">" : "<tr>";
        for (std::size_t i = 0; i < r.size(); ++i) {
            html += i == 0 ? "<th scope=\"row\">" + r[i] : "<td data-head=\"" + heads[i] + "\">" + r[i];
        }
        html += "\n";
    }
    return html + "</tbody></table>\n";
}

std::string groups_table(const results& found) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& g : found.groups) {
        rows.push_back({escaped(g.name), escaped(g.description), std::to_string(g.dimension) + "D",
                        g.pairs == g.pairs_of ? readable_count(g.pairs)
                                              : readable_count(g.pairs) + " of " + readable_count(g.pairs_of),
                        counts(g.kinds), counts(g.encounters)});
    }
    return table("words", {"group", "what it is", "dimension", "pairs", "kinds", "in truth"}, rows);
}

std::string types_table(const results& found) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& t : found.types) {
        const std::string note = t.alias_of.empty() ? escaped(t.note) : "another name of " + escaped(t.alias_of);
        rows.push_back({escaped(t.name), escaped(t.library),
                        t.is_exact      ? "exact"
                        : t.is_interval ? "interval"
                                        : "rounds",
                        t.digits > 0 ? std::to_string(t.digits) : "–", t.has_sqrt ? "yes" : "sqrt_extension",
                        t.has_fma ? "yes" : "no", std::to_string(t.bytes) + (t.uses_heap ? " + heap" : ""),
                        std::to_string(t.real_bytes), note});
    }
    for (const auto& m : found.missing) {
        rows.push_back({escaped(m.name), "<em>missing</em>", "–", "–", "–", "–", "–", "–", escaped(m.reason)});
    }
    return table("words", {"type", "library", "kind", "bits", "square root", "fma", "bytes", "bytes of τ", "note"},
                 rows);
}

std::string matrix_table(const results& found) {
    std::vector<std::string> heads = {"digits", "all groups"};
    std::vector<std::vector<candidate>> columns = {candidates(found)};
    if (found.groups.size() > 1) {
        for (const auto& g : found.groups) {
            heads.push_back(escaped(g.name));
            columns.push_back(candidates(found, g.name));
        }
    }
    std::vector<std::vector<std::string>> rows;
    const auto add = [&](const std::string& name, double bits) {
        std::vector<std::string> cells = {name};
        for (const auto& c : columns) {
            cells.push_back(said(cheapest(c, bits)));
        }
        rows.push_back(cells);
    };
    for (const auto& d : found.matrix) {
        add(std::to_string(d.digits), d.digits * std::log2(10.0));
    }
    for (auto& c : columns) {
        std::erase_if(c, [](const candidate& x) { return !x.is_exact(); });
    }
    add("exact", 0);
    return table("words", heads, rows);
}

std::string rows_table(const results& found, const group_information& group) {
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> ids; // with these, dots and rows link to each other
    for (std::size_t n = 0; n < found.rows.size(); ++n) {
        const auto& r = found.rows[n];
        if (r.group == group.name) {
            ids.push_back("row-" + std::to_string(n));
            rows.push_back(
                {(r.on_front ? "<b>★ " : "") + escaped(name_of(r.type, r.variant, r.root)) + (r.on_front ? "</b>" : ""),
                 r.nanoseconds ? readable_time(*r.nanoseconds) : "–", wrong_of(r.decisions),
                 largest_and_median(r.error(quantity::time)), largest_and_median(r.error(quantity::crossing)),
                 fewest_bits(r), correctly_rounded(r), largest_and_median(r.error(quantity::discriminant)),
                 largest_and_median(r.error(quantity::position)), largest_and_median(r.error(quantity::velocity)),
                 defect(r.momentum), defect(r.energy)});
        }
    }
    return table("figures",
                 {"type · variant", "time", "wrong", "τ, units", "crossing, units", "fewest bits", "rounded right",
                  "D, units", "position, units", "velocity, units", "momentum", "energy"},
                 rows, ids);
}

std::string decisions_table(const results& found) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& r : found.rows) {
        const auto& d = r.decisions;
        if (d.wrong() + d.undecided != 0) {
            rows.push_back({escaped(name_of(r.type, r.variant, r.root)), escaped(r.group), readable_count(d.evaluated),
                            readable_count(d.hit_or_miss), readable_count(d.overlap), readable_count(d.approaching),
                            readable_count(d.feature), readable_count(d.failed), readable_count(d.undecided)});
        }
    }
    return rows.empty() ? std::string()
                        : table("figures",
                                {"type · variant", "group", "pairs", "hit or miss", "overlap", "approaching", "feature",
                                 "no answer", "left open"},
                                rows);
}

std::string intervals_table(const results& found) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& r : found.rows) {
        const auto* t = information_of(found, r.type);
        if (t != nullptr && t->is_interval) {
            rows.push_back({escaped(name_of(r.type, r.variant, r.root)), escaped(r.group),
                            readable_count(r.decisions.undecided), largest_and_median(r.width),
                            readable_count(r.not_enclosed)});
        }
    }
    return rows.empty() ? std::string()
                        : table("figures",
                                {"type · variant", "group", "decisions left open", "width of τ, units",
                                 "values outside their interval"},
                                rows);
}

std::string hardness_table(const results& found, const group_information& group) {
    const auto lines = chosen_lines(found);
    std::vector<std::string> heads = {"k"};
    std::map<int, std::vector<std::string>> by_hardness;
    for (const auto& l : lines) {
        heads.push_back(escaped(name_of(l.type, l.variant, l.root)));
        for (const auto& r : found.rows) {
            for (const auto& c : r.cells) {
                if (r.group == group.name && l.is(r) && c.hardness >= 0) {
                    auto& cells = by_hardness[c.hardness];
                    cells.resize(std::max(cells.size(), heads.size() - 1));
                    auto& cell = cells[heads.size() - 2];
                    cell += (cell.empty() ? "" : ", ") + readable(c.time_largest);
                    if (c.wrong + c.undecided != 0) {
                        cell += " <b class=\"bad\">" + readable_count(c.wrong + c.undecided) + " of " +
                                readable_count(c.evaluated) + "</b>";
                    }
                }
            }
        }
    }
    std::vector<std::vector<std::string>> rows;
    for (auto& [k, cells] : by_hardness) {
        cells.resize(heads.size() - 1);
        rows.push_back({std::to_string(k)});
        rows.back().insert(rows.back().end(), cells.begin(), cells.end());
    }
    return rows.empty() ? std::string()
                        : "<p>k: " + escaped(group.hardness_name) +
                              ". Units of the last place of a double; wrong or open decisions in bold.</p>\n" +
                              table("figures", heads, rows);
}

} // namespace compare::report
