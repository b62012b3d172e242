// The largest rounding error that a search finds, in every rounding mode.
#pragma once

#include "constants.hpp"

#include "../../examples/families/random.hpp"

#include <cfenv>
#include <limits>

namespace bounds {

// u of the type in any rounding mode.
template <class T>
inline constexpr double unit = static_cast<double>(std::numeric_limits<T>::epsilon());

inline mpf_class value_of(const graze::gmp_rational& x) { return {x.value(), 400}; }
inline mpf_class value_of(const graze::sqrt_extension<graze::gmp_rational>& x) {
    return value_of(x.p()) + value_of(x.q()) * sqrt(value_of(x.d()));
}

// A separate function with a side effect, so that no compiler moves its arithmetic to where another rounding mode is
// set.
template <class Q, int N, class T>
[[gnu::noinline]] T computed(rounded_source<T>& s) {
    return Q::template run<N>(s);
}

// |computed - exact| in units u of the scales; negative outside the domain.
template <class Q, int N, class T>
[[nodiscard]] double error_in_units(std::span<const T> inputs, int mode) {
    rounded_source<T> rounded(inputs);
    std::fesetround(mode);
    const volatile T result = computed<Q, N>(rounded);
    std::fesetround(FE_TONEAREST);
    if (rounded.degenerate()) {
        return -1;
    }
    const auto scales = rounded.scales();
    double scale = 1;
    for (std::size_t i = 0; i < Q::degree.size(); ++i) {
        scale *= Q::degree[i] == 0 ? 1.0 : std::pow(scales[i], Q::degree[i]);
    }
    try {
        exact_source<T> exact(inputs);
        const mpf_class truth = value_of(Q::template run<N>(exact));
        const mpf_class difference = mpf_class(static_cast<double>(result), 400) - truth;
        return std::fabs(difference.get_d()) / (scale * unit<T>);
    } catch (const outside_domain&) {
        return -1;
    }
}

// A random number in ±[1/2, 1). Its last bits are random too: there roundings are relatively largest or smallest.
template <class T>
[[nodiscard]] T random_number(families::random& r) {
    constexpr int digits = std::numeric_limits<T>::digits;
    const std::uint64_t low = r.one_in(3) ? r.below(8) : r.next() >> (65 - digits);
    const auto magnitude = static_cast<T>((std::uint64_t{1} << (digits - 1)) | low);
    const T x = std::ldexp(magnitude, -digits);
    return r.one_in(2) ? x : -x;
}
template <class T>
[[nodiscard]] T changed(T x, families::random& r) {
    switch (r.below(4)) {
    case 0:
        return random_number<T>(r);
    case 1:
        return r.one_in(2) ? x / 2 : (std::fabs(x) < T(1) ? x * 2 : x);
    case 2:
        return -x;
    default: { // a small change, down to the last bit
        const int bits = static_cast<int>(r.below(static_cast<std::uint64_t>(std::numeric_limits<T>::digits)));
        const T step = std::ldexp(x, -bits - 1);
        return r.one_in(2) ? x + step : x - step;
    }
    }
}

// Random starts in the domain, then changes of one number that make the error larger.
template <class Q, int N, class T>
[[nodiscard]] double worst_error(int starts, int steps) {
    constexpr std::array modes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    std::array<T, inputs_of<Q, N>> x{};
    double worst = 0;
    families::random r(17);
    for (int start = 0; start < starts; ++start) {
        const int mode = modes[static_cast<std::size_t>(start) % modes.size()];
        double error = -1;
        for (int tries = 0; error < 0 && tries < 300; ++tries) {
            for (T& component : x) {
                component = random_number<T>(r);
            }
            error = error_in_units<Q, N, T>(x, mode);
        }
        for (int step = 0; error >= 0 && step < steps; ++step) {
            auto y = x;
            for (std::uint64_t changes = 1 + r.below(2); changes != 0; --changes) {
                T& component = y[r.below(y.size())];
                component = changed(component, r);
            }
            if (const double other = error_in_units<Q, N, T>(y, mode); other > error) {
                error = other;
                x = y;
            }
        }
        worst = std::max(worst, error);
    }
    return worst;
}

} // namespace bounds
