// Pairs for the tests of batches: generic ones and hard ones, with ordinary exponents and over the whole range.
#pragma once

#include <families/families.hpp>

#include <graze/batch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace batches {

// Balls in both of the forms that a batch takes.
template <int N, class T>
class many_balls {
  public:
    void add(const graze::ball<N, T>& b) {
        all_.push_back(b);
        for (int k = 0; k < N; ++k) {
            number_[static_cast<std::size_t>(k)].push_back(b.position[k]);
            number_[static_cast<std::size_t>(N + k)].push_back(b.velocity[k]);
        }
        number_[2 * N].push_back(b.radius);
    }
    [[nodiscard]] const std::vector<graze::ball<N, T>>& all() const { return all_; }
    [[nodiscard]] graze::columns<N, T> columns() const {
        graze::columns<N, T> c{};
        for (std::size_t k = 0; k < N; ++k) {
            c.position[k] = number_[k].data();
            c.velocity[k] = number_[N + k].data();
        }
        c.radius = number_[2 * N].data();
        c.size = all_.size();
        return c;
    }

  private:
    std::vector<graze::ball<N, T>> all_;
    std::array<std::vector<T>, 2 * N + 1> number_;
};

template <int N, class T>
struct pairs {
    many_balls<N, T> a, b;
};

// In T, with lengths and velocities times powers of two. A float may overflow and is then bad input.
template <int N, class T>
[[nodiscard]] graze::ball<N, T> scaled(const graze::ball<N, double>& x, int length, int velocity) {
    const auto vector = [](const graze::vec<N, double>& v, int power) {
        return graze::make_vec<N>([&](int k) { return static_cast<T>(std::ldexp(v[k], power)); });
    };
    return {vector(x.position, length), vector(x.velocity, velocity), static_cast<T>(std::ldexp(x.radius, length))};
}

template <int N, class T>
[[nodiscard]] bool is_good(const graze::ball<N, T>& b) {
    bool good = std::isfinite(b.radius);
    for (int k = 0; k < N; ++k) {
        good = good && std::isfinite(b.position[k]) && std::isfinite(b.velocity[k]);
    }
    return good;
}

// The units that the pairs are in.
enum class units { own, any };

// Two balls from every family of balls, in turn; in `share` of 64 cases generic ones instead.
template <int N, class T>
[[nodiscard]] pairs<N, T> draw(std::uint64_t seed, std::size_t count, unsigned generic_in_64, units in) {
    constexpr int spread = sizeof(T) == 4 ? 60 : 500;
    pairs<N, T> r;
    for (std::uint64_t i = 0; r.a.all().size() < count; ++i) {
        families::random random(seed, i);
        const auto& family = random.below(64) < generic_in_64
                                 ? families::all_families[0]
                                 : families::all_families[random.below(families::all_families.size())];
        const auto drawn = family.draw<N>(seed, i);
        if (drawn.kind != families::pair_kind::ball_ball) {
            continue;
        }
        const auto power = [&] { return in == units::own ? 0 : static_cast<int>(random.in(-spread, spread)); };
        const int length = power(), velocity = power();
        const auto a = scaled<N, T>(drawn.a, length, velocity), b = scaled<N, T>(drawn.b, length, velocity);
        if (is_good(a) && is_good(b)) {
            r.a.add(a);
            r.b.add(b);
        }
    }
    return r;
}

// Balls of which the first is the pair's, rounded to T. In each other one, a number differs by a unit in the last
// place, or the velocity is reversed.
template <int N, class T>
[[nodiscard]] many_balls<N, T> balls_beside(const families::pair_of_doubles<N>& drawn, std::uint64_t seed,
                                            std::size_t count) {
    many_balls<N, T> balls;
    families::random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        auto b = scaled<N, T>(drawn.a, 0, 0);
        if (i != 0) {
            T& x = random.one_in(2) ? b.position[static_cast<int>(random.below(N))] : b.radius;
            x = std::nextafter(x, random.one_in(2) ? T(0) : 2 * x);
            if (random.one_in(4)) {
                b.velocity = -b.velocity;
            }
        }
        balls.add(b);
    }
    return balls;
}

// A shape with its numbers rounded to T.
template <int N, class T>
[[nodiscard]] graze::vec<N, T> rounded(const graze::vec<N, double>& x) {
    return graze::make_vec<N>([&](int k) { return static_cast<T>(x[k]); });
}
template <class T, int N>
[[nodiscard]] graze::plane<N, T> in_type(const graze::plane<N, double>& p) {
    return {rounded<N, T>(p.point), rounded<N, T>(p.normal)};
}
template <class T, int N>
[[nodiscard]] graze::wall<N, T> in_type(const graze::wall<N, double>& w) {
    graze::wall<N, T> r{rounded<N, T>(w.corner), {}};
    for (std::size_t i = 0; i < r.edge.size(); ++i) {
        r.edge[i] = rounded<N, T>(w.edge[i]);
    }
    return r;
}
// Whether graze accepts the pair.
template <class B, class S>
[[nodiscard]] bool is_accepted(const B& b, const S& shape) {
    try {
        (void)graze::classify(b, shape);
    } catch (const std::domain_error&) {
        return false;
    }
    return true;
}

} // namespace batches
