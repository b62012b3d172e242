// A point among walls in rational numbers, by a method that the library does not use: where several walls meet, the
// point is actually shifted, by a number so small that nothing else is as near, and then flies past them.
#pragma once

#include <graze/scene/canonical_order.hpp>
#include <graze/shape/ball.hpp>
#include <graze/shape/wall.hpp>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace point_oracle {

template <int N>
using vector = std::array<mpq_class, N>;

template <int N>
mpq_class dot(const vector<N>& x, const vector<N>& y) {
    mpq_class sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
        sum += x[i] * y[i];
    }
    return sum;
}
template <int N>
vector<N> moved(const vector<N>& x, const mpq_class& t, const vector<N>& u) {
    vector<N> result;
    for (std::size_t i = 0; i < N; ++i) {
        result[i] = x[i] + t * u[i];
    }
    return result;
}
template <int N, class T>
vector<N> exactly(const graze::vec<N, T>& x) {
    vector<N> result;
    for (int i = 0; i < N; ++i) {
        result[static_cast<std::size_t>(i)] = x[i];
    }
    return result;
}

template <int N>
struct side {
    vector<N> corner, normal;
    std::array<vector<N>, N - 1> edge, along; // λ_i = (x - corner)·along[i]

    explicit side(const graze::wall<N>& w) : corner(exactly(w.corner)) {
        for (std::size_t i = 0; i + 1 < N; ++i) {
            edge[i] = exactly(w.edge[i]);
        }
        const vector<N>& e = edge[0];
        if constexpr (N == 2) {
            normal = {-e[1], e[0]};
            along[0] = moved<2>({}, 1 / dot<2>(e, e), e);
        } else { // the dual basis of the two edges
            const vector<N>& f = edge[1];
            normal = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
            const mpq_class ee = dot<3>(e, e), ef = dot<3>(e, f), ff = dot<3>(f, f), det = ee * ff - ef * ef;
            along[0] = moved<3>(moved<3>({}, ff / det, e), -ef / det, f);
            along[1] = moved<3>(moved<3>({}, ee / det, f), -ef / det, e);
        }
    }
    mpq_class height(const vector<N>& x) const { return dot<N>(moved<N>(x, -1, corner), normal); }
    // For a point in the plane: 1 inside, 0 on the border, -1 outside.
    int place(const vector<N>& x) const {
        int result = 1;
        for (const auto& a : along) {
            const mpq_class at = dot<N>(moved<N>(x, -1, corner), a);
            result = std::min(result, std::min(sgn(at), sgn(mpq_class(1 - at))));
        }
        return result;
    }
    vector<N> reflected(const vector<N>& u) const {
        return moved<N>(u, -2 * dot<N>(u, normal) / dot<N>(normal, normal), normal);
    }
};

// What a point comes to: a wall, whether at its border, and whether it only grazes it.
struct touch {
    std::size_t wall;
    bool on_border, graze;
};

// The walls off which a point bounces at a place, and the side of each wall there on which it continues; 0 if it leaves
// that wall.
struct passage {
    std::vector<std::size_t> bounces;
    std::vector<int> side;
};

template <int N>
class walls_around {
  public:
    explicit walls_around(const std::vector<graze::wall<N>>& walls) {
        for (const auto& w : walls) {
            sides_.emplace_back(w);
        }
        const auto order = graze::detail::canonical_order(std::span<const graze::wall<N>>(walls));
        order_.assign(order.begin(), order.end());
    }
    const side<N>& operator[](std::size_t i) const { return sides_[i]; }

    // When a point meets a wall, if it does. It does not meet a wall that it is on.
    std::optional<mpq_class> meet(std::size_t wall, const vector<N>& x, const vector<N>& u) const {
        const side<N>& s = sides_[wall];
        const mpq_class height = s.height(x), speed = dot<N>(u, s.normal);
        if (speed != 0) {
            const mpq_class t = -height / speed;
            return t > 0 && s.place(moved<N>(x, t, u)) >= 0 ? std::optional(t) : std::nullopt;
        }
        if (height != 0 || s.place(x) >= 0) {
            return std::nullopt;
        }
        mpq_class first = 0, last = -1; // the times at which it is in the wall's plane, within the borders
        bool bounded = false;
        for (const auto& a : s.along) {
            const mpq_class at = dot<N>(moved<N>(x, -1, s.corner), a), growth = dot<N>(u, a);
            if (growth == 0) {
                if (at < 0 || at > 1) {
                    return std::nullopt;
                }
                continue;
            }
            const mpq_class s0 = -at / growth, s1 = (1 - at) / growth;
            first = std::max(first, std::min(s0, s1));
            last = bounded ? std::min(last, std::max(s0, s1)) : std::max(s0, s1);
            bounded = true;
        }
        return bounded && first <= last ? std::optional(first) : std::nullopt;
    }

