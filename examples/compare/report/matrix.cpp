// Digits wanted, the cheapest type, its cost.
#include "pictures.hpp"

#include "summary.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>

namespace compare::report {

std::string matrix_picture(const results& found, format size) {
    struct bar {
        std::string digits, name;
        double nanoseconds;
        bool exact;
    };
    std::vector<bar> bars;
    for (const auto& d : found.matrix) {
        bars.push_back({counted(static_cast<unsigned long long>(std::max(d.digits, 0)), "digit", "digits"),
                        d.cheapest ? name_of(d.cheapest->type, d.cheapest->variant, d.cheapest->root) : "none here",
                        d.cheapest ? d.cheapest->nanoseconds : 0, false});
    }
    if (found.exact) {
        bars.push_back({"exact", name_of(found.exact->type, found.exact->variant, found.exact->root),
                        found.exact->nanoseconds, true});
    }
    double least = 0, most = 0;
    for (const auto& b : bars) {
        if (b.nanoseconds > 0) {
            least = least == 0 ? b.nanoseconds : std::min(least, b.nanoseconds);
            most = std::max(most, b.nanoseconds);
        }
    }
    if (most == 0) {
        return {};
    }
    const bool narrow = size == format::narrow;
    const double row_height = narrow ? 38 : 30, left = narrow ? 72 : 84, top = 8, bottom = 48;
    const int width = narrow ? 360 : 1040,
              height = static_cast<int>(top + bottom + row_height * static_cast<double>(bars.size()));
    picture p("matrix", width, height, "The cost of the cheapest number type that is right to so many digits");
    p.margins(left, 10, top, bottom);
    const double from = std::floor(std::log10(least)), to = std::max(std::log10(most) + (narrow ? 0.1 : 1.2), from + 1);
    p.add("set xrange [" + exactly(from) + ":" + exactly(to) + "]\nset yrange [" + std::to_string(bars.size()) + ":0]");
    p.add("unset ytics\nset grid xtics");
    std::vector<std::pair<double, std::string>> tics;
    for (int decade = static_cast<int>(from); decade <= to; ++decade) {
        tics.emplace_back(decade, readable_time(std::pow(10, decade)));
    }
    p.tics('x', tics);
    p.label("time of one whole solve →", "graph 1", "screen " + exactly(10.0 / height), "right", ink::muted);
    std::string rows;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const auto& b = bars[i];
        const double y = static_cast<double>(i), upper = narrow ? 0.52 : 0.2, lower = narrow ? 0.86 : 0.8;
        p.label(b.digits, "screen " + exactly((left - 8) / width), "first " + exactly(y + 0.5), "right", ink::text);
        const std::string said = b.nanoseconds > 0 ? b.name + ", " + readable_time(b.nanoseconds) : b.name;
        const double end = b.nanoseconds > 0 ? std::log10(b.nanoseconds) : from;
        if (b.nanoseconds > 0) {
            p.add("set object rectangle from " + exactly(from) + "," + exactly(y + upper) + " to " + exactly(end) +
                  "," + exactly(y + lower) + " fc " + picture::colour(b.exact ? ink::best : ink::one) +
                  " fs solid noborder");
        }
        if (narrow) {
            p.label(said, "graph 0", "first " + exactly(y + 0.27), "left", b.nanoseconds > 0 ? ink::text : ink::muted);
        } else {
            p.label(said, "first " + exactly(end), exactly(y + 0.5) + " offset 0.8,0", "left",
                    b.nanoseconds > 0 ? ink::text : ink::muted);
        }
        rows += exactly(end) + " " + exactly(y + 0.5) + "\n";
    }
    p.add("$ends << END\n" + rows + "END\nplot $ends using 1:2 with points pt 7 ps 0 lc " +
          picture::colour(ink::paper));
    return p.svg();
}

} // namespace compare::report
