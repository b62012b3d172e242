// Speed against error.
#include "pictures.hpp"

#include "placement.hpp"
#include "summary.hpp"
#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

namespace compare::report {
namespace {

// The error axis: decades down to 10^-20 at full length, then many to a unit, so that a hundred digits and no error at
// all find a place below doubles without crushing them. Heights are in decades of the upper part.
class error_axis {
  public:
    explicit error_axis(const std::vector<candidate>& points) {
        for (const auto& c : points) {
            if (std::isfinite(c.fewest_bits)) {
                const double decade = decade_of(c);
                highest_ = std::max(highest_, std::ceil(decade / 4) * 4);
                lowest_ = std::min(lowest_, decade);
            }
            infinite_ = infinite_ || (std::isinf(c.fewest_bits) && c.fewest_bits < 0);
        }
    }

    [[nodiscard]] static double decade_of(const candidate& c) { return -c.fewest_bits * std::log10(2.0); }
    [[nodiscard]] double top() const { return highest_ + (infinite_ ? 4.5 : 1); }
    [[nodiscard]] double zero() const { return height(std::min(lowest_, bend)) - 2.5; }
    [[nodiscard]] double bottom() const { return zero() - 1.5; }
    [[nodiscard]] bool bends() const { return lowest_ < bend; }
    [[nodiscard]] double height(double decade) const {
        return decade >= bend ? decade : bend - 1 - (bend - decade) * squeeze;
    }
    [[nodiscard]] double height(const candidate& c) const {
        if (std::isinf(c.fewest_bits)) {
            return c.fewest_bits > 0 ? zero() : highest_ + 3;
        }
        return height(decade_of(c));
    }
    [[nodiscard]] std::vector<std::pair<double, std::string>> tics() const {
        std::vector<std::pair<double, std::string>> all = {{zero(), "exact"}};
        for (int decade = static_cast<int>(highest_); decade >= -20; decade -= 4) {
            all.emplace_back(height(decade), decade == 0 ? "1" : power_of_ten(decade));
        }
        for (const int decade : {-30, -50, -70, -100}) {
            if (bends() && decade >= lowest_ - 5) {
                all.emplace_back(height(decade), power_of_ten(decade));
            }
        }
        if (infinite_) {
            all.emplace_back(highest_ + 3, "no number");
        }
        return all;
    }

    static constexpr double bend = -20;

