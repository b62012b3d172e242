// The cost of exactness: the share of answers that are not right to the last bit.
#include "pictures.hpp"

#include "marks.hpp"
#include "placement.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace compare::report {
namespace {

constexpr double none = -5.5; // the height of points without a wrong answer, below 10^-5

[[nodiscard]] double height_of(const candidate& c) {
    return c.imperfect > 0 ? std::max(std::log10(c.imperfect), none + 0.5) : none;
}

// The points such that nothing is both cheaper and more often right.
[[nodiscard]] std::vector<const candidate*> front_of(const std::vector<candidate>& points) {
    std::vector<const candidate*> front;
    for (const auto& c : points) {
        if (std::ranges::none_of(points, [&](const candidate& other) {
                return (*other.nanoseconds < *c.nanoseconds && other.imperfect <= c.imperfect) ||
                       (*other.nanoseconds <= *c.nanoseconds && other.imperfect < c.imperfect);
            })) {
            front.push_back(&c);
        }
    }
    return front;
}

[[nodiscard]] std::string exactness_hover_text(const candidate& c) {
    return c.name() + ": " + readable_time(*c.nanoseconds) + ", " +
           (c.imperfect > 0 ? readable(100 * c.imperfect) + "% of the answers not right to the last bit"
                            : "every answer right to the last bit");
}

} // namespace

std::string exactness_picture(const results& found, format size) {
    std::vector<candidate> points = candidates(found);
    std::erase_if(points, [](const candidate& c) { return !c.nanoseconds || !(*c.nanoseconds > 0) || c.times == 0; });
    if (points.empty()) {
        return {};
    }
    const bool narrow = size == format::narrow;
    const double left = narrow ? 46 : 62, right = 20, top = 30, bottom = 46;
    picture p("exactness", narrow ? 360 : 1040, narrow ? 420 : 460,
              "Nanoseconds for one pair against the share of the answers that are not right to the last bit, a point "
              "for every number type, variant and root form; the tables have the same figures.");
    double from = 1e9, to = -1e9;
    for (const auto& c : points) {
        from = std::min(from, std::log10(*c.nanoseconds) - 0.15);
        to = std::max(to, std::log10(*c.nanoseconds) + 0.35);
    }
    p.margins(left, right, top, bottom);
    p.add("set xrange [" + exactly(from) + ":" + exactly(to) + "]");
    p.add("set yrange [" + exactly(none - 0.4) + ":0.3]");
    std::vector<std::pair<double, std::string>> decades, shares = {{none, "none"}};
    for (int decade = static_cast<int>(std::ceil(from)); decade <= to; ++decade) {
        decades.emplace_back(decade, readable_time(std::pow(10, decade)));
    }
    for (int decade = -5; decade <= 0; ++decade) {
        shares.emplace_back(decade, readable(100 * std::pow(10, decade)) + "%");
    }
    p.tics('x', decades);
    p.tics('y', shares);
    const auto pixel_x = [&](const candidate& c) {
        return left + (std::log10(*c.nanoseconds) - from) * (p.width() - left - right) / (to - from);
    };
    const auto pixel_y = [&](const candidate& c) {
        return top + (0.3 - height_of(c)) * (p.height() - top - bottom) / (0.7 - none);
    };
    const auto screen_x = [&](double x) { return "screen " + exactly(x / p.width()); };
    const auto screen_y = [&](double y) { return "screen " + exactly(1 - y / p.height()); };
    p.label("time of one answer →", "graph 1", screen_y(p.height() - 10), "right", ink::muted);
    p.label("answers that are not right to the last bit ↓", screen_x(narrow ? 1 : 12), screen_y(top - 14), "left",
            ink::muted);

    std::vector<box> occupied;
    std::map<std::tuple<int, ink>, std::string> alike;
    for (const auto& c : points) {
        occupied.push_back({pixel_x(c) - 5, pixel_y(c) - 5, pixel_x(c) + 5, pixel_y(c) + 5});
        alike[{marker_of(c.variant) - (c.decides_right() ? 0 : 1), colour_of(c)}] +=
            exactly(std::log10(*c.nanoseconds)) + " " + exactly(height_of(c)) + " " + p.text(exactness_hover_text(c)) +
            "\n";
    }
    placement places({left - 4, top, p.width() - 2.0, p.height() - bottom + 4.0}, occupied);
    std::vector<const candidate*> named; // of formulas in a type, only those that are always right, and plain double
    for (const auto& c : points) {
        if (is_plain_double(c.type, c.variant, c.root) || c.variant.empty()) {
            named.push_back(&c);
        }
    }
    for (const auto* c : front_of(points)) {
        if (c->imperfect == 0 && std::ranges::find(named, c) == named.end()) {
            named.push_back(c);
        }
    }
    for (const auto* c : named) {
        const std::string name = narrow ? short_name_of(c->type) : c->name();
        const auto at = places.place(name, 12, pixel_x(*c), pixel_y(*c));
        p.label(name, screen_x(at.x), screen_y(at.y), at.align, ink::text);
    }
    std::string blocks, plots;
    int count = 0;
    for (const auto& [style, rows] : alike) {
        const std::string name = "$block" + std::to_string(count++);
        blocks += name + " << END\n" + rows + "END\n";
        plots += (plots.empty() ? "" : ", ") + name + " using 1:2:3 with labels hypertext point pt " +
                 std::to_string(std::get<0>(style)) + " ps 0.9 lc " + picture::colour(std::get<1>(style));
    }
    p.add(blocks + "plot " + plots);
    return p.svg();
}

} // namespace compare::report
