// |computed - exact| <= K 2^-p M for a type T of p bits that rounds to nearest: K as the compiler derives it, M the
// inputs' scales to the quantity's degrees; for pairs of every hard family.
#pragma once

#include "../../proofs/bounds/quantities.hpp"
#include "../formula/inexact.hpp"
#include "../soak/more_families.hpp"

#include <graze/analysis/error_bound.hpp>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <string>
#include <vector>

namespace round_off {

// With u = 2^-p.
template <class Q, int N, class T>
inline constexpr double constant = [] {
    double worst = 0;
    for (int slice = 0; slice < bounds::slices_of<Q>; ++slice) {
        bounds::compiled_source<graze::number_traits<T>::digits + 1> s;
        worst = std::max(worst, bounds::run_slice<Q, N>(s, slice).error * graze::error_bound_slack);
    }
    return worst;
}();

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
double error_in_units(const std::vector<double>& inputs) {
    std::vector<T> in_t;
    for (const double x : inputs) {
        in_t.push_back(static_cast<T>(x));
    }
    std::vector<double> held; // float may hold something else
    for (const T& x : in_t) {
        held.push_back(static_cast<double>(x));
        if (!std::isfinite(held.back())) {
            return -1;
        }
    }
    bounds::rounded_source<T> rounded(in_t);
    const T computed = Q::template run<N>(rounded);
    double scale = 1;
    for (std::size_t i = 0; i < Q::degree.size(); ++i) {
        if (Q::degree[i] != 0) {
            if (!in_range(rounded.scales()[i])) {
                return -1;
            }
            scale *= std::pow(rounded.scales()[i], Q::degree[i]);
        }
    }
    try {
        bounds::exact_source<double> exact(held, rounded.scales());
        const mpf_class truth = precise(Q::template run<N>(exact));
        const mpf_class difference = mpf_class(inexact::exact_value(computed), 2000) - truth;
        return std::ldexp(std::fabs(difference.get_d()), graze::number_traits<T>::digits) / scale;
    } catch (const bounds::outside_domain&) {
        return -1;
    }
}

template <class Q, int N, class T>
void check(const std::vector<double>& inputs, record& r) {
    const double error = error_in_units<Q, N, T>(inputs);
    if (error >= 0) {
        ++r.tried;
        r.worst = std::max(r.worst, error);
        RC_ASSERT(error <= (constant<Q, N, T>));
    }
}

// The numbers of a pair in the order in which the quantities take them: the two of which each difference is made.
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
void check_quantity(const families::pair_of_doubles<N>& pair, bool of_plane, record& r) {
    if (pair.kind == families::pair_kind::ball_plane && of_plane) {
        check<Q, N, T>(numbers<N>(pair.a, pair.plane), r);
    } else if (pair.kind == families::pair_kind::ball_ball && !of_plane) {
        check<Q, N, T>(numbers<N>(pair.a, pair.b), r);
    }
}

// One property a quantity; every family is drawn from.
template <class T, class Q, int N>
void holds_in_every_family(bool of_plane) {
    record r;
    const auto draw = [&](const auto& drawn) {
        for (const auto& family : drawn) {
            for (int i = 0; i < 6; ++i) {
                const auto index = *rc::gen::arbitrary<std::uint64_t>();
                check_quantity<T, Q, N>(family.template draw<N>(1, index % (1U << 20U)), of_plane, r);
            }
        }
    };
    CHECK(rc::check(std::string(graze::number_traits<T>::name) + ", " + Q::name, [&] {
        draw(families::all_families);
        draw(families::more_families);
    }));
    CHECK(r.tried > 20);
    MESSAGE(std::string(graze::number_traits<T>::name)
            << ", " << N << "D, " << std::string(Q::name) << ": bound " << constant<Q, N, T> << ", largest of "
            << r.tried << " errors: " << r.worst);
}

// Half of the constant would be found out, for every type: R² errs by nearly 3 units.
template <class T>
void half_is_not_enough() {
    double worst = 0;
    families::random r(3);
    for (int i = 0; i < 4000; ++i) {
        std::vector<double> x(bounds::inputs_of<bounds::radii, 2>);
        // A little more than 1, and something below half a unit in its last place.
        x[x.size() - 2] = 1 + std::ldexp(static_cast<double>(r.below(64)), -12);
        x[x.size() - 1] =
            -std::ldexp(static_cast<double>(2 * r.below(1U << 10U) + 1), -graze::number_traits<T>::digits - 11);
        worst = std::max(worst, error_in_units<bounds::radii, 2, T>(x));
    }
    constexpr double k = constant<bounds::radii, 2, T>;
    CHECK(worst <= k);
    CHECK(worst > k / 2);
}

template <class T>
void check_type() {
    holds_in_every_family<T, bounds::textbook, 2>(false);
    holds_in_every_family<T, bounds::halved, 3>(false);
    holds_in_every_family<T, bounds::lagrange, 2>(false);
    holds_in_every_family<T, bounds::lagrange, 3>(false);
    holds_in_every_family<T, bounds::time_lagrange<10>, 3>(false);
    holds_in_every_family<T, bounds::clearance, 3>(true);
    half_is_not_enough<T>();
}

} // namespace round_off
