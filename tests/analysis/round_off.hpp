// |computed - exact| <= K 2^-p M for a type T of p bits that rounds to nearest. K is the constant that the compiler
// derives for the filters; M is the product of the inputs' norms to the quantity's degrees. Checked on pairs of every
// hard family, with their own doubles and with numbers that use all of T's bits.
#pragma once

#include "../../proofs/bounds/constants.hpp"
#include "../formula/inexact.hpp"
#include "../property.hpp"
#include "../soak/more_families.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace round_off {

// K with u = 2^-p, since T rounds to nearest.
template <class Q, int N, class T>
inline constexpr double constant = bounds::constant<Q, N, graze::number_traits<T>::digits + 1>;

// Exact for any exponent: types with a larger range than double have numbers that no double is near.
template <class T>
mpq_class exact_value(T x) {
    mpq_class unit = 1;
    for (; graze::sign(x) != 0 && std::fabs(static_cast<double>(x)) < 0x1p-500; x = x * T(0x1p500)) {
        unit *= mpq_class(0x1p-500);
    }
    return inexact::exact_value(x) * unit;
}

inline mpf_class precise(const graze::gmp_rational& x) { return {x.value(), 2000}; }
inline mpf_class precise(const graze::sqrt_extension<graze::gmp_rational>& x) {
    return precise(x.p()) + precise(x.q()) * sqrt(precise(x.d()));
}

// Products of four scales neither over- nor underflow in a float.
inline bool in_range(double scale) { return scale > 0x1p-25 && scale < 0x1p25; }

struct record {
    double worst = 0; // error over 2^-p M
    long tried = 0;
};

// The error in units 2^-p M; negative outside the quantity's domain or where T might under- or overflow.
template <class Q, int N, class T>
double error_in_units(const std::vector<T>& inputs) {
    std::vector<graze::gmp_rational> held;
    for (const T& x : inputs) {
        if (!std::isfinite(static_cast<double>(x))) {
            return -1;
        }
        held.emplace_back(exact_value(x));
    }
    bounds::rounded_source<T> rounded(inputs);
    const T computed = Q::template run<N>(rounded);
    const auto norms = rounded.norms(N);
    double scale = 1;
    for (std::size_t i = 0; i < Q::degree.size(); ++i) {
        if (!in_range(norms[i]) && (Q::degree[i] != 0 || norms[i] != 0)) {
            return -1;
        }
        scale *= std::pow(norms[i], Q::degree[i]);
    }
    try {
        bounds::exact_source<graze::gmp_rational> exact(held);
        const mpf_class truth = precise(Q::template run<N>(exact));
        const mpf_class difference = mpf_class(exact_value(computed), 2000) - truth;
        return std::ldexp(std::fabs(difference.get_d()), graze::number_traits<T>::digits) / scale * (1 - 0x1p-45);
    } catch (const bounds::outside_domain&) {
        return -1;
    }
}

// In [0, 1), with all bits of T random.
template <class T>
T drawn_fraction(families::random& r) {
    T x(0);
    for (int bit = 0; bit < graze::number_traits<T>::digits; bit += 24) {
        x = (x + T(static_cast<double>(r.below(1U << 24U)))) * T(0x1p-24);
    }
    return x;
}

template <class Q, int N, class T>
void check(const std::vector<double>& inputs, families::random& r, record& to) {
    std::vector<T> in_t;
    for (const double x : inputs) {
        in_t.push_back(static_cast<T>(x));
    }
    for (const bool is_extended : {false, true}) {
        if (is_extended) { // moved from the doubles by less than their last place
            for (T& x : in_t) {
                x = x + x * (drawn_fraction<T>(r) * T(0x1p-53));
            }
        }
        const double error = error_in_units<Q, N, T>(in_t);
        if (error >= 0) {
            ++to.tried;
            to.worst = std::max(to.worst, error);
            PROPERTY_ASSERT(error <= (constant<Q, N, T>));
        }
    }
}

// The numbers of a pair in the order in which the quantities take them: two for each difference.
template <int N>
std::vector<double> numbers(const graze::ball<N, double>& a, const graze::ball<N, double>& b) {
    std::vector<double> x;
    for (int i = 0; i < N; ++i) {
        x.insert(x.end(), {a.position[i], b.position[i]});
    }
    for (int i = 0; i < N; ++i) {
        x.insert(x.end(), {a.velocity[i], b.velocity[i]});
    }
    x.insert(x.end(), {a.radius, -b.radius});
    return x;
}
template <int N>
std::vector<double> numbers(const graze::ball<N, double>& b, const graze::plane<N, double>& p) {
    std::vector<double> x;
    for (int i = 0; i < N; ++i) {
        x.insert(x.end(), {b.position[i], p.point[i]});
    }
    x.insert(x.end(), &b.velocity.component[0], &b.velocity.component[0] + N);
    x.insert(x.end(), &p.normal.component[0], &p.normal.component[0] + N);
    x.push_back(b.radius);
    return x;
}

