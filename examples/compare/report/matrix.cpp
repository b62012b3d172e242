// The digits wanted, the cheapest type for them, and its cost.
#include "pictures.hpp"

#include "placement.hpp"
#include "summary.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace compare::report {
namespace {

constexpr double letters = 12;

struct bar {
    std::string digits, name;
    double nanoseconds = 0; // 0: no type is good enough
    bool exact = false;

    [[nodiscard]] double length() const { return std::log10(nanoseconds); }
    // Name and cost. If there is too little room, only the name is shortened.
    [[nodiscard]] std::string text(double room) const {
        const std::string cost = nanoseconds > 0 ? ", " + readable_time(nanoseconds) : "";
        return fitted(name, letters, room - width_of(cost, letters)) + cost;
    }
};

[[nodiscard]] std::vector<bar> bars_of(const results& found, bool narrow) {
    std::vector<bar> bars;
    const auto add = [&](const std::string& digits, const std::optional<choice>& c, bool exact) {
        if (c && c->nanoseconds > 0 && std::isfinite(c->nanoseconds)) {
            const std::string type = narrow ? short_name_of(c->type) : c->type;
            bars.push_back({digits, name_of(type, c->variant, c->root), c->nanoseconds, exact});
        } else {
            bars.push_back({digits, "none here", 0, exact});
        }
    };
    for (const auto& d : found.matrix) {
        add(std::to_string(d.digits) + (d.digits == 1 ? " digit" : " digits"), d.cheapest, false);
    }
    add("exact", found.exact, true);
    return bars;
}

} // namespace

std::string matrix_picture(const results& found, format size) {
    const bool narrow = size == format::narrow;
    const auto bars = bars_of(found, narrow);
    double least = 1e300, most = 0;
    for (const auto& b : bars) {
        least = b.nanoseconds > 0 ? std::min(least, b.nanoseconds) : least;
        most = std::max(most, b.nanoseconds);
    }
    if (most == 0) {
        return {};
    }
    const double row_height = narrow ? 38 : 30, left = narrow ? 72 : 84, right = 10, top = 8, bottom = 48;
    const int width = narrow ? 360 : 1040;
    const int height = static_cast<int>(top + bottom + row_height * static_cast<double>(bars.size()));
    const double room = width - left - right, from = std::floor(std::log10(least));
    // The axis is long enough for every text to fit behind its bar. In a narrow picture the texts are above the bars.
    double to = std::max(std::log10(most) + 0.1, from + 1);
    for (const auto& b : bars) {
        if (!narrow && b.nanoseconds > 0) {
            to = std::max(to, from + (b.length() - from) * room / (room - width_of(b.text(room), letters) - 24));
        }
    }

    picture p("matrix", width, height, "The cost of the cheapest number type that is right to so many digits");
    p.margins(left, right, top, bottom);
    p.add("set xrange [" + exactly(from) + ":" + exactly(to) + "]\nset yrange [" + std::to_string(bars.size()) + ":0]");
    p.add("unset ytics\nset grid xtics");
    std::vector<std::pair<double, std::string>> decades;
    for (int decade = static_cast<int>(from); decade <= to; ++decade) {
        decades.emplace_back(decade, readable_time(std::pow(10, decade)));
    }
    p.tics('x', decades);
    p.label("time of one whole solve →", "graph 1", "screen " + exactly(10.0 / height), "right", ink::muted);

    std::string ends; // ends of the bars: gnuplot draws nothing unless something is plotted
    const double upper = narrow ? 0.52 : 0.2, lower = narrow ? 0.86 : 0.8;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const auto& b = bars[i];
        const double y = static_cast<double>(i), end = b.nanoseconds > 0 ? b.length() : from;
        p.label(b.digits, "screen " + exactly((left - 8) / width), "first " + exactly(y + 0.5), "right", ink::text);
        if (b.nanoseconds > 0) {
            p.add("set object rectangle from " + exactly(from) + "," + exactly(y + upper) + " to " + exactly(end) +
                  "," + exactly(y + lower) + " fc " + picture::colour(b.exact ? ink::best : ink::one) +
                  " fs solid noborder");
        }
        p.label(b.text(room), narrow ? "graph 0" : "first " + exactly(end),
                "first " + exactly(y + (narrow ? 0.27 : 0.5)) + (narrow ? "" : " offset 0.8,0"), "left",
                b.nanoseconds > 0 ? ink::text : ink::muted);
        ends += exactly(end) + " " + exactly(y + 0.5) + "\n";
    }
    p.add("$ends << END\n" + ends + "END\nplot $ends using 1:2 with points pt 7 ps 0 lc " +
          picture::colour(ink::paper));
    return p.svg();
}

} // namespace compare::report
