// Rows of exact numbers for questions: small whole numbers, which make ties and degenerate cases frequent, moved to
// where an environment might do harm.
#pragma once

#include "../../examples/families/pair.hpp"
#include "number.hpp"
#include "row.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace environments {

using families::random;

enum class group { length, velocity, normal };

// What a number of a row is. Radii belong to no axis.
struct place {
    group what;
    int axis;
    bool is_position = false; // the place of one of the two things, not a size
};

[[nodiscard]] inline std::vector<place> layout(partner p, int n) {
    std::vector<place> places;
    const auto vector = [&](group what, bool is_position) {
        for (int i = 0; i < n; ++i) {
            places.push_back({what, i, is_position});
        }
    };
    const auto ball = [&] {
        vector(group::length, true);
        vector(group::velocity, false);
        places.push_back({group::length, -1});
    };
    ball();
    if (p == partner::ball) {
        ball();
    } else {
        vector(group::length, true);
        for (int i = 1; i < (p == partner::plane ? 2 : n); ++i) {
            vector(p == partner::plane ? group::normal : group::length, false);
        }
    }
    return places;
}

struct row {
    partner with = partner::ball;
    std::vector<number> numbers;
};

// The index in the row of component i: of the ball's position and velocity, of the partner's position and of what
// follows that.
[[nodiscard]] constexpr std::size_t ball_velocity(int n, int i) { return static_cast<std::size_t>(n + i); }
[[nodiscard]] constexpr std::size_t partner_position(int n, int i) { return static_cast<std::size_t>(2 * n + 1 + i); }
[[nodiscard]] constexpr std::size_t partner_vector(int n, int i) { return static_cast<std::size_t>(3 * n + 1 + i); }

// Aligns everything with the axes: the ball flies along one, the wall's edges and the plane's normal are along others,
// and the way may be level with the partner. That makes grazes and equal times frequent.
inline void align(random& r, row& x, int n) {
    const auto at = [&](std::size_t i) -> std::int64_t& { return x.numbers[i].significand; };
    const auto flight = static_cast<int>(r.below(static_cast<std::uint64_t>(n)));
    const auto turn = static_cast<int>(r.below(static_cast<std::uint64_t>(n)));
    for (int i = 0; i < n; ++i) {
        if (i != flight) {
            at(ball_velocity(n, i)) = x.with == partner::ball ? at(partner_vector(n, i)) : 0;
            if (r.one_in(3)) {
                at(static_cast<std::size_t>(i)) = at(partner_position(n, i));
            }
        }
    }
    const int vectors = x.with == partner::ball ? 0 : x.with == partner::plane ? 1 : n - 1;
    for (int k = 0; k < vectors; ++k) {
        for (int i = 0; i < n; ++i) {
            if (i != (k + turn) % n) {
                at(partner_vector(n, k * n + i)) = 0;
            }
        }
    }
}

// A row of small whole numbers. Three times out of four the ball does not move away.
[[nodiscard]] inline row draw_grid(random& r, partner p, int n) {
    row x{p, {}};
    const std::int64_t reach = r.in(2, 12);
    for (const place& at : layout(p, n)) {
        const std::int64_t limit = at.what == group::velocity ? 3 : at.is_position ? reach : 4;
        x.numbers.push_back({at.axis < 0 ? r.in(0, 5) : r.in(-limit, limit), 0});
    }
    for (int i = 0; i < n && !r.one_in(4); ++i) {
        std::int64_t& speed = x.numbers[ball_velocity(n, i)].significand;
        const bool beyond =
            x.numbers[static_cast<std::size_t>(i)].significand > x.numbers[partner_position(n, i)].significand;
        speed = beyond == (speed > 0) ? -speed : speed;
    }
    if (r.one_in(2)) {
        align(r, x, n);
    }
    return x;
}

// The units of the groups, and powers of two by which an axis is stretched and its velocities shrunk. That keeps h,
// however far apart the factors of its terms are.
struct units {
    std::array<int, 3> of_group{};
    std::array<int, 3> stretch{};
};