  private:
    static constexpr double squeeze = 0.07;
    double highest_ = 0, lowest_ = bend;
    bool infinite_ = false;
};

// gnuplot's markers: square, circle, triangle, diamond; the hollow one's number is one less.
[[nodiscard]] int marker_of(const std::string& variant) {
    return variant == "textbook" ? 9 : variant == "halved" ? 5 : variant == "kahan" ? 13 : 7;
}

[[nodiscard]] ink colour_of(const candidate& c) {
    if (c.is_exact()) {
        return ink::best;
    }
    if (c.information != nullptr && c.information->is_interval) {
        return ink::open;
    }
    const bool of_machine =
        c.information != nullptr && c.information->library == "built in" && c.information->digits <= 64;
    return of_machine ? ink::one : ink::four;
}

// Rows of a mark and what it means, from left to right, on a new line where the width ends. Returns the lines.
struct key_entry {
    int marker;
    ink colour;
    std::string meaning;
};

[[nodiscard]] std::string point_label(picture& p, const key_entry& e, double x, double y) {
    return "set label \"\" at screen " + exactly(x / p.width()) + ",screen " + exactly(1 - y / p.height()) +
           " point pt " + std::to_string(e.marker) + " ps 0.8 lc " + picture::colour(e.colour) + " front";
}

double add_key(picture& p, const std::vector<key_entry>& entries, double left, double y) {
    double x = left;
    for (const auto& e : entries) {
        const double width = 12 + width_of(e.meaning, 12) + 14;
        if (x > left && x + width > p.width() + 8) {
            x = left, y += 19;
        }
        p.add(point_label(p, e, x + 5, y));
        p.label(e.meaning, "screen " + exactly((x + 15) / p.width()), "screen " + exactly(1 - y / p.height()), "left",
                ink::muted);
        x += width;
    }
    return y + 19;
}

[[nodiscard]] std::string hover_text(const candidate& c) {
    std::ostringstream s;
    s << c.name() << ": " << readable_time(*c.nanoseconds) << ", ";
    if (c.times == 0) {
        s << "no time measured";
    } else if (std::isinf(c.fewest_bits)) {
        s << (c.fewest_bits > 0 ? "no error" : "some times are no number");
    } else {
        s << "largest error of τ " << readable(std::exp2(-c.fewest_bits)) << " (" << readable(c.fewest_bits)
          << " correct bits)";
    }
    s << ", " << counted(c.wrong, "wrong decision", "wrong decisions");
    if (c.undecided != 0) {
        s << ", " << readable_count(c.undecided) << " left open";
    }
    return s.str();
}

} // namespace

std::string speed_picture(const results& found, format size) {
    std::vector<candidate> points = candidates(found);
    std::erase_if(points, [](const candidate& c) { return !c.nanoseconds || !(*c.nanoseconds > 0) || c.times == 0; });
    if (points.empty()) {
        return {};
    }
    const bool narrow = size == format::narrow;
    const error_axis axis(points);
    const auto [fastest, slowest] = std::ranges::minmax(points, {}, [](const candidate& c) { return *c.nanoseconds; });
    const double x_from = std::log10(*fastest.nanoseconds) - 0.15, x_to = std::log10(*slowest.nanoseconds) + 0.25;

    picture p("speed", narrow ? 360 : 1040, narrow ? 520 : 620,
              "Nanoseconds for one pair against the largest relative error of the time of impact, a point for every "
              "number type, variant and root form; the tables below have the same figures.");
    std::vector<key_entry> key = {{9, ink::muted, "textbook"},
                                  {5, ink::muted, "halved"},
                                  {13, ink::muted, "kahan"},
                                  {7, ink::muted, "lagrange"},
                                  {6, ink::muted, "hollow: decided something wrong or not at all"}};
    std::vector<key_entry> colours = {{7, ink::one, "machine floating point"},
                                      {7, ink::four, "software floating point"},
                                      {7, ink::open, "intervals"},
                                      {7, ink::best, "exact"}};
    const double under_key = add_key(p, key, narrow ? 0 : 62, add_key(p, colours, narrow ? 0 : 62, 12));
    const double left = narrow ? 46 : 62, right = 14, top = under_key + 24, bottom = 46;
    p.margins(left, right, top, bottom);
    p.add("set xrange [" + exactly(x_from) + ":" + exactly(x_to) + "]");
    p.add("set yrange [" + exactly(axis.bottom()) + ":" + exactly(axis.top()) + "]");
    std::vector<std::pair<double, std::string>> decades;
    for (int decade = static_cast<int>(std::ceil(x_from)); decade <= x_to; ++decade) {
        decades.emplace_back(decade, readable_time(std::pow(10, decade)));
    }
    p.tics('x', decades);
    p.tics('y', axis.tics());
    p.label("time of one whole solve →", "graph 1", "screen " + exactly(10.0 / p.height()), "right", ink::muted);
    p.label("largest error of τ, relative ↓", "screen " + exactly(narrow ? 0.004 : 0.012),
            "screen " + exactly(1 - (top - 12) / p.height()), "left", ink::muted);

    const double x_scale = (p.width() - left - right) / (x_to - x_from);
    const double y_scale = (p.height() - top - bottom) / (axis.top() - axis.bottom());
    const auto x_pixel = [&](double x) { return left + (x - x_from) * x_scale; };
    const auto y_pixel = [&](double y) { return top + (axis.top() - y) * y_scale; };
    const auto x_of = [](const candidate& c) { return std::log10(*c.nanoseconds); };

    // The line of a correctly rounded double, and the one below which nothing is lost.
    const double half_unit = axis.height(-53 * std::log10(2.0));
    p.add("set arrow from graph 0,first " + exactly(half_unit) + " to graph 1,first " + exactly(half_unit) +
          " nohead back lw 1 dt (4,4) lc " + picture::colour(ink::muted));
    p.label(narrow ? "½ ulp of a double" : "half a unit in the last place of a double", "graph 0.995",
            "first " + exactly(half_unit) + " offset 0,0.5", "right", ink::muted, 11);
    p.add("set arrow from graph 0,first " + exactly(axis.zero()) + " to graph 1,first " + exactly(axis.zero()) +
          " nohead back lw 1.5 lc " + picture::colour(ink::best));
    if (axis.bends()) {
        const std::string at = exactly(error_axis::bend - 0.5);
        p.add("set arrow from graph 0,first " + at + " to graph 1,first " + at + " nohead back lw 1 dt (1,3) lc " +
              picture::colour(ink::muted));
    }

    // The front as a staircase.
    std::vector<const candidate*> front;
    for (const auto& c : points) {
        if (c.on_front) {
            front.push_back(&c);
        }
    }
    std::ranges::sort(front, {}, [](const candidate* c) { return *c->nanoseconds; });
    std::string stairs;
    for (std::size_t i = 0; i < front.size(); ++i) {
        if (i > 0) {
            stairs += exactly(x_of(*front[i])) + " " + exactly(axis.height(*front[i - 1])) + "\n";
        }
        stairs += exactly(x_of(*front[i])) + " " + exactly(axis.height(*front[i])) + "\n";
    }

    // Points alike in marker, colour and size are plotted together.
    std::map<std::tuple<bool, int, ink>, std::string> alike;
    std::vector<box> taken;
    for (const auto& c : points) {
        const bool large = c.on_front || is_plain_double(c.type, c.variant, c.root);
        const int marker = marker_of(c.variant) - (c.decides_right() ? 0 : 1);
        alike[{large, marker, colour_of(c)}] +=
            exactly(x_of(c)) + " " + exactly(axis.height(c)) + " " + p.text(hover_text(c)) + "\n";
        const double x = x_pixel(x_of(c)), y = y_pixel(axis.height(c)), r = large ? 6 : 4;
        taken.push_back({x - r, y - r, x + r, y + r});
    }
    for (std::size_t i = 1; i < front.size(); ++i) {
        const double x0 = x_pixel(x_of(*front[i - 1])), x1 = x_pixel(x_of(*front[i]));
        const double y0 = y_pixel(axis.height(*front[i - 1])), y1 = y_pixel(axis.height(*front[i]));
        taken.push_back({x0, y0 - 2, x1, y0 + 2});
        taken.push_back({x1 - 2, y0, x1 + 2, y1});
    }
    taken.push_back({left, y_pixel(axis.zero()) - 2, p.width() - right, y_pixel(axis.zero()) + 2});
    placement names({left - 4, top, p.width() - 2.0, p.height() - bottom + 4}, std::move(taken));
    for (const auto& c : points) {
        const bool plain = is_plain_double(c.type, c.variant, c.root);
        if (c.on_front || plain) {
            const std::string name = plain ? "plain double" : narrow ? c.type : c.name();
            const double x = x_pixel(x_of(c)), y = y_pixel(axis.height(c));
            const auto at = names.place(name, 12, x, y);
            const auto on_screen = [&](double x_at, double y_at) {
                return "screen " + exactly(x_at / p.width()) + ",screen " + exactly(1 - y_at / p.height());
            };
            p.label(name, "screen " + exactly(at.x / p.width()), "screen " + exactly(1 - at.y / p.height()), at.align,
                    ink::text);
            if (std::hypot(at.x - x, at.y - y) > 30) {
                p.add("set arrow from " + on_screen(x, y) + " to " + on_screen(at.x, at.y + (at.y < y ? 7 : -7)) +
                      " nohead back lw 0.8 lc " + picture::colour(ink::muted));
            }
        }
    }

    std::string plots, blocks;
    if (front.size() > 1) {
        blocks += "$front << END\n" + stairs + "END\n";
        plots += "$front using 1:2 with lines lw 2 lc " + picture::colour(ink::best);
    }
    int block = 0;
    for (const auto& [style, rows] : alike) {
        const auto& [large, marker, role] = style;
        const std::string name = "$points" + std::to_string(block++);
        blocks += name + " << END\n" + rows + "END\n";
        plots += (plots.empty() ? "" : ", ") + name + " using 1:2:3 with labels hypertext point pt " +
                 std::to_string(marker) + " ps " + (large ? "1.15" : "0.75") + " lc " + picture::colour(role);
    }
    p.add(blocks + "plot " + plots);
    return p.svg();
}

} // namespace compare::report
