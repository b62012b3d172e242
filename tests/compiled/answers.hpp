// A hash of the library's answers about many pairs, for units that are compiled with different flags: ordinary pairs,
// and pairs that integers decide.
#pragma once

#include <graze/graze.hpp>

#include <cmath>
#include <cstdint>
#include <utility>

namespace {

class generator {
  public:
    explicit generator(std::uint64_t seed) : state_(seed) {}
    std::uint64_t operator()() { // Steele, Lea and Flood's splitmix64
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31);
    }
    int below(int n) { return static_cast<int>((*this)() % static_cast<std::uint64_t>(n)); }

  private:
    std::uint64_t state_;
};

// The numbers of a family: small integers, full significands with similar exponents, or with exponents up to 2^spread
// apart.
template <class T>
struct numbers {
    generator& next;
    int family;
    T operator()() const {
        if (family == 0) {
            return static_cast<T>(next.below(9) - 4);
        }
        const auto significand = static_cast<T>(static_cast<std::int64_t>(next() >> 11)) * T(0x1p-53);
        const int limit = sizeof(T) == 4 ? 60 : 900;
        const int spread = family == 1 ? 1 : family == 2 ? 40 : limit;
        const T x = std::ldexp(significand, next.below(spread) - spread / 2);
        return (next() & 1) != 0 ? x : -x;
    }
};

class hash {
  public:
    template <class T>
    void take(const T& x) {
        std::uint64_t bits = 0;
        if constexpr (std::is_same_v<T, double>) {
            bits = std::bit_cast<std::uint64_t>(x);
        } else if constexpr (std::is_same_v<T, float>) {
            bits = std::bit_cast<std::uint32_t>(x);
        } else {
            bits = static_cast<std::uint64_t>(x);
        }
        value_ = (value_ ^ bits) * 0x100000001b3U;
        value_ ^= value_ >> 29;
    }
    template <int N, class T>
    void take(const graze::vec<N, T>& x) {
        for (int i = 0; i < N; ++i) {
            take(x[i]);
        }
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

template <int N, class T>
void ask(hash& h, const graze::ball<N, T>& a, const graze::ball<N, T>& b) {
    h.take(static_cast<int>(graze::classify(a, b)));
    h.take(graze::overlaps(a, b));
    if (const auto c = graze::collide(a, b)) {
        h.take(c->time);
        h.take(c->position_a);
        h.take(c->position_b);
        h.take(c->normal);
        h.take(c->velocity_a);
        h.take(c->velocity_b);
    }
}
template <int N, class T, class Shape>
void ask(hash& h, const graze::ball<N, T>& b, const Shape& s) {
    h.take(static_cast<int>(graze::classify(b, s)));
    h.take(graze::overlaps(b, s));
    if (const auto c = graze::collide(b, s)) {
        h.take(c->time);
        h.take(c->position);
        h.take(c->point);
        h.take(c->normal);
        h.take(c->velocity);
        h.take(static_cast<int>(c->feature));
    }
}
template <class T, class Time>
void take_times(hash& h, const std::optional<Time>& x, const std::optional<Time>& y) {
    if (x) {
        h.take(static_cast<T>(*x));
        h.take(x->lower());
        h.take(x->upper());
        h.take(*x < 1 ? 1 : 0);
    }
    if (x && y) {
        h.take(*x < *y ? -1 : *x == *y ? 0 : 1);
    }
}

template <int N, class T>
std::uint64_t hash_of_answers(int pairs) {
    hash h;
    generator next(N + sizeof(T));
    for (int i = 0; i < pairs; ++i) {
        const numbers<T> number{next, i % 4};
        const auto vector = [&] {
            graze::vec<N, T> x{};
            for (int k = 0; k < N; ++k) {
                x[k] = number();
            }
            return x;
        };
        const auto ball = [&] {
            graze::ball<N, T> b{vector(), vector(), std::fabs(number())};
            b.mass = T(1 + next.below(3));
            return b;
        };
        const auto a = ball(), b = ball();
        graze::wall<N, T> w{vector(), {}};
        graze::vec<N, T> normal = vector();
        for (auto& e : w.edge) {
            e = vector();
        }
        normal[0] = normal[0] == 0 ? T(1) : normal[0];
        w.edge[0][0] = w.edge[0][0] == 0 ? T(1) : w.edge[0][0];
        if constexpr (N == 3) {
            w.edge[1][0] = 0;
            w.edge[1][1] = w.edge[1][1] == 0 ? T(1) : w.edge[1][1];
        }
        const graze::plane<N, T> p{vector(), normal};
        ask(h, a, b);
        ask(h, a, p);
        ask(h, a, w);
        const auto balls = graze::time_of_impact(a, b), wall = graze::time_of_impact(a, w);
        take_times<T>(h, balls, wall);
        take_times<T>(h, graze::time_of_impact(a, p), balls);
    }
    return h.value();
}

} // namespace
