// The mark of a type that is drawn as a point: the kind of type gives the colour, the variant the shape.
#pragma once

#include "summary.hpp"

namespace compare::report {

// gnuplot's filled markers: triangle, square, diamond, circle. The hollow marker has the number before.
[[nodiscard]] inline int marker_of(const std::string& variant) {
    return variant == "textbook" ? 9 : variant == "halved" ? 5 : variant == "kahan" ? 13 : 7;
}

// Whether this is a library's own collision instead of the formulas in a number type.
[[nodiscard]] inline bool is_peer(const candidate& c) {
    return c.variant.empty() && c.information != nullptr && c.information->library != "graze";
}

[[nodiscard]] inline ink colour_of(const candidate& c) {
    if (c.information == nullptr) {
        return ink::four;
    }
    if (c.is_exact() || c.information->library == "graze") {
        return ink::best;
    }
    if (is_peer(c)) {
        return ink::five;
    }
    const bool of_machine = c.information->library == "built in" && c.information->digits <= 64;
    return c.information->is_interval ? ink::open : of_machine ? ink::one : ink::four;
}

} // namespace compare::report
