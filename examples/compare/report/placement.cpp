#include "placement.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace compare::report {

double width_of(const std::string& text, double size) {
    // Continuation bytes of a character have no width of their own.
    const auto letters =
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; });
    return 0.56 * size * static_cast<double>(letters);
}

std::string fitted(std::string text, double size, double width) {
    if (width_of(text, size) <= width) {
        return text;
    }
    while (!text.empty() && width_of(text + "…", size) > width) {
        do {
            text.pop_back();
        } while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80);
        if (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0xc0) {
            text.pop_back();
        }
    }
    return text + "…";
}

placed placement::place(const std::string& text, double size, double x, double y) {
    const double width = width_of(text, size), half = 0.6 * size;
    placed best;
    box best_box;
    double best_cost = std::numeric_limits<double>::infinity();
    for (const double away : {9., 16., 26., 38., 52., 68.}) {
        const std::array<placed, 6> places = {{{x + away, y, "left"},
                                               {x - away, y, "right"},
                                               {x, y - away - half / 2, "center"},
                                               {x, y + away + half / 2, "center"},
                                               {x + away / 2, y - away, "left"},
                                               {x - away / 2, y - away, "right"}}};
        for (const auto& p : places) {
            const double left = p.align == "left" ? p.x : p.align == "right" ? p.x - width : p.x - width / 2;
            const box b{left, p.y - half, left + width, p.y + half};
            const bool inside =
                b.left >= area_.left && b.right <= area_.right && b.top >= area_.top && b.bottom <= area_.bottom;
            const auto covered =
                static_cast<double>(std::ranges::count_if(taken_, [&](const box& t) { return t.meets(b); }));
            const double cost = (inside ? 0 : 1000) + covered * 10 + away / 10;
            if (cost < best_cost) {
                best_cost = cost, best = p, best_box = b;
            }
        }
    }
    taken_.push_back(best_box);
    return best;
}

} // namespace compare::report
