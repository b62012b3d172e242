// Error against hardness.
#include "pictures.hpp"

#include "key.hpp"
#include "summary.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace compare::report {
namespace {

// The relative error of e units of the last place is 2^-bits; this is bits. (A unit is between 2^-53 and 2^-52 of the
// value.)
[[nodiscard]] double correct_bits(double units) { return 52.5 - std::log2(units); }

[[nodiscard]] std::optional<double> largest_of(const cell& c, quantity what) {
    return what == quantity::discriminant ? c.discriminant_largest : c.time_largest;
}
[[nodiscard]] std::optional<double> largest_of(const conditioning& c, quantity what) {
    return what == quantity::discriminant ? c.discriminant_largest : c.time_largest;
}

// k -> the most bits lost, over all kinds of pair. A relative error of half a unit of the type counts as no loss.
[[nodiscard]] std::map<int, double> bits_lost(const results& found, const group_information& group, const line& l,
                                              quantity what) {
    std::map<int, double> lost;
    for (const auto& r : found.rows) {
        if (r.group != group.name || !l.is(r)) {
            continue;
        }
        for (const auto& c : r.cells) {
            const auto largest = largest_of(c, what);
            if (c.hardness >= 0 && largest && !std::isnan(*largest)) {
                const double all = l.digits + 8.0; // not even the exponent is right
                const double bits = *largest == 0 ? 0 : std::clamp(l.digits - correct_bits(*largest), 0.0, all);
                lost[c.hardness] = std::max(lost[c.hardness], bits);
            }
        }
    }
    return lost;
}

[[nodiscard]] std::map<int, double> envelope(const group_information& group, quantity what) {
    std::map<int, double> lost;
    for (const auto& c : group.conditions) {
        const auto largest = largest_of(c, what);
        if (c.hardness >= 0 && largest && *largest > 0 && std::isfinite(*largest)) {
            lost[c.hardness] = std::max(lost[c.hardness], std::log2(*largest));
        }
    }
    return lost;
}

[[nodiscard]] std::string block(const std::string& name, const std::map<int, double>& points) {
    std::string text = name + " << END\n";
    for (const auto& [k, bits] : points) {
        text += std::to_string(k) + " " + exactly(bits) + "\n";
    }
    return text + "END\n";
}

} // namespace

std::string hardness_picture(const results& found, const group_information& group, quantity what, bool keyed) {
    const auto own = envelope(group, what);
    std::string blocks, plots;
    double most = 0;
    int first = 0, last = 0;
    bool any = false;
    const auto take = [&](const std::map<int, double>& points) {
        for (const auto& [k, bits] : points) {
            first = any ? std::min(first, k) : k, last = any ? std::max(last, k) : k, most = std::max(most, bits);
            any = true;
        }
    };
    picture p("hardness", 360, 300 + key_height(found, keyed),
              "Bits lost by number types against " + group.hardness_name);
    int number = 0;
    for (const auto& l : chosen_lines(found)) {
        const auto points = bits_lost(found, group, l, what);
        if (!points.empty()) {
            take(points);
            const std::string name = "$line" + std::to_string(number++);
            blocks += block(name, points);
            plots = ", " + name + " using 1:2 with lines lw 2 dt " + (l.dashed ? "(5,3)" : "solid") + " lc " +
                    picture::colour(l.colour) + plots; // so the first line is on top
        }
    }
    if (!any) {
        return {};
    }
    if (!own.empty()) {
        take(own);
        blocks += block("$own", own);
        plots = ", $own using 1:2 with filledcurves y1=0 fs transparent solid 0.16 noborder lc " +
                picture::colour(ink::muted) + plots;
    }
    p.margins(34, 8, 26, 46 + key_height(found, keyed));
    const auto screen_y = [&](double pixel) { return "screen " + exactly(pixel / p.height()); };
    add_key(p, found, keyed);
    p.add("set xrange [" + std::to_string(first) + ":" + std::to_string(std::max(last, first + 1)) + "]");
    p.add("set yrange [-1:" + exactly(std::min(std::max(most, 10.0), 124.0) * 1.03) + "]");
    p.add("set xtics 10");
    p.add("set ytics 10");
    p.label("bits lost", "screen 0.008", screen_y(p.height() - 13.5), "left", ink::muted);
    p.label(group.hardness_name + " →", "graph 1", screen_y(key_height(found, keyed) + 10.5), "right", ink::muted);
    p.add(blocks + "plot " + plots.substr(2));
    return p.svg();
}

} // namespace compare::report
