// Where the balls went, in truth and in a number type.
#include "run_report.hpp"

#include "../report/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

// One block of points for all paths that go anywhere, an empty line between two; empty if none does.
std::string points_of(const std::vector<path>& paths) {
    std::string text;
    for (const path& p : paths) {
        const bool moves = std::any_of(p.begin(), p.end(),
                                       [&](const auto& q) { return q[1] != p.front()[1] || q[2] != p.front()[2]; });
        for (std::size_t i = 0; moves && i < p.size(); ++i) {
            text += exactly(p[i][1]) + " " + exactly(p[i][2]) + "\n";
        }
        text += moves ? "\n" : "";
    }
    return text;
}

} // namespace

std::string paths_picture(const run_report& r, const judged_history& beside) {
    constexpr int width = 1040, height = 900;
    picture p("paths", width, height,
              "The paths of the balls' centres in " + r.scene + ": the true ones and those of " + beside.found.type +
                  ".");
    box around;
    for (const path& one : r.paths) {
        const bool moves =
            one.size() > 1 && (one.front()[1] != one.back()[1] || one.front()[2] != one.back()[2] || one.size() > 2);
        for (const auto& q : one) {
            if (moves) {
                around.take(q[1], q[2]);
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
            plots += (plots.empty() ? "" : ", ") + name + " using 1:2 with lines " + how;
        }
    };
    plot("$outlines", outlines, "lw 1 lc " + picture::colour(ink::muted));
    plot("$true", points_of(r.paths), "lw 3 lc " + picture::colour(ink::best));
    plot("$type", points_of(beside.found.paths), "lw 1.2 lc " + picture::colour(ink::bad));
    p.add(blocks + "plot " + plots);
    return p.svg();
}

} // namespace compare::run