inline void scale(row& x, int n, const units& u) {
    const std::vector<place> places = layout(x.with, n);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const place& at = places[i];
        const int along = u.stretch[static_cast<std::size_t>(std::max(at.axis, 0))];
        x.numbers[i].exponent +=
            u.of_group[static_cast<std::size_t>(at.what)] + (at.what == group::length ? along : -along);
    }
}

// Moves both things far away together. Sizes become finer than the unit of positions there.
inline void move_away(random& r, row& x, int n, int bits) {
    const std::vector<place> places = layout(x.with, n);
    std::array<std::int64_t, 3> away{};
    for (auto& a : away) {
        a = r.either_sign(((std::int64_t{1} << bits) - 64) & ~std::int64_t{63}) >> r.below(3);
    }
    const auto finer = static_cast<int>(r.in(1, 4));
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].is_position) {
            x.numbers[i].significand += away[static_cast<std::size_t>(places[i].axis)];
        } else if (places[i].what == group::length) {
            x.numbers[i].exponent -= finer;
        }
    }
}

// A type's range, as the exponents of its units.
struct range {
    int low, high, bits;
};

// An exponent for numbers of up to 6 bits: anywhere, or near the ends of squares, products or the filters' ranges.
[[nodiscard]] inline int draw_exponent(random& r, const range& type) {
    constexpr std::array anchors{-1074, -1022, -540, -511, -450, -226, -149, -126, -75,
                                 -50,   0,     50,   64,   226,  450,  511,  1010};
    std::int64_t e = r.in(type.low, type.high);
    if (type.low < 0 && r.below(3) != 0) {
        e = anchors[r.below(anchors.size())] + r.in(-7, 7);
    }
    return static_cast<int>(std::clamp<std::int64_t>(e, type.low, type.high));
}

// Replaces one number: by zero, the smallest, one of the largest, or one that is a unit in the last place away.
inline void put_a_stray(random& r, row& x, const range& type) {
    number& y = x.numbers[r.below(x.numbers.size())];
    switch (r.below(4)) {
    case 0:
        y = {0, 0};
        break;
    case 1:
        y = {r.in(1, 3), type.low};
        break;
    case 2:
        y = {1, type.high + 6 - static_cast<int>(r.in(1, 20))};
        break;
    default:
        if (y.significand != 0) {
            const int up = type.bits - static_cast<int>(std::bit_width(magnitude_of(y.significand)));
            y = {y.significand * (std::int64_t{1} << up) + r.either_sign(1), y.exponent - up};
        }
    }
}

inline constexpr std::array<std::string_view, 6> kinds_of_rows{"grid",  "scaled", "stretched",
                                                               "stray", "away",   "threshold"};

// A row of one of those kinds. Not every one is a valid pair or fits into the type.
[[nodiscard]] inline row draw(random& r, std::string_view kind, partner p, int n, const range& type) {
    row x = draw_grid(r, p, n);
    if (kind == "away") {
        move_away(r, x, n, type.bits - (type.low < 0 ? 0 : 2));
    }
    if (kind != "grid") {
        units u;
        const int velocity = draw_exponent(r, type);
        u.of_group = {draw_exponent(r, type), r.one_in(2) ? -velocity : velocity, draw_exponent(r, type)};
        if (kind == "threshold" && type.low < 0) { // the smaller numbers become subnormal, the larger ones do not
            const auto unit = [&] { return type.low + type.bits - static_cast<int>(r.in(2, 5)); };
            u.of_group[0] = unit();
            u.of_group[1] = r.one_in(2) ? unit() : u.of_group[1];
        }
        if (kind == "stretched") {
            const int most = std::max(type.high - type.low, 1) / static_cast<int>(r.in(2, 40));
            for (int& s : u.stretch) {
                s = static_cast<int>(r.in(-most, most));
            }
        }
        scale(x, n, u);
    }
    if (kind == "stray") {
        put_a_stray(r, x, type);
    }
    return x;
}

} // namespace environments
