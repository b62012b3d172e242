// Wrong decisions by group and type: a heat map.
#include "pictures.hpp"

#include "placement.hpp"
#include "summary.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace compare::report {
namespace {

struct line_of_map {
    std::string name;
    std::vector<decision_counts> groups; // in the order of results::groups
};

// A line for each type and variant with a wrong or open decision, in the root form that is worse.
[[nodiscard]] std::vector<line_of_map> lines_of(const results& found) {
    std::vector<line_of_map> lines;
    for (const auto& r : found.rows) {
        const std::string name = r.variant.empty() ? r.type : r.type + " · " + r.variant;
        auto at = std::ranges::find(lines, name, &line_of_map::name);
        if (at == lines.end()) {
            at = lines.insert(lines.end(), {name, std::vector<decision_counts>(found.groups.size())});
        }
        const auto g = std::ranges::find(found.groups, r.group, &group_information::name) - found.groups.begin();
        if (static_cast<std::size_t>(g) < at->groups.size()) {
            auto& counts = at->groups[static_cast<std::size_t>(g)];
            if (counts.evaluated == 0 ||
                r.decisions.wrong() + r.decisions.undecided > counts.wrong() + counts.undecided) {
                counts = r.decisions;
            }
        }
    }
    std::erase_if(lines, [](const line_of_map& l) {
        return std::ranges::all_of(l.groups, [](const decision_counts& d) { return d.wrong() + d.undecided == 0; });
    });
    return lines;
}

[[nodiscard]] std::string hover_text(const line_of_map& l, const group_information& g, const decision_counts& d) {
    std::ostringstream s;
    s << l.name << " on " << g.name << ": ";
    if (d.evaluated == 0) {
        s << "not run";
        return s.str();
    }
    s << readable_count(d.wrong()) << " of " << counted(d.evaluated, "pair", "pairs") << " wrong";
    if (d.hit_or_miss != 0) {
        s << ", " << readable_count(d.hit_or_miss) << " on hit or miss";
    }
    if (d.overlap != 0) {
        s << ", " << readable_count(d.overlap) << " on overlap";
    }
    if (d.approaching != 0) {
        s << ", " << readable_count(d.approaching) << " on approaching";
    }
    if (d.feature != 0) {
        s << ", " << readable_count(d.feature) << " on the feature";
    }
    if (d.failed != 0) {
        s << ", " << readable_count(d.failed) << " without an answer";
    }
    if (d.undecided != 0) {
        s << ", " << readable_count(d.undecided) << " left open";
    }
    return s.str();
}

} // namespace

std::string decisions_picture(const results& found, format size) {
    const auto lines = lines_of(found);
    if (lines.empty()) {
        return {};
    }
    const bool narrow = size == format::narrow;
    const double row_height = 24, head = 96, left = narrow ? 148 : 230, letters = narrow ? 11 : 12;
    const int width = narrow ? 360 : 1040,
              height = static_cast<int>(head + row_height * static_cast<double>(lines.size()) + 8);
    picture p("decisions", width, height, "How many decisions each number type got wrong in each group");
    const double columns = static_cast<double>(found.groups.size());
    const double cell_width = std::min((width - left - 48) / columns, 150.0);
    p.margins(left, width - left - cell_width * columns, head, 8);
    p.add("unset grid\nunset xtics\nunset ytics");
    p.add("set xrange [0:" + exactly(columns) + "]\nset yrange [" + std::to_string(lines.size()) + ":0]");
    for (std::size_t g = 0; g < found.groups.size(); ++g) {
        p.label(fitted(found.groups[g].name, letters, 98), exactly(static_cast<double>(g) + 0.5),
                "screen " + exactly(1 - (head - 8) / height), "left", ink::text, letters, 55);
    }
    std::string marks, hollow;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double y = static_cast<double>(i);
        p.label(fitted(narrow ? short_name_of(lines[i].name) : lines[i].name, letters, left - 8),
                "screen " + exactly((left - 8) / width), "first " + exactly(y + 0.5), "right", ink::text, letters);
        for (std::size_t g = 0; g < found.groups.size(); ++g) {
            const auto& d = lines[i].groups[g];
            const double x = static_cast<double>(g);
            const auto bad = d.wrong() != 0 ? d.wrong() : d.undecided;
            const double share = d.evaluated == 0 ? 0 : static_cast<double>(bad) / static_cast<double>(d.evaluated);
            // A single wrong decision must be visible: the scale is logarithmic, from 1 in 10,000 to one half.
            const double shade =
                bad == 0 ? 0 : std::clamp(0.15 + 0.6 * (1 + std::log10(std::max(2 * share, 2e-4)) / 3.7), 0.15, 0.75);
            p.add("set object rectangle from " + exactly(x + 0.03) + "," + exactly(y + 0.06) + " to " +
                  exactly(x + 0.97) + "," + exactly(y + 0.94) + " fc " +
                  picture::colour(bad == 0         ? ink::grid
                                  : d.wrong() != 0 ? ink::bad
                                                   : ink::open) +
                  " fs transparent solid " + exactly(bad == 0 ? 0.5 : shade) + " noborder");
            const std::string shown = d.evaluated == 0 ? "" : bad == 0 ? "0" : readable_count(bad);
            if (width_of(shown, letters) < cell_width - 2) {
                p.label(shown, exactly(x + 0.5), exactly(y + 0.5), "center", bad == 0 ? ink::muted : ink::text,
                        letters);
            }
            marks += exactly(x + 0.5) + " " + exactly(y + 0.5) + " " +
                     p.text(hover_text(lines[i], found.groups[g], d)) + "\n";
        }
    }
    p.add("$cells << END\n" + marks +
          "END\nplot $cells using 1:2:3 with labels hypertext point pt 5 ps 2.4 lc rgb \"#ff000000\"");
    return p.svg();
}

} // namespace compare::report
