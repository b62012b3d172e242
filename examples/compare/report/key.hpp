// The key of a picture: the names of its lines, below it.
#pragma once

#include "summary.hpp"

namespace compare::report {

inline constexpr int key_line_height = 17;

// The height of the key in pixels; 0 if there is none.
[[nodiscard]] inline int key_height(const results& found, bool keyed) {
    return keyed ? key_line_height * static_cast<int>(chosen_lines(found).size()) + 10 : 0;
}

// Draws it in the lowest key_height pixels of p.
inline void add_key(picture& p, const results& found, bool keyed) {
    double y = keyed ? key_height(found, keyed) - 8 : 0;
    const auto x = [&](double pixel) { return "screen " + exactly(pixel / p.width()); };
    for (const line& l : chosen_lines(found)) {
        if (!keyed) {
            return;
        }
        const std::string at = ",screen " + exactly(y / p.height());
        p.add("set arrow from " + x(34) + at + " to " + x(60) + at + " nohead lw 2 dt " +
              (l.dashed ? "(5,3)" : "solid") + " lc " + picture::colour(l.colour));
        p.label(name_of(l.type, l.variant, l.root), x(68), at.substr(1), "left", ink::text);
        y -= key_line_height;
    }
}

} // namespace compare::report