template <class T, class Q, int N>
void check_quantity(const families::pair_of_doubles<N>& pair, families::random& r, record& to) {
    if (pair.kind == families::pair_kind::ball_plane && !Q::of_two_balls) {
        check<Q, N, T>(numbers<N>(pair.a, pair.plane), r, to);
    } else if (pair.kind == families::pair_kind::ball_ball && Q::of_two_balls) {
        check<Q, N, T>(numbers<N>(pair.a, pair.b), r, to);
    }
}

// Starts from random numbers with all of T's bits and changes them one by one to make the error larger. The bound is at
// most `slack` times what this finds: a constant smaller by that factor would be exceeded.
template <class Q, int N, class T>
double worst_found() {
    families::random r(3);
    const auto number = [&r] {
        const T x = T(0.5) + drawn_fraction<T>(r) * T(0.5);
        return r.one_in(2) ? x : -x;
    };
    double worst = 0;
    for (int start = 0; start < 12; ++start) {
        std::vector<T> x(bounds::inputs_of<Q, N>);
        double error = -1;
        for (int tries = 0; error < 0 && tries < 200; ++tries) {
            for (T& component : x) {
                component = number();
            }
            error = error_in_units<Q, N, T>(x);
        }
        for (int step = 0; error >= 0 && step < 60; ++step) {
            auto y = x;
            T& changed = y[r.below(y.size())];
            changed = r.one_in(3) ? -changed : r.one_in(3) ? changed * T(0.5) : number();
            if (const double other = error_in_units<Q, N, T>(y); other > error) {
                error = other;
                x = y;
            }
        }
        worst = std::max(worst, error);
    }
    return worst;
}

// One property for each quantity. It draws from every family.
template <class T, class Q, int N>
void holds_in_every_family(double slack) {
    record to;
    const auto draw = [&](const auto& drawn, families::random& r) {
        for (const auto& family : drawn) {
            for (int draws = Q::of_two_balls ? (r.one_in(4) ? 1 : 0) : 3; draws > 0; --draws) { // few have planes
                const auto index = property::any<std::uint64_t>();
                check_quantity<T, Q, N>(family.template draw<N>(1, index % (1U << 20U)), r, to);
            }
        }
    };
    CHECK(property::check(std::string(graze::number_traits<T>::name) + ", " + Q::name, [&] {
        families::random r(property::any<std::uint64_t>());
        draw(families::all_families, r);
        draw(families::more_families, r);
    }));
    CHECK(to.tried > 20);
    CHECK(to.worst > 0);
    const double found = worst_found<Q, N, T>();
    CHECK(found <= (constant<Q, N, T>));
    CHECK(found * slack > (constant<Q, N, T>));
    MESSAGE(std::string(graze::number_traits<T>::name)
            << ", " << N << "D, " << std::string(Q::name) << ": bound " << constant<Q, N, T> << ", largest of "
            << to.tried << " errors: " << to.worst << ", found " << found);
}

// Half of the constant would fail for every type: R² errs by nearly 3 units.
template <class T>
void half_is_not_enough() {
    double worst = 0;
    families::random r(3);
    for (int i = 0; i < 4000; ++i) {
        std::vector<T> x(bounds::inputs_of<bounds::radii, 2>);
        // A number just above 1, and one below half a unit in its last place.
        x[x.size() - 2] = T(1 + std::ldexp(static_cast<double>(r.below(64)), -12));
        x[x.size() - 1] =
            T(-std::ldexp(static_cast<double>(2 * r.below(1U << 10U) + 1), -graze::number_traits<T>::digits - 11));
        worst = std::max(worst, error_in_units<bounds::radii, 2, T>(x));
    }
    constexpr double k = constant<bounds::radii, 2, T>;
    CHECK(worst <= k);
    CHECK(worst > k / 2);
}

// Each quantity with its slack: how much less than the bound such a short search finds in any of the types.
// (docs/reference/error-bounds.md has a long search in two types.)
template <class T>
void check_type() {
    holds_in_every_family<T, bounds::textbook, 2>(8);
    holds_in_every_family<T, bounds::halved, 3>(8);
    holds_in_every_family<T, bounds::lagrange, 2>(8);
    holds_in_every_family<T, bounds::lagrange, 3>(8);
    holds_in_every_family<T, bounds::time_lagrange<10>, 3>(60);
    holds_in_every_family<T, bounds::clearance, 3>(8);
    holds_in_every_family<T, bounds::touch<6>, 3>(200);
    half_is_not_enough<T>();
}

} // namespace round_off
