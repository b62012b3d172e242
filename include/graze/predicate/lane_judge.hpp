// The signs that decide the encounter of balls and a flat shape, in lanes.
#pragma once

#include <graze/machine/pack_transforms.hpp>
#include <graze/number/pack_number.hpp>
#include <graze/pair/flat_signs.hpp>

namespace graze::inline v0_1::detail {

// The same numbers in doubles, whose bounds are those of filtered_judge.
template <template <int, class> class X, int N, class V>
[[nodiscard]] X<N, double> numbers_in_doubles(const X<N, V>&);
template <template <class> class X, class V>
[[nodiscard]] X<double> numbers_in_doubles(const X<V>&);

// The lanes in which a sign is certainly positive, and certainly negative.
template <class V>
struct lane_sign {
    typename V::mask positive, negative;

    [[nodiscard, gnu::always_inline]] typename V::mask certain() const noexcept { return positive | negative; }
    // The sign of a product.
    [[nodiscard, gnu::always_inline]] friend inline lane_sign operator*(const lane_sign& x,
                                                                        const lane_sign& y) noexcept {
        return {(x.positive & y.positive) | (x.negative & y.negative),
                (x.positive & y.negative) | (x.negative & y.positive)};
    }
};

// filtered_judge in lanes of doubles that come from inputs of type T.
template <int N, class T, class V>
struct lane_judge {
    V length, velocity, edge; // scales

    [[gnu::always_inline]] explicit lane_judge(const flat_motion<N, V>& m) noexcept
        : length(size_of(m.w) + m.r), velocity(size_of(m.u)), edge(0) {
        V sum(0);
        for (const auto& e : m.e) {
            const V size = size_of(e);
            sum = sum + size;
            edge = graze::larger(edge, size);
        }
        length = length + sum;
        edge = N == 3 && m.is_triangle ? sum : edge;
    }
    // Whether the scales are in the filter's range, as usable() has it.
    [[nodiscard, gnu::always_inline]] typename V::mask in_range() const noexcept {
        return in_range_or_at_rest() & within_powers<low, 50>(velocity);
    }
    // The same for questions in which velocities don't matter: they may be zero, or read as zero.
    [[nodiscard, gnu::always_inline]] typename V::mask in_range_or_at_rest() const noexcept {
        return within_powers<low, 50>(length) & within_powers<low, 50>(edge) & (velocity < V(0x1p50));
    }
    template <class F, class X>
    [[nodiscard, gnu::always_inline]] lane_sign<V> operator()(F f, const X& x) const noexcept {
        using in_doubles = decltype(numbers_in_doubles(x));
        using bounds = typename filtered_judge<N, T>::template bounds<in_doubles>;
        constexpr double k = filter_constant(F{}, bounds::value());
        constexpr error_bound::degrees d = filter_degrees(F{}, bounds::value());
        const V bound = k * (power_of<d[0]>(length) * power_of<d[1]>(velocity) * power_of<d[2]>(edge));
        const V value = f(x);
        return {value > bound, value < -bound};
    }

  private:
    static constexpr int low = std::is_same_v<T, float> ? -30 : -50;

    [[nodiscard, gnu::always_inline]] static V size_of(const vec<N, V>& x) noexcept {
        V sum = absolute(x[0]);
        for (int i = 1; i < N; ++i) {
            sum = sum + absolute(x[i]);
        }
        return sum;
    }
};

} // namespace graze::inline v0_1::detail
