// Eqs. (1), (2), (10) to (12) and (27) as identities: what holds for their polynomials holds for all inputs.
#include <graze/formula/discriminant.hpp>

#include "../variables.hpp"

#include <cstdint>

namespace {

using namespace graze;
using proof::letter;
using proof::letters;
using proof::vector;

template <int N>
using motion = relative_motion<N, letters, letters, letters>;

// Δx, Δu and R as letters; and a time t.
template <int N>
constexpr motion<N> general() {
    return {vector<N>(0), vector<N>(N), letter(2 * N)};
}
constexpr letters t() { return letter(15); }

// Two balls whose coordinates and radii are all letters, 4N + 2 of them.
template <int N>
constexpr ball<N, letters> ball_a() {
    return {vector<N>(0), vector<N>(2 * N), letter(4 * N)};
}
template <int N>
constexpr ball<N, letters> ball_b() {
    return {vector<N>(N), vector<N>(3 * N), letter(4 * N + 1)};
}
template <int N>
constexpr motion<N> of_balls() {
    return relative_motion_of(ball_a<N>(), ball_b<N>());
}

template <int N>
constexpr letters halved(const motion<N>& m) {
    return discriminant_halved{}(quadratic_of(m));
}
template <int N>
constexpr letters lagrange(const motion<N>& m) {
    return discriminant_lagrange{}(m);
}

template <int N>
constexpr bool same(const motion<N>& x, const motion<N>& y) {
    return x.dx == y.dx && x.du == y.du && x.R == y.R;
}

template <int N>
constexpr bool proved() {
    // (1), (2), (27), by component.
    static_assert([] {
        const auto seen = of_balls<N>();
        for (int k = 0; k < N; ++k) {
            if (seen.dx[k] != letter(k) - letter(N + k) || seen.du[k] != letter(2 * N + k) - letter(3 * N + k)) {
                return false;
            }
        }
        return seen.R == letter(4 * N) + letter(4 * N + 1);
    }());

    // (8) to (10): |Δx + Δu t|² - R² = a t² + 2 h t + c.
    static_assert([] {
        const auto g = general<N>();
        const auto q = quadratic_of(g);
        letters squared_distance;
        for (int k = 0; k < N; ++k) {
            const letters x = g.dx[k] + g.du[k] * t();
            squared_distance = squared_distance + x * x;
        }
        return squared_distance - g.R * g.R == q.a * t() * t() + twice(q.h) * t() + q.c;
    }());

    // Textbook = 4 halved; halved = Lagrange.
    static_assert([] {
        const auto q = quadratic_of(general<N>());
        return discriminant_textbook{}(q) == letters(4) * discriminant_halved{}(q);
    }());
    static_assert(halved(general<N>()) == lagrange(general<N>()), "Lagrange's identity");
    static_assert(discriminant_kahan{}(quadratic_of(general<N>())) == halved(general<N>()));

    // The frame of reference does not matter.
    static_assert(
        [] {
            auto a = ball_a<N>();
            auto b = ball_b<N>();
            a.position[0] = a.position[0] + t();
            b.position[0] = b.position[0] + t();
            a.velocity[N - 1] = a.velocity[N - 1] + t();
            b.velocity[N - 1] = b.velocity[N - 1] + t();
            return same(relative_motion_of(a, b), of_balls<N>());
        }(),
        "a common shift of positions and velocities");

    // Exchanged balls.
    static_assert([] {
        const auto x = of_balls<N>();
        const auto y = relative_motion_of(ball_b<N>(), ball_a<N>());
        return y.dx == -x.dx && y.du == -x.du && y.R == x.R;
    }());
    static_assert(
        [] {
            const auto g = general<N>();
            const motion<N> exchanged{-g.dx, -g.du, g.R};
            const auto p = quadratic_of(g);
            const auto q = quadratic_of(exchanged);
            return p.a == q.a && p.h == q.h && p.c == q.c && lagrange(g) == lagrange(exchanged);
        }(),
        "even under exchange");

    // Mirrored in a coordinate plane; coordinates exchanged; time reversed.
    static_assert(
        [] {
            for (int k = 0; k < N; ++k) {
                const auto g = general<N>();
                auto mirrored = g;
                mirrored.dx[k] = -g.dx[k];
                mirrored.du[k] = -g.du[k];
                auto turned = g;
                std::swap(turned.dx[0], turned.dx[k]);
                std::swap(turned.du[0], turned.du[k]);
                if (halved(mirrored) != halved(g) || lagrange(mirrored) != lagrange(g) || halved(turned) != halved(g) ||
                    lagrange(turned) != lagrange(g)) {
                    return false;
                }
            }
            return true;
        }(),
        "reflections");
    static_assert(
        [] {
            const auto g = general<N>();
            const motion<N> reversed{g.dx, -g.du, g.R};
            return halved(reversed) == halved(g) && lagrange(reversed) == lagrange(g) &&
                   coefficient_h{}(reversed) == -coefficient_h{}(g);
        }(),
        "time reversed");

    // Homogeneous: of degree 2 in lengths and 2 in velocities.
    static_assert([] {
        const auto g = general<N>();
        const motion<N> longer{t() * g.dx, g.du, t() * g.R};
        const motion<N> faster{g.dx, t() * g.du, g.R};
        const letters square = t() * t();
        return halved(longer) == square * halved(g) && lagrange(longer) == square * lagrange(g) &&
               halved(faster) == square * halved(g) && lagrange(faster) == square * lagrange(g);
    }());
    return true;
}
static_assert(proved<2>());
static_assert(proved<3>());

// Every rotation keeps D: by the angle with cosine p/w and sine q/w, p² + q² = w², everything times w.
static_assert([] {
    const auto g = general<3>();
    const letters p = letter(10);
    const letters q = letter(11);
    const letters w = letter(12);
    const auto turned = [&](const vec<3, letters>& x) {
        return vec<3, letters>{{p * x[0] - q * x[1], q * x[0] + p * x[1], w * x[2]}};
    };
    const motion<3> m{turned(g.dx), turned(g.du), w * g.R};
    const auto on_circle = [&](const letters& x) { return x.with_square(12, p * p + q * q); };
    const letters w4 = w * w * w * w;
    return on_circle(halved(m)) == on_circle(w4 * halved(g)) && on_circle(lagrange(m)) == on_circle(w4 * lagrange(g));
}());

// Where D = 0 the quadratic is a square, with the double root -h/a: a (a t² + 2 h t + c) = (a t + h)² - D.
static_assert([] {
    const letters a = letter(0);
    const letters h = letter(1);
    const letters c = letter(2);
    const quadratic q{a, h, c};
    const letters s = a * t() + h;
    return a * (a * t() * t() + twice(h) * t() + c) == s * s - discriminant_halved{}(q);
}());

// Kahan's form is for arithmetic that rounds; in exact arithmetic it is h² - ac. In numbers of 8 bits it is right
// to 1.5 units in the last place, where h² - ac as it stands may keep no bit.
struct coarse {
    std::int64_t value = 0;
    constexpr coarse(int x) : value(rounded(x)) {}
    static constexpr coarse of(std::int64_t exact) {
        coarse x(0);
        x.value = rounded(exact);
        return x;
    }
    static constexpr std::int64_t rounded(std::int64_t x) { // to nearest
        std::int64_t unit = 1;
        while ((x < 0 ? -x : x) >= 256 * unit) {
            unit *= 2;
        }
        return (x < 0 ? -1 : 1) * (((x < 0 ? -x : x) + unit / 2) / unit) * unit;
    }
    constexpr coarse operator-() const { return of(-value); }
    friend constexpr coarse operator+(const coarse& x, const coarse& y) { return of(x.value + y.value); }
    friend constexpr coarse operator-(const coarse& x, const coarse& y) { return of(x.value - y.value); }
    friend constexpr coarse operator*(const coarse& x, const coarse& y) { return of(x.value * y.value); }
};

} // namespace

template <>
struct graze::number_traits<coarse> {
    static constexpr const char* name = "coarse";
    static constexpr bool is_exact = false;
    static constexpr int digits = 8;
    static constexpr coarse fma(const coarse& x, const coarse& y, const coarse& z) {
        return coarse::of(x.value * y.value + z.value);
    }
};

namespace {

// Of 8-bit numbers a and c with products near 151² and near 200²: |computed - exact| <= 1.5 · 2^-7 |exact|.
template <class F>
constexpr bool is_right_near(F f, int h) {
    for (int a = h - 20; a < h + 20; ++a) {
        for (int c = h - 20; c < h + 20; ++c) {
            const std::int64_t exact = h * h - a * c;
            const std::int64_t error = f(quadratic{coarse(a), coarse(h), coarse(c)}).value - exact;
            if ((error < 0 ? -error : error) * 256 > 3 * (exact < 0 ? -exact : exact)) {
                return false;
            }
        }
    }
    return true;
}
static_assert(is_right_near(discriminant_kahan{}, 151) && is_right_near(discriminant_kahan{}, 200));
static_assert(!is_right_near(discriminant_halved{}, 151));

} // namespace
