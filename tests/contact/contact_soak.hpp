// Contacts of one family, each component judged by the oracle.
#pragma once

#include "../soak/soak.hpp"
#include "answers.hpp"
#include "judge.hpp"

#include <algorithm>
#include <cmath>

namespace contact_soak {

// What was seen of one family in one dimension and one type.
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

// A pair's numbers rounded to T. Not inlined: where two of them are converted to float and back, g++ 12 may make that
// one step on a vector that does nothing (-O3, or -O2 with -ftree-slp-vectorize).
template <class T>
[[gnu::noinline]] T to_number(double x) {
    return static_cast<T>(x);
}
template <class T, int N>
graze::vec<N, T> to(const graze::vec<N, double>& x) {
    return graze::make_vec<N>([&](int i) { return to_number<T>(x[i]); });
}
template <class T, int N>
graze::ball<N, T> to(const graze::ball<N, double>& b) {
    return {to<T>(b.position), to<T>(b.velocity), to_number<T>(b.radius), to_number<T>(b.mass)};
}
template <class T, int N>
graze::plane<N, T> to(const graze::plane<N, double>& p) {
    return {to<T>(p.point), to<T>(p.normal)};
}
template <class T, int N>
graze::wall<N, T> to(const graze::wall<N, double>& w) {
    graze::wall<N, T> r{to<T>(w.corner), {}};
    for (std::size_t i = 0; i < w.edge.size(); ++i) {
        r.edge[i] = to<T>(w.edge[i]);
    }
    return r;
}

// Whether the library would take the shape: rounding to float makes infinities, zeros and parallel edges.
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

// Draws pairs of soak::families_drawn[family] from number `first` on until `count` of them collide or 16 count have
// been drawn.
template <int N, class T>
tally run(std::size_t family, std::uint64_t seed, std::uint64_t first, std::uint64_t count,
          std::vector<std::string>& complaints) {
    tally seen;
    const families::family& f = soak::families_drawn[family];
    for (std::uint64_t index = first; seen.contacts < count && index < first + 16 * count; ++index) {
        const auto pair = f.draw<N>(seed, index);
        ++seen.pairs;
        const auto a = to<T>(pair.a);
        std::string wrong;
        if (pair.kind == families::pair_kind::ball_ball) {
            judge_pair(seen, a, to<T>(pair.b), wrong);
        } else if (pair.kind == families::pair_kind::ball_plane) {
            judge_pair(seen, a, to<T>(pair.plane), wrong);
        } else {
            judge_pair(seen, a, to<T>(pair.wall), wrong);
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
