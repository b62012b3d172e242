// One page: the differences of two results, and the history of many.
#include "../answer.hpp"
#include "../diff.hpp"
#include "../report.hpp"
#include "../whole_file.hpp"
#include "error_axis.hpp"
#include "gnuplot.hpp"
#include "picture.hpp"
#include "style.hpp"
#include "summary.hpp"
#include "tables.hpp"
#include "text.hpp"
#include "words.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace compare {
namespace report {
namespace {

struct side {
    std::vector<candidate> front;
    ink colour;
    std::string name;
};

[[nodiscard]] side side_of(const results& found, ink colour, const std::string& name) {
    side s{candidates(found), colour, name};
    std::erase_if(s.front, [](const candidate& c) { return !c.on_front || !(*c.nanoseconds > 0); });
    std::ranges::sort(s.front, {}, [](const candidate& c) { return *c.nanoseconds; });
    return s;
}

// The fronts before and after. A point is on a front if nothing is both faster and better.
[[nodiscard]] std::string frontiers_picture(const results& before, const results& after, bool narrow) {
    const std::vector<side> sides = {side_of(before, ink::muted, "old"), side_of(after, ink::best, "new")};
    std::vector<candidate> all;
    for (const side& s : sides) {
        all.insert(all.end(), s.front.begin(), s.front.end());
    }
    if (all.empty()) {
        return {};
    }
    const error_axis axis(all);
    double from = 1e9, to = -1e9;
    for (const candidate& c : all) {
        from = std::min(from, std::log10(*c.nanoseconds) - 0.2), to = std::max(to, std::log10(*c.nanoseconds) + 0.3);
    }
    picture p("frontiers", narrow ? 360 : 1040, narrow ? 420 : 460,
              "The best trade-offs of time and error in the old and in the new results");
    p.margins(narrow ? 46 : 62, narrow ? 20 : 14, 46, 46);
    p.add("set xrange [" + exactly(from) + ":" + exactly(to) + "]");
    p.add("set yrange [" + exactly(axis.bottom()) + ":" + exactly(axis.top()) + "]");
    std::vector<std::pair<double, std::string>> decades;
    for (int decade = static_cast<int>(std::ceil(from)); decade <= to; ++decade) {
        decades.emplace_back(decade, readable_time(std::pow(10, decade)));
    }
    p.tics('x', decades);
    p.tics('y', axis.tics());
    const auto y_of = [&](double pixel) { return "screen " + exactly(1 - pixel / p.height()); };
    p.label("time of one whole solve →", "graph 1", y_of(p.height() - 10.0), "right", ink::muted);
    p.label("largest error of τ, relative ↓", "screen 0.01", y_of(34), "left", ink::muted);
    std::string blocks, plots;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const side& s = sides[i];
        p.label(s.name, "screen " + exactly(0.02 + 0.08 * static_cast<double>(i) * (narrow ? 2 : 1)), y_of(12), "left",
                s.colour);
        std::string stairs, points;
        for (std::size_t k = 0; k < s.front.size(); ++k) {
            for (const candidate* level : {&s.front[k == 0 ? 0 : k - 1], &s.front[k]}) {
                stairs += exactly(std::log10(*s.front[k].nanoseconds)) + " " + exactly(axis.height(*level)) + "\n";
            }
            const candidate& c = s.front[k];
            points += exactly(std::log10(*c.nanoseconds)) + " " + exactly(axis.height(c)) + " " +
                      p.text(s.name + ": " + c.name() + ", " + readable_time(*c.nanoseconds)) + "\n";
        }
        const std::string number = std::to_string(i);
        blocks += "$stairs" + number + " << END\n" + stairs + "END\n$points" + number + " << END\n" + points + "END\n";
        plots += std::string(plots.empty() ? "" : ", ") + "$stairs" + number + " using 1:2 with lines lw 2 lc " +
                 picture::colour(s.colour) + ", $points" + number +
                 " using 1:2:3 with labels hypertext point pt 7 ps 1 lc " + picture::colour(s.colour);
    }
    p.add(blocks + "plot " + plots);
    return p.svg();
}

// Correct digits over the results, a line for each type in its typical form.
[[nodiscard]] std::string history_picture(const std::vector<results>& all, const std::string& group, bool narrow) {
    const std::vector<line> lines = chosen_lines(all.back());
    std::string blocks, plots;
    double most = 1;
    picture p("history", narrow ? 360 : 1040, narrow ? 300 : 320,
              "Correct digits of the worst time over the results, in " + group);
    int number = 0;
    for (const row_history& h : history_of(all)) {
        const auto drawn = std::ranges::find_if(
            lines, [&](const line& l) { return l.type == h.type && l.variant == h.variant && l.root == h.root; });
        if (h.group != group || drawn == lines.end()) {
            continue;
        }
        std::string points;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (h.digits[i] && std::isfinite(*h.digits[i])) {
                most = std::max(most, *h.digits[i]);
                points += std::to_string(i + 1) + " " + exactly(*h.digits[i]) + " " +
                          p.text(name_of(h.type, h.variant, h.root) + ": " + readable(*h.digits[i]) + " digits") + "\n";
            }
        }
        if (points.empty()) {
            continue;
        }
        const std::string name = "$line" + std::to_string(number++);
        blocks += name + " << END\n" + points + "END\n";
        plots += (plots.empty() ? "" : ", ") + name + " using 1:2 with lines lw 2 lc " +
                 picture::colour(drawn->colour) + ", " + name +
                 " using 1:2:3 with labels hypertext point pt 7 ps 0.8 lc " + picture::colour(drawn->colour);
    }
    if (plots.empty()) {
        return {};
    }
    p.margins(narrow ? 34 : 50, 12, 26, 40);
    p.add("set xrange [0.8:" + exactly(static_cast<double>(all.size()) + 0.2) +
          "]\nset yrange [0:" + exactly(most * 1.08) + "]\nset xtics 1");
    p.label("correct digits ↑", "screen 0.01", "screen 0.96", "left", ink::muted);
    p.label("result →", "graph 1", "screen 0.03", "right", ink::muted);
    p.add(blocks + "plot " + plots);
    return p.svg();
}

