// Where the balls went, in truth and in a number type.
#include "../input_error.hpp"
#include "run_report.hpp"

#include "../report/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <optional>

namespace compare::run {

namespace {

using report::exactly;
using report::ink;
using report::picture;

// The smallest box around the true paths.
struct box {
    double low[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    double high[2] = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    void take(double x, double y) {
        low[0] = std::min(low[0], x), high[0] = std::max(high[0], x);
        low[1] = std::min(low[1], y), high[1] = std::max(high[1], y);
    }
};

bool moves(const path& p) {
    return std::any_of(p.begin(), p.end(), [&](const auto& q) { return q[1] != p.front()[1] || q[2] != p.front()[2]; });
}

// The points of all paths that move, with an empty line after each; empty if none moves.
std::string points_of(const std::vector<path>& paths) {
    std::string text;
    for (const path& p : paths) {
        const bool goes = moves(p);
        for (std::size_t i = 0; goes && i < p.size(); ++i) {
            text += exactly(p[i][1]) + " " + exactly(p[i][2]) + "\n";
        }
        text += goes ? "\n" : "";
    }
    return text;
}

// The place on the path at time t, which is not before its start.
std::array<double, 2> place_at(const path& p, double t) {
    std::size_t next = 1;
    while (next + 1 < p.size() && p[next][0] < t) {
        ++next;
    }
    const auto &from = p[next - 1], &to = p[next];
    const double share = to[0] > from[0] ? std::min((t - from[0]) / (to[0] - from[0]), 1.0) : 1;
    return {from[1] + share * (to[1] - from[1]), from[2] + share * (to[2] - from[2])};
}

// The first time at which some ball is farther than `distance` from its true place, and that place.
std::optional<std::array<double, 3>> parting(const std::vector<path>& right, const std::vector<path>& found,
                                             double distance) {
    std::optional<std::array<double, 3>> first;
    for (std::size_t i = 0; i < right.size() && i < found.size(); ++i) {
        if (right[i].size() < 2 || found[i].size() < 2) {
            continue;
        }
        const auto are_apart = [&](double t) {
            const auto x = place_at(right[i], t), y = place_at(found[i], t);
            return std::hypot(x[0] - y[0], x[1] - y[1]) > distance;
        };
        std::vector<double> times;
        for (const path* p : {&right[i], &found[i]}) {
            std::transform(p->begin(), p->end(), std::back_inserter(times), [](const auto& q) { return q[0]; });
        }
        std::sort(times.begin(), times.end());
        const double end = std::min(right[i].back()[0], found[i].back()[0]);
        const auto at = std::find_if(times.begin(), times.end(), [&](double t) { return t <= end && are_apart(t); });
        if (at == times.end()) {
            continue;
        }
        double before = at == times.begin() ? *at : *(at - 1), after = *at;
        for (int halvings = 0; halvings < 40; ++halvings) {
            const double middle = before + (after - before) / 2;
            (are_apart(middle) ? after : before) = middle;
        }
        if (!first || after < (*first)[0]) {
            const auto x = place_at(right[i], after);
            first = {after, x[0], x[1]};
        }
    }
    return first;
}

} // namespace

std::string paths_picture(const run_report& r, const judged_history& beside) {
    constexpr int width = 1040, height = 900;
    picture p("paths", width, height,
              "The paths of the balls' centres in " + printable(r.scene, 200) + ": the true ones and those of " +
                  beside.found.type + ".");
    box around;
    for (std::size_t i = 0; i < r.paths.size(); ++i) {
        const path& one = r.paths[i];
        for (const auto& q : one) {
            if (moves(one)) {
                around.take(q[1] - r.radii[i], q[2] - r.radii[i]);
                around.take(q[1] + r.radii[i], q[2] + r.radii[i]);
            }
        }
    }
    if (!(around.low[0] <= around.high[0])) {
        return {};
    }
    const double pad = 0.06 * std::max({around.high[0] - around.low[0], around.high[1] - around.low[1], 1e-300});
    std::string outlines;
    for (const outline& o : r.outlines) {
        for (const auto& q : o.points) {
            outlines += exactly(q[0]) + " " + exactly(q[1]) + "\n";
        }
        outlines += "\n";
    }
    p.margins(62, 20, 40, 46);
    p.add("set size ratio -1");
    p.add("set clip two"); // planes begin and end outside
    p.add("set xrange [" + exactly(around.low[0] - pad) + ":" + exactly(around.high[0] + pad) + "]");
    p.add("set yrange [" + exactly(around.low[1] - pad) + ":" + exactly(around.high[1] + pad) + "]");
    p.label("true", "screen 0.06", "screen 0.98", "left", ink::best);
    p.label(beside.found.type, "screen 0.12", "screen 0.98", "left", ink::bad);
    std::string plots;
    std::string blocks;
    const auto plot = [&](const std::string& name, const std::string& points, const std::string& how) {
        if (!points.empty()) {
            blocks += name + " << END\n" + points + "END\n";
            const bool with_radius = how.find("circles") != std::string::npos;
            plots += (plots.empty() ? "" : ", ") + name + (with_radius ? " using 1:2:3 " : " using 1:2 ") + how;
        }
    };
    plot("$outlines", outlines, "with lines lw 1 lc " + picture::colour(ink::muted));
    plot("$true", points_of(r.paths), "with lines lw 3 lc " + picture::colour(ink::best));
    plot("$type", points_of(beside.found.paths), "with lines lw 1.2 lc " + picture::colour(ink::bad));
    std::string starts, ends, collisions;
    for (std::size_t i = 0; i < r.paths.size(); ++i) {
        const path& one = r.paths[i];
        if (!moves(one)) {
            continue;
        }
        const auto ball = [&](const auto& q) {
            return exactly(q[1]) + " " + exactly(q[2]) + " " + exactly(r.radii[i]) + "\n";
        };
        starts += ball(one.front());
        ends += ball(one.back());
        std::for_each(one.begin() + 1, one.end() - 1, [&](const auto& q) { collisions += ball(q); });
    }
    plot("$starts", starts, "with circles lw 1 dt 2 lc " + picture::colour(ink::best));
    plot("$ends", ends, "with circles lw 1.5 lc " + picture::colour(ink::best));
    plot("$collisions", collisions, "with points pt 7 ps 0.35 lc " + picture::colour(ink::best));
    const double far = 0.01 * std::max(around.high[0] - around.low[0], around.high[1] - around.low[1]);
    const auto apart = parting(r.paths, beside.found.paths, far);
    if (apart) {
        plot("$parting", exactly((*apart)[1]) + " " + exactly((*apart)[2]) + "\n",
             "with points pt 6 ps 2 lw 2 lc " + picture::colour(ink::text));
    }
    char when[64] = "they stay together: no ball is off by 1% of the picture";
    if (apart) {
        std::snprintf(when, sizeof when, "they part at t = %.6g (ring)", (*apart)[0]);
    }
    p.label(when, "screen 0.98", "screen 0.98", "right", ink::text);
    p.add(blocks + "plot " + plots);
    return p.svg();
}

} // namespace compare::run
