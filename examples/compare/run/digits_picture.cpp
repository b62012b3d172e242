// Correct digits against collisions.
#include "../input_error.hpp"
#include "run_report.hpp"

#include "../report/picture.hpp"
#include "../report/placement.hpp"
#include "../report/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace compare::run {

namespace {

using report::exactly;
using report::ink;
using report::picture;

constexpr std::array<ink, 9> inks{ink::one,  ink::bad,  ink::two,  ink::three, ink::four,
                                  ink::five, ink::best, ink::open, ink::seven};

} // namespace

std::string digits_picture(const run_report& r) {
    constexpr int width = 1040, height = 560;
    picture p("digits", width, height,
              "Correct decimal digits of the balls' places after each collision of " + printable(r.scene, 200) +
                  ", a line for every number type; the table has the last figures.");
    std::string blocks, plots;
    double most = 1;
    std::size_t last = 2;
    double key_x = 62, key_y = 14;
    for (std::size_t t = 0; t < r.types.size(); ++t) {
        const history& h = r.types[t].found;
        if (h.digits.empty()) {
            continue;
        }
        const std::string colour = picture::colour(inks[t % inks.size()]);
        const std::string name = "$type" + std::to_string(t);
        blocks += name + " << END\n";
        for (std::size_t i = 0; i < h.digits.size(); ++i) {
            blocks += std::to_string(i + 1) + " " + exactly(h.digits[i]) + " " +
                      p.text(h.type + ", collision " + std::to_string(i + 1) + ": " + report::readable(h.digits[i]) +
                             " digits") +
                      "\n";
            most = std::max(most, h.digits[i]);
        }
        blocks += "END\n";
        last = std::max(last, h.digits.size());
        plots += (plots.empty() ? "" : ", ") + name + " using 1:2 with lines lw 2 lc " + colour;
        if (h.digits.size() <= 200) {
            plots += ", " + name + " using 1:2:3 with labels hypertext point pt 7 ps 0.5 lc " + colour;
        }
        const double room = 26 + report::width_of(h.type, 12);
        if (key_x + room > width) {
            key_x = 62, key_y += 19;
        }
        p.add("set label \"\" at screen " + exactly((key_x + 5) / width) + ",screen " + exactly(1 - key_y / height) +
              " point pt 7 ps 0.8 lc " + colour + " front");
        p.label(h.type, "screen " + exactly((key_x + 15) / width), "screen " + exactly(1 - key_y / height), "left",
                ink::muted);
        key_x += room;
    }
    if (plots.empty()) {
        return {};
    }
    p.margins(62, 20, key_y + 40, 46);
    p.add("set xrange [0:" + std::to_string(last + 1) + "]");
    p.add("set yrange [0:" + exactly(most * 1.05) + "]");
    p.label("correct digits ↑", "screen 0.012", "screen " + exactly(1 - (key_y + 24) / height), "left", ink::muted);
    p.label("collisions →", "graph 1", "screen 0.02", "right", ink::muted);
    p.add("set arrow from graph 0,first " + std::to_string(r.digits_wanted) + " to graph 1,first " +
          std::to_string(r.digits_wanted) + " nohead back lw 1 dt (4,4) lc " + picture::colour(ink::muted));
    p.add(blocks + "plot " + plots);
    return p.svg();
}

} // namespace compare::run