[[nodiscard]] std::string list_of(const std::vector<std::string>& lines) {
    std::string html = "<ul>";
    for (const std::string& line : lines) {
        html += "<li>" + escaped(line);
    }
    return html + "</ul>\n";
}

[[nodiscard]] std::string changes_table(const std::vector<change>& changes) {
    std::vector<std::vector<std::string>> rows;
    for (const change& c : changes) {
        rows.push_back({escaped(c.row), escaped(c.what), escaped(c.before), escaped(c.after),
                        std::isfinite(c.by) ? readable(std::exp2(c.by)) + " times" : "–"});
    }
    return table("figures", {"row", "what", "old", "new", "by"}, rows);
}

[[nodiscard]] std::string figure_of(const std::function<std::string(bool)>& picture, const std::string& nothing) {
    try {
        const std::string wide = picture(false);
        return wide.empty() ? "<p class=\"under\">" + nothing + "</p>\n"
                            : "<figure><div class=\"wide\">" + wide + "</div><div class=\"narrow\">" + picture(true) +
                                  "</div><output></output></figure>\n";
    } catch (const gnuplot_error& e) {
        return "<p class=\"under\">No picture: " + escaped(e.what()) + ".</p>\n";
    }
}

[[nodiscard]] std::string history_section(const std::vector<results>& all, const std::vector<std::string>& names) {
    std::vector<std::vector<std::string>> runs, rows;
    std::vector<std::string> heads = {"row"};
    for (std::size_t i = 0; i < all.size(); ++i) {
        runs.push_back({std::to_string(i + 1), escaped(names[i]), escaped(all[i].machine.date),
                        escaped(all[i].machine.graze), escaped(all[i].machine.compiler)});
        heads.push_back(std::to_string(i + 1));
    }
    for (const row_history& h : history_of(all)) {
        std::vector<std::string> cells = {escaped(h.group + ": " + name_of(h.type, h.variant, h.root))};
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string digits = !h.digits[i]                  ? "–"
                                       : std::isfinite(*h.digits[i]) ? readable(*h.digits[i])
                                       : *h.digits[i] > 0            ? "exact"
                                                                     : "none";
            const std::string wrong = h.wrong[i].value_or(0) > 0 ? ", " + readable_count(*h.wrong[i]) + " wrong" : "";
            cells.push_back(digits + " <small>" + (h.nanoseconds[i] ? readable_time(*h.nanoseconds[i]) : "") + wrong +
                            "</small>");
        }
        rows.push_back(std::move(cells));
    }
    std::string html = "<section id=\"history\"><h2>The history of " + std::to_string(all.size()) + " results</h2>\n" +
                       table("words", {"result", "file", "made", "graze", "compiler"}, runs);
    for (const group_information& g : all.back().groups) {
        html += "<h3>" + escaped(g.name) + "</h3>\n" +
                figure_of([&](bool narrow) { return history_picture(all, g.name, narrow); }, "Nothing to draw.");
    }
    return html + "<details><summary>Correct digits of the worst time, and the time of a solve</summary>\n" +
           table("figures", heads, rows) + "</details></section>\n";
}

} // namespace
} // namespace report