    // Everything that is met first: what is met inside, then what is met on the border, each in canonical order.
    std::vector<touch> first(const vector<N>& x, const vector<N>& u, mpq_class& when) const {
        std::vector<touch> found;
        for (const bool on_border : {false, true}) {
            for (const int i : order_) {
                const auto wall = static_cast<std::size_t>(i);
                const auto t = meet(wall, x, u);
                if (!t) {
                    continue;
                }
                const bool graze = sgn(dot<N>(u, sides_[wall].normal)) == 0;
                if ((graze || sides_[wall].place(moved<N>(x, *t, u)) == 0) != on_border) {
                    continue;
                }
                if (found.empty() || *t < when) {
                    found.clear();
                    when = *t;
                }
                if (*t == when) {
                    found.push_back({wall, on_border, graze});
                }
            }
        }
        // The second pass may have found an earlier time.
        std::erase_if(found, [&](const touch& f) { return *meet(f.wall, x, u) != when; });
        return found;
    }

    // All walls at a place: those that it is inside of, then the others, each in canonical order.
    std::vector<std::size_t> at(const vector<N>& place) const {
        std::vector<std::size_t> result;
        for (const int wall : order_) {
            const auto i = static_cast<std::size_t>(wall);
            if (sides_[i].height(place) == 0 && sides_[i].place(place) >= 0) {
                result.push_back(i);
            }
        }
        std::ranges::stable_partition(result, [&](std::size_t i) { return sides_[i].place(place) > 0; });
        return result;
    }
    // The walls off which a point bounces that comes to `place` with velocity u, if it is shifted by `shift`. Of two
    // walls that are equal there, the one in `first` is met. Nothing else is so near.
    passage bounces(const vector<N>& place, const vector<N>& shift, vector<N> u, const std::vector<std::size_t>& walls,
                    std::size_t first) const {
        std::vector<std::size_t> here = walls;
        std::ranges::stable_partition(here, [&](std::size_t wall) { return wall == first; });
        const mpq_class past(mpz_class(1), mpz_class(1) << 100);
        std::vector<std::size_t> result;
        vector<N> x = moved<N>(moved<N>(place, -past, u), mpq_class(mpz_class(1), mpz_class(1) << 200), shift);
        for (int i = 0; i < 100; ++i) {
            std::optional<std::size_t> next;
            mpq_class when = past * 4;
            for (const std::size_t wall : here) {
                const auto t = meet(wall, x, u);
                if (t && *t < when && (result.empty() || result.back() != wall)) {
                    next = wall;
                    when = *t;
                }
            }
            if (!next) {
                break;
            }
            x = moved<N>(x, when, u);
            u = sides_[*next].reflected(u);
            result.push_back(*next);
        }
        passage found{std::move(result), {}};
        for (const std::size_t wall : walls) {
            const bool beside = sgn(dot<N>(u, sides_[wall].normal)) == 0;
            found.side.push_back(beside ? sgn(sides_[wall].height(x)) : 0);
        }
        return found;
    }
    // 1 or -1 where two walls are in one plane, as their normals have one sense or not.
    int common_sense(std::size_t a, std::size_t b) const {
        const mpq_class along = dot<N>(sides_[a].normal, sides_[b].normal);
        const bool parallel =
            along * along == dot<N>(sides_[a].normal, sides_[a].normal) * dot<N>(sides_[b].normal, sides_[b].normal);
        return parallel && sides_[a].height(sides_[b].corner) == 0 ? sgn(along) : 0;
    }

  private:
    std::vector<side<N>> sides_;
    std::vector<int> order_;
};

// Shifts into the wall: in space 8 `fineness` directions, in the plane two, less those that lead out of the wall.
template <int N>
std::vector<vector<N>> shifts_into(const side<N>& s, const vector<N>& place, int fineness) {
    std::vector<vector<N>> result;
    const auto add = [&](const vector<N>& d) {
        if (s.place(moved<N>(place, mpq_class(mpz_class(1), mpz_class(1) << 150), d)) > 0) {
            result.push_back(d);
        }
    };
    if constexpr (N == 2) {
        add(s.edge[0]);
        add(moved<N>({}, -1, s.edge[0]));
    } else {
        for (int i = -fineness; i <= fineness; ++i) {
            for (int j = -fineness; j <= fineness; ++j) {
                if (std::max(std::abs(i), std::abs(j)) == fineness) { // of few is anything on a grid in this direction
                    add(moved<N>(moved<N>({}, mpq_class(16 * i + 1, 16), s.edge[0]), mpq_class(16 * j - 3, 16),
                                 s.edge[1]));
                }
            }
        }
    }
    return result;
}

} // namespace point_oracle
