// The distribution of errors.
#include "pictures.hpp"

#include "key.hpp"
#include "summary.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace compare::report {
namespace {

constexpr int smallest = -12, greatest = 56; // the exponents of the powers of two of a unit that are drawn

struct distribution {
    std::map<int, std::size_t> below; // b -> errors in [2^b, 2^(b+1)); smallest - 1: no error, or one below the axis
    std::size_t count = 0;
};

void take(distribution& d, const error_statistics& e) {
    d.count += e.count;
    d.below[smallest - 1] += e.exact;
    for (const auto& [b, n] : e.histogram) {
        d.below[std::max(b, smallest - 1)] += n;
    }
}

// The cumulative curve: the share of values with an error of at most 2^x units. What is not a number never counts.
[[nodiscard]] std::string curve(const distribution& d) {
    std::size_t so_far = 0;
    std::string text;
    for (int b = smallest - 1; b < greatest; ++b) {
        const auto at = d.below.find(b);
        so_far += at == d.below.end() ? 0 : at->second;
        text += std::to_string(b + 1) + " " +
                exactly(100.0 * static_cast<double>(so_far) / static_cast<double>(d.count)) + "\n";
    }
    return text;
}

} // namespace

std::string distribution_picture(const results& found, const group_information& group, bool keyed) {
    picture p("distribution", 360, 300 + key_height(found, keyed),
              "The share of the times of impact whose error is at most so many units in the last place of a double");
    std::string blocks, plots;
    int number = 0;
    for (const auto& l : chosen_lines(found)) {
        distribution d;
        for (const auto& r : found.rows) {
            if (r.group == group.name && l.is(r)) {
                take(d, r.error(quantity::time));
                take(d, r.error(quantity::crossing));
            }
        }
        if (d.count != 0) {
            const std::string name = "$curve" + std::to_string(number++);
            blocks += name + " << END\n" + curve(d) + "END\n";
            plots = ", " + name + " using 1:2 with lines lw 2 dt " + (l.dashed ? "(5,3)" : "solid") + " lc " +
                    picture::colour(l.colour) + plots; // so the first line is on top
        }
    }
    if (number == 0) {
        return {};
    }
    p.margins(44, 10, 26, 46 + key_height(found, keyed));
    const auto screen_y = [&](double pixel) { return "screen " + exactly(pixel / p.height()); };
    add_key(p, found, keyed);
    p.add("set xrange [" + std::to_string(smallest) + ":" + std::to_string(greatest) + "]");
    p.add("set yrange [0:101]");
    std::vector<std::pair<double, std::string>> tics;
    for (const int b : {-10, 0, 10, 20, 30, 40, 50}) {
        tics.emplace_back(b, b == 0 ? "1" : power_of(2, b));
    }
    p.tics('x', tics);
    p.tics('y', {{0, "0 %"}, {25, "25 %"}, {50, "50 %"}, {75, "75 %"}, {100, "100 %"}});
    p.add("set arrow from -1,graph 0 to -1,graph 1 nohead back lw 1 dt (4,4) lc " + picture::colour(ink::muted));
    p.label("share of the times", "screen 0.008", screen_y(p.height() - 13.5), "left", ink::muted);
    p.label("error of τ in units in the last place →", "graph 1", screen_y(key_height(found, keyed) + 10.5), "right",
            ink::muted);
    p.label("½ unit", "first -0.3", "graph 0.04", "left", ink::muted, 11);
    p.add(blocks + "plot " + plots.substr(2));
    return p.svg();
}

} // namespace compare::report