void write_diff_report(const std::vector<results>& all, const std::vector<std::string>& names, const difference& found,
                       const std::string& path) {
    using namespace report;
    const results &before = all[all.size() - 2], &after = all.back();
    std::string body = "<header>\n<h1>What changed</h1>\n<p class=\"under\">" + escaped(names[all.size() - 2]) +
                       ", then " + escaped(names.back()) + "</p>\n<p class=\"answer\">" +
                       counted(found.worse.size(), "value got worse", "values got worse") + ", " +
                       std::to_string(found.better.size()) + " better; of " +
                       counted(found.times_compared, "time, ", "times, ") + std::to_string(found.slower.size()) +
                       " slower, " + std::to_string(found.faster.size()) + " faster.</p>\n";
    if (!found.other_pairs.empty()) {
        body +=
            "<div class=\"notice\"><p><strong>The settings differ.</strong> The results are not of the same pairs, so "
            "this page does not compare like with like.</p>" +
            list_of(found.other_pairs) + "</div>\n";
    }
    if (!found.other_build.empty()) {
        body += "<p>The builds differ:</p>" + list_of(found.other_build);
    }
    body += "</header>\n<section id=\"frontiers\"><h2>Both frontiers</h2>\n<p>A type is on a frontier if none is both "
            "faster and better, among the types that decide every pair right. <span class=\"pointing\">Point at "
            "or touch a mark to read its name.</span></p>\n" +
            figure_of([&](bool narrow) { return frontiers_picture(before, after, narrow); }, "Nothing was timed.") +
            "</section>\n";
    const auto section = [&](const std::string& id, const std::string& head, const std::vector<change>& changes) {
        body += "<section id=\"" + id + "\"><h2>" + head + " (" + std::to_string(changes.size()) + ")</h2>\n" +
                (changes.empty() ? "<p class=\"under\">Nothing.</p>\n" : changes_table(changes)) + "</section>\n";
    };
    section("worse", "Worse, the largest changes first", found.worse);
    section("better", "Better, the largest changes first", found.better);
    body +=
        std::string("<p>Times are compared ") +
        (found.old_has_repeats ? "over their repeats, by the Mann–Whitney test; a time moved if its median and its "
                                 "least repeat differ by more than 10 % and chance is below 1 % over all rows (Holm)"
                               : "by their quartiles: the older file holds no repeats") +
        ". What all rows have in common is left out: " + readable(100 * (found.common_ratio - 1)) + " %.</p>\n";
    section("slower", "Slower", found.slower);
    section("faster", "Faster", found.faster);
    for (const auto& [head, lines] :
         {std::pair("Not compared, measured on different numbers of pairs", &found.not_comparable),
          std::pair("Only in the old results", &found.only_old),
          std::pair("Only in the new results", &found.only_new)}) {
        if (!lines->empty()) {
            body += std::string("<details><summary>") + head + " (" + std::to_string(lines->size()) + ")</summary>\n" +
                    list_of(*lines) + "</details>\n";
        }
    }
    if (all.size() > 2) {
        body += history_section(all, names);
    }
    write_whole_file(path, std::string(words::before_title) + "<title>graze: what changed</title>\n<style>\n" +
                               style() + "</style>\n</head>\n<body>\n<main>\n" + body + words::after_all + words::end);
}

} // namespace compare
