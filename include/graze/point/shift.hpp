// A plane or a wall as a cone, and the infinitesimal shifts by which a way through its apex meets it first.
#pragma once

#include <graze/formula/wall_features.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace graze::inline v0_1::detail {

// How a point comes to a plane or wall: across its plane; in its plane, to its border, which it then grazes; or along
// it all the way, which is no event.
enum class approach : std::uint8_t { across, to_border, along };

// A plane or wall, seen from one of its points: the directions y with y·normal = 0 and y·inward >= 0 for the borders on
// which that point is. side: the sign of the side on which a moving point is; 0 if it is in the plane and no side is
// known.
template <int N, class X>
struct cone {
    standing_image standing;
    int side;
    approach way;
    vec<N, X> normal;
    std::array<vec<N, X>, N - 1> inward{};
    int borders = 0;

    [[nodiscard]] bool is_bordered() const noexcept { return borders > 0; }
    // Whether a direction in its plane is in the cone, with its borders or without.
    [[nodiscard]] bool holds(const vec<N, X>& y) const { return within(y, 0); }
    [[nodiscard]] bool holds_inside(const vec<N, X>& y) const { return within(y, 1); }

  private:
    [[nodiscard]] bool within(const vec<N, X>& y, int least) const {
        for (int i = 0; i < borders; ++i) {
            if (graze::sign(X(graze::dot(y, inward[static_cast<std::size_t>(i)]))) < least) {
                return false;
            }
        }
        return true;
    }
};

template <class X>
[[nodiscard]] X magnitude(const X& x) {
    return graze::sign(x) < 0 ? X(-x) : x;
}
template <class X>
[[nodiscard]] vec<2, X> perpendicular(const vec<2, X>& x) {
    return {{X(-x[1]), x[0]}};
}

// Whether a line from `from` along u leads to 0 and beyond.
template <int N, class X>
[[nodiscard]] bool is_through_apex(const vec<N, X>& from, const vec<N, X>& u) {
    for (int i = 0; i < N; ++i) {
        for (int j = 0; j < i; ++j) {
            if (graze::sign(X(from[i] * u[j] - from[j] * u[i])) != 0) {
                return false;
            }
        }
    }
    return graze::sign(X(graze::dot(from, u))) < 0;
}

// Directions in the plane of c, at least one between any two of these lines, but none on them: c's own borders, its
// intersections with the planes of the others, and the projections of the others' borders along u.
template <int N, class X>
[[nodiscard]] records<vec<N, X>> directions_in(const cone<N, X>& c, const records<cone<N, X>>& others,
                                               const vec<N, X>& u) {
    records<vec<N, X>> result; // not the middle: from there symmetric walls lead to edges again
    if constexpr (N == 2) {
        const vec<2, X> edge = perpendicular(c.normal);
        result.push_back(edge);
        result.push_back(-edge);
    } else {
        records<vec<N, X>> lines;
        const auto add = [&](const vec<N, X>& across) {
            const vec<N, X> line = graze::cross(c.normal, across);
            if (graze::sign(X(graze::squared_norm(line))) != 0) {
                lines.push_back(line);
                lines.push_back(-line);
            }
        };
        for (int i = 0; i < c.borders; ++i) {
            add(c.inward[static_cast<std::size_t>(i)]);
        }
        for (const cone<N, X>& other : others) {
            add(other.normal);
            for (int i = 0; i < other.borders; ++i) {
                const auto border = graze::cross(other.normal, other.inward[static_cast<std::size_t>(i)]);
                add(graze::cross(border, u));
            }
        }
        for (std::size_t i = 0; i < lines.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (const auto between = X(1009) * lines[i] + X(613) * lines[j];
                    graze::sign(X(graze::squared_norm(between))) != 0) {
                    result.push_back(between);
                }
            }
            result.push_back(X(1009) * graze::cross(c.normal, lines[i]) + X(613) * lines[i]);
        }
        if (result.empty()) { // nothing but c's own plane
            result.push_back(make_vec<N>([](int) { return X(0); }));
        }
    }
    return result;
}

// A direction inside c alone.
template <int N, class X>
[[nodiscard]] vec<N, X> inside(const cone<N, X>& c) {
    const vec<N, X> none = make_vec<N>([](int) { return X(0); });
    const auto directions = directions_in<N, X>(c, {}, none);
    const auto found =
        std::find_if(directions.begin(), directions.end(), [&](const auto& d) { return c.holds_inside(d); });
    return found != directions.end() ? *found : none;
}

// Whether a way along u, shifted from the apex to a direction d in c, gets there without meeting `other`. beside: it
// may pass the plane of `other` beside `other`.
template <int N, class X>
[[nodiscard]] bool is_free(const cone<N, X>& c, const cone<N, X>& other, const vec<N, X>& d, const vec<N, X>& u,
                           bool beside) {
    const X height = graze::dot(d, other.normal);
    const int side = graze::sign(height);
    if (side == 0) { // in the plane of `other`, which is c's too or is met on its border
        return graze::sign(X(graze::squared_norm(graze::cross(c.normal, other.normal)))) == 0;
    }
    if (other.side == 0 || side == other.side) {
        return true;
    }
    const X speed = graze::dot(u, other.normal); // 0 if it flies beside that plane for ever
    return beside && graze::sign(speed) != 0 && !other.holds(magnitude(speed) * d - magnitude(height) * u);
}

// A shift from the apex to a place inside c, by which a way along u, which led to the apex, comes to c before all
// others. Preferably it passes none of their planes, else it passes beside them; and preferably the way along `after`,
// on which the point leaves c, leads away from what the point slid along. Empty if others hide all of c.
template <int N, class X>
[[nodiscard]] std::optional<vec<N, X>> shift_into(const cone<N, X>& c, const records<cone<N, X>>& all,
                                                  const vec<N, X>& u, const vec<N, X>& after) {
    const auto directions = directions_in<N, X>(c, all, u);
    const auto leaves = [&](const vec<N, X>& d) {
        return std::all_of(all.begin(), all.end(), [&](const cone<N, X>& other) {
            return other.side != 0 ||
                   graze::sign(X(graze::dot(d, other.normal))) * graze::sign(X(graze::dot(after, other.normal))) >= 0;
        });
    };
    for (const bool beside : {false, true}) {
        for (const bool leaving : {true, false}) {
            for (const vec<N, X>& d : directions) {
                if (c.holds_inside(d) && leaves(d) == leaving &&
                    std::all_of(all.begin(), all.end(),
                                [&](const cone<N, X>& other) { return is_free(c, other, d, u, beside); })) {
                    return d;
                }
            }
        }
    }
    return std::nullopt;
}

} // namespace graze::inline v0_1::detail
