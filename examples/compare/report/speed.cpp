// Speed against error.
#include "pictures.hpp"

#include "error_axis.hpp"
#include "marks.hpp"
#include "placement.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

namespace compare::report {
namespace {

[[nodiscard]] bool is_plain(const candidate& c) { return is_plain_double(c.type, c.variant, c.root); }

[[nodiscard]] double x_of(const candidate& c) { return std::log10(*c.nanoseconds); }

[[nodiscard]] std::string speed_hover_text(const candidate& c) {
    std::ostringstream s;
    s << c.name() << ": " << readable_time(*c.nanoseconds) << ", ";
    if (std::isinf(c.fewest_bits)) {
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

// Lays out one picture and draws it from back to front.
class speed_plot {
  public:
    speed_plot(std::vector<candidate> points, bool narrow)
        : points_(std::move(points)), axis_(points_), narrow_(narrow),
          p_("speed", narrow ? 360 : 1040, narrow ? 570 : 660,
             "Nanoseconds for one pair against the largest relative error of the time of impact, a point for every "
             "number type, variant and root form; the tables have the same figures.") {
        for (const auto& c : points_) {
            from_ = std::min(from_, x_of(c) - 0.15), to_ = std::max(to_, x_of(c) + 0.25);
            if (c.on_front) {
                front_.push_back(&c);
            }
        }
        std::ranges::sort(front_, {}, [](const candidate* c) { return *c->nanoseconds; });
    }

    [[nodiscard]] std::string svg() {
        key();
        axes();
        guides();
        names();
        front();
        marks();
        p_.add(blocks_ + "plot " + plots_);
        return p_.svg();
    }

  private:
    std::vector<candidate> points_;
    error_axis axis_;
    bool narrow_;
    picture p_;
    std::vector<const candidate*> front_;
    double from_ = 1e9, to_ = -1e9;                                                       // decades of nanoseconds
    double left_ = narrow_ ? 46 : 62, right_ = narrow_ ? 20 : 14, top_ = 0, bottom_ = 46; // pixels
    std::string blocks_, plots_;

    [[nodiscard]] double pixel_x(const candidate& c) const {
        return left_ + (x_of(c) - from_) * (p_.width() - left_ - right_) / (to_ - from_);
    }
    [[nodiscard]] double pixel_y(double height) const {
        return top_ + (axis_.top() - height) * (p_.height() - top_ - bottom_) / (axis_.top() - axis_.bottom());
    }
    [[nodiscard]] double pixel_y(const candidate& c) const { return pixel_y(axis_.height(c)); }
    [[nodiscard]] std::string screen_x(double pixel) const { return "screen " + exactly(pixel / p_.width()); }
    [[nodiscard]] std::string screen_y(double pixel) const { return "screen " + exactly(1 - pixel / p_.height()); }

    void key();
    double key_line(const std::vector<std::tuple<int, ink, std::string>>& entries, double y);
    void axes();
    void guides();
    void level(double height, const std::string& style, ink role);
    void names();
    [[nodiscard]] std::vector<box> occupied() const;
    [[nodiscard]] std::vector<const candidate*> named() const;
    void front();
    void marks();
    void plot(const std::string& rows, const std::string& how);
};

void speed_plot::key() {
    std::vector<std::tuple<int, ink, std::string>> kinds = {{7, ink::one, "machine floating point"},
                                                            {7, ink::four, "software floating point"},
                                                            {7, ink::open, "intervals"},
                                                            {7, ink::best, "exact, and graze"}};
    if (std::ranges::any_of(points_, is_peer)) {
        kinds.emplace_back(7, ink::five, "collision libraries");
    }
    const double below = key_line(kinds, 12);
    top_ = 24 + key_line({{marker_of("textbook"), ink::muted, "textbook"},
                          {marker_of("halved"), ink::muted, "halved"},
                          {marker_of("kahan"), ink::muted, "kahan"},
                          {marker_of("lagrange"), ink::muted, "lagrange"},
                          {6, ink::muted, "hollow: decided something wrong or not at all"}},
                         below);
}

// Draws marks and their meaning on as many lines as they need. Returns the height of the next line.
double speed_plot::key_line(const std::vector<std::tuple<int, ink, std::string>>& entries, double y) {
    const double start = narrow_ ? 0 : left_;
    double x = start;
    for (const auto& [marker, role, meaning] : entries) {
        const double width = 26 + width_of(meaning, 12);
        if (x > start && x + width > p_.width() + 8) {
            x = start, y += 19;
        }
        p_.add("set label \"\" at " + screen_x(x + 5) + "," + screen_y(y) + " point pt " + std::to_string(marker) +
               " ps 0.8 lc " + picture::colour(role) + " front");
        p_.label(meaning, screen_x(x + 15), screen_y(y), "left", ink::muted);
        x += width;
    }
    return y + 19;
}

void speed_plot::axes() {
    p_.margins(left_, right_, top_, bottom_);
    p_.add("set xrange [" + exactly(from_) + ":" + exactly(to_) + "]");
    p_.add("set yrange [" + exactly(axis_.bottom()) + ":" + exactly(axis_.top()) + "]");
    std::vector<std::pair<double, std::string>> decades;
    for (int decade = static_cast<int>(std::ceil(from_)); decade <= to_; ++decade) {
        decades.emplace_back(decade, readable_time(std::pow(10, decade)));
    }
    p_.tics('x', decades);
    p_.tics('y', axis_.tics());
    p_.label("time of one whole solve →", "graph 1", screen_y(p_.height() - 10), "right", ink::muted);
    p_.label("largest error of τ, relative ↓", screen_x(narrow_ ? 1 : 12), screen_y(top_ - 12), "left", ink::muted);
}

void speed_plot::level(double height, const std::string& style, ink role) {
    const std::string y = ",first " + exactly(height);
    p_.add("set arrow from graph 0" + y + " to graph 1" + y + " nohead back " + style + " lc " + picture::colour(role));
}

// Correctly rounded doubles are below the first line; the last line is for no error.
void speed_plot::guides() {
    const double half_unit = axis_.height(-53 * std::log10(2.0));
    level(half_unit, "lw 1 dt (4,4)", ink::muted);
    p_.label(narrow_ ? "½ unit of a double" : "half a unit in the last place of a double", "graph 0.995",
             "first " + exactly(half_unit) + " offset 0,0.5", "right", ink::muted, 11);
    if (axis_.bends()) {
        level(error_axis::bend - 0.5, "lw 1 dt (1,3)", ink::muted);
    }
    level(axis_.no_error(), "lw 1.5", ink::best);
}

std::vector<box> speed_plot::occupied() const {
    std::vector<box> all;
    for (const auto& c : points_) {
        const double x = pixel_x(c), y = pixel_y(c), r = c.on_front || is_plain(c) ? 6 : 4;
        all.push_back({x - r, y - r, x + r, y + r});
    }
    for (std::size_t i = 1; i < front_.size(); ++i) {
        const double x0 = pixel_x(*front_[i - 1]), x1 = pixel_x(*front_[i]);
        const double y0 = pixel_y(*front_[i - 1]), y1 = pixel_y(*front_[i]);
        all.push_back({x0, y0 - 2, x1, y0 + 2});
        all.push_back({x1 - 2, y0, x1 + 2, y1});
    }
    const double zero = pixel_y(axis_.no_error());
    all.push_back({left_, zero - 2, p_.width() - right_, zero + 2});
    return all;
}

// Names plain double, the front, and whatever is not a formula in a type. In a narrow picture each type is named only
// once, at its fastest point.
std::vector<const candidate*> speed_plot::named() const {
    std::vector<const candidate*> all = front_;
    if (narrow_) {
        std::set<std::string> types;
        std::erase_if(all, [&](const candidate* c) { return !types.insert(c->type).second; });
    }
    for (const auto& c : points_) { // graze and other libraries
        if (c.variant.empty() && std::ranges::find(all, &c) == all.end()) {
            all.push_back(&c);
        }
    }
    const auto plain = std::ranges::find_if(points_, is_plain);
    if (plain != points_.end() && std::ranges::find(all, &*plain) == all.end()) {
        all.insert(all.begin(), &*plain);
    }
    return all;
}

void speed_plot::names() {
    placement places({left_ - 4, top_, p_.width() - 2.0, p_.height() - bottom_ + 4}, occupied());
    for (const auto* c : named()) {
        std::string name = narrow_ ? short_name_of(c->type) : c->name();
        if (is_plain(*c)) {
            name = c->wrong == 0 ? "plain double" : "plain double, " + readable_count(c->wrong) + " wrong";
        }
        const double x = pixel_x(*c), y = pixel_y(*c);
        const auto at = places.place(name, 12, x, y);
        p_.label(name, screen_x(at.x), screen_y(at.y), at.align, ink::text);
        if (std::hypot(at.x - x, at.y - y) > 30) {
            p_.add("set arrow from " + screen_x(x) + "," + screen_y(y) + " to " + screen_x(at.x) + "," +
                   screen_y(at.y + (at.y < y ? 7 : -7)) + " nohead back lw 0.8 lc " + picture::colour(ink::muted));
        }
    }
}

void speed_plot::plot(const std::string& rows, const std::string& how) {
    const std::string name = "$block" + std::to_string(blocks_.size());
    blocks_ += name + " << END\n" + rows + "END\n";
    plots_ += (plots_.empty() ? "" : ", ") + name + how;
}

// A staircase: until the cost of the next point, the least error stays that of the last one.
void speed_plot::front() {
    std::string stairs;
    for (std::size_t i = 0; i < front_.size(); ++i) {
        for (const auto* level : {front_[i == 0 ? 0 : i - 1], front_[i]}) {
            stairs += exactly(x_of(*front_[i])) + " " + exactly(axis_.height(*level)) + "\n";
        }
    }
    if (front_.size() > 1) {
        plot(stairs, " using 1:2 with lines lw 2 lc " + picture::colour(ink::best));
    }
}

// Points of the same size, marker and colour are plotted together.
void speed_plot::marks() {
    std::map<std::tuple<bool, int, ink>, std::string> alike;
    for (const auto& c : points_) {
        const int marker = marker_of(c.variant) - (c.decides_right() ? 0 : 1);
        alike[{c.on_front || is_plain(c), marker, colour_of(c)}] +=
            exactly(x_of(c)) + " " + exactly(axis_.height(c)) + " " + p_.text(speed_hover_text(c)) + "\n";
    }
    for (const auto& [style, rows] : alike) {
        const auto& [large, marker, role] = style;
        plot(rows, " using 1:2:3 with labels hypertext point pt " + std::to_string(marker) + " ps " +
                       (large ? "1.15" : "0.75") + " lc " + picture::colour(role));
    }
}

} // namespace

std::string speed_picture(const results& found, format size) {
    std::vector<candidate> points = candidates(found);
    std::erase_if(points, [](const candidate& c) { return !c.nanoseconds || !(*c.nanoseconds > 0) || c.times == 0; });
    return points.empty() ? std::string() : speed_plot(std::move(points), size == format::narrow).svg();
}

} // namespace compare::report
