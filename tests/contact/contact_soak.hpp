// Contacts of one family, each component judged by the oracle.
#pragma once

#include "../soak/soak.hpp"
#include "answers.hpp"
#include "judge.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace contact_soak {

// The counts of one family in one dimension and one type.
struct tally {
    std::uint64_t pairs = 0, contacts = 0, components = 0, ties = 0, exact = 0, wrong = 0;

    tally& operator+=(const tally& other) {
        pairs += other.pairs;
        contacts += other.contacts;
        components += other.components;
        ties += other.ties;
        exact += other.exact;
        wrong += other.wrong;
        return *this;
    }
};

// A pair's numbers rounded to T. Not inlined: if two of them are converted to float and back, g++ 12 may replace that
// by a step on a vector that does nothing (-O3, or -O2 with -ftree-slp-vectorize).
template <class T>
[[gnu::noinline]] T to_number(double x) {
    return static_cast<T>(x);
}

// The power of two that scales numbers of one kind for T: numbers far too large or too small are moved to the ends of
// its range, the smallest bit to that of the subnormal numbers.
template <class T>
class fitting {
  public:
    template <int N>
    void see(const graze::vec<N, double>& x) {
        for (int i = 0; i < N; ++i) {
            see(x[i]);
        }
    }
    void see(double x) {
        if (x != 0 && std::isfinite(x)) {
            int exponent = 0;
            const auto bits = static_cast<std::uint64_t>(std::ldexp(std::fabs(std::frexp(x, &exponent)), 53));
            top_ = std::max(top_, exponent);
            bottom_ = std::min(bottom_, exponent - 53 + std::countr_zero(bits));
        }
    }
    [[nodiscard]] int power() const {
        using limits = std::numeric_limits<T>;
        if (sizeof(T) == sizeof(double) || (top_ >= limits::min_exponent && top_ <= limits::max_exponent)) {
            return 0;
        }
        const int highest = limits::max_exponent - 3 - top_;
        return top_ > 0 ? highest : std::min(highest, limits::min_exponent - limits::digits - bottom_);
    }

  private:
    int top_ = std::numeric_limits<int>::min(), bottom_ = std::numeric_limits<int>::max();
};

// A pair in T.
template <class T, int N>
struct pair_in {
    graze::ball<N, T> a, b;
    graze::plane<N, T> plane;
    graze::wall<N, T> wall;
};

template <class T, int N>
pair_in<T, N> to(const families::pair_of_doubles<N>& pair) {
    fitting<T> length, velocity, normal;
    for (const auto* b : {&pair.a, &pair.b}) {
        length.see(b->position);
        length.see(b->radius);
        velocity.see(b->velocity);
    }
    length.see(pair.plane.point);
    length.see(pair.wall.corner);
    for (const auto& e : pair.wall.edge) {
        length.see(e);
    }
    normal.see(pair.plane.normal);
    const auto vector = [](const graze::vec<N, double>& x, const fitting<T>& kind) {
        return graze::make_vec<N>([&](int i) { return to_number<T>(std::ldexp(x[i], kind.power())); });
    };
    const auto ball = [&](const graze::ball<N, double>& b) {
        return graze::ball<N, T>{vector(b.position, length), vector(b.velocity, velocity),
                                 to_number<T>(std::ldexp(b.radius, length.power())), to_number<T>(b.mass)};
    };
    pair_in<T, N> r{ball(pair.a),
                    ball(pair.b),
                    {vector(pair.plane.point, length), vector(pair.plane.normal, normal)},
                    {vector(pair.wall.corner, length), {}}};
    for (std::size_t i = 0; i < pair.wall.edge.size(); ++i) {
        r.wall.edge[i] = vector(pair.wall.edge[i], length);
    }
    return r;
}

// Whether the library accepts the shape: rounding to float can make infinities, zeros and parallel edges.
template <int N, class T>
bool is_finite(const graze::vec<N, T>& x) {
    bool finite = true;
    for (int i = 0; i < N; ++i) {
        finite = finite && std::isfinite(x[i]);
    }
    return finite;
}
template <int N, class T>
bool is_valid(const graze::ball<N, T>& b) {
    return is_finite(b.position) && is_finite(b.velocity) && std::isfinite(b.radius) && b.mass > 0;
}
template <int N, class T>
bool is_valid(const graze::plane<N, T>& p) {
    return is_finite(p.point) && is_finite(p.normal) && p.normal != graze::vec<N, T>{};
}
template <int N, class T>
bool is_valid(const graze::wall<N, T>& w) {
    bool valid = is_finite(w.corner);
    for (const auto& e : w.edge) {
        valid = valid && is_finite(e) && e != graze::vec<N, T>{};
    }
    if constexpr (N == 3) {
        for (int i = 0; valid && i < 3; ++i) {
            const int j = (i + 1) % 3;
            const auto exact = [&](std::size_t k, int l) { return mpq_class(static_cast<double>(w.edge[k][l])); };
            if (exact(0, i) * exact(1, j) != exact(0, j) * exact(1, i)) {
                return true;
            }
        }
        return false;
    }
    return valid;
}

template <class T>
bool is_valid(const graze::triangle<T>& t) {
    return is_valid(graze::wall<3, T>{t.corner, t.edge});
}

// Compares the library's contact and times with the oracle's.
template <class A, class B>
void judge_pair(tally& seen, const A& a, const B& b, std::string& wrong) {
    if (!is_valid(a) || !is_valid(b)) {
        return;
    }
    const auto found = answers::of(a, b);
    const judge::verdict v = judge::of(a, b, found.contact, found.time);
    wrong = v.wrong;
    seen.components += v.components;
    seen.ties += static_cast<std::uint64_t>(std::count(v.tied.begin(), v.tied.end(), ' '));
    seen.wrong += wrong.empty() ? 0U : 1U;
    const bool collides = oracle::is_collision(v.what);
    seen.contacts += collides ? 1U : 0U;
    seen.exact += collides && found.given_by == graze::stage::exact ? 1U : 0U;
}

// Draws pairs of soak::families_drawn[family], from number `first` on, until `count` of them collide or 16 count have
// been drawn.
template <int N, class T>
tally run(soak::drawn what, std::size_t family, std::uint64_t seed, std::uint64_t first, std::uint64_t count,
          std::vector<std::string>& complaints) {
    tally seen;
    const families::family& f = soak::families_drawn[family];
    for (std::uint64_t index = first; seen.contacts < count && index < first + 16 * count; ++index) {
        const auto drawn = f.draw<N>(seed, index);
        const auto pair = to<T>(drawn);
        std::string wrong;
        if (what == soak::drawn::triangles) {
            if constexpr (N == 3) {
                if (drawn.kind == families::pair_kind::ball_wall) {
                    ++seen.pairs;
                    judge_pair(seen, pair.a, graze::triangle<T>{pair.wall.corner, pair.wall.edge}, wrong);
                }
            }
        } else if (++seen.pairs; drawn.kind == families::pair_kind::ball_ball) {
            judge_pair(seen, pair.a, pair.b, wrong);
        } else if (drawn.kind == families::pair_kind::ball_plane) {
            judge_pair(seen, pair.a, pair.plane, wrong);
        } else {
            judge_pair(seen, pair.a, pair.wall, wrong);
        }
        if (!wrong.empty()) {
            complaints.push_back(std::string(f.name) + " " + std::to_string(N) + "D, " +
                                 (sizeof(T) == 4 ? "float" : "double") + ", seed " + std::to_string(seed) + ", pair " +
                                 std::to_string(index) + ": " + wrong);
        }
    }
    return seen;
}

} // namespace contact_soak
