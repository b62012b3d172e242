// The signs of a motion's formulas by the sizes of their terms: stages 2 and 3 of a decision.
#pragma once

#include <graze/analysis/rounding_count.hpp>
#include <graze/filter/static_filter.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/number/double_word.hpp>

namespace graze::inline v0_1::detail {

// What is known of the arithmetic: doubles in any rounding mode, and double words to nearest, whose sums and products
// are right to 7u² < 2^-103.
struct of_doubles {
    static constexpr double unit = 0x1p-52;
};
struct of_double_words {
    static constexpr double unit = 0x1p-103;
};

[[nodiscard]] constexpr double leading_double(double x) noexcept { return x; }
template <bool Fused>
[[nodiscard]] constexpr double leading_double(const basic_double_word<Fused>& x) noexcept {
    return x.high();
}
template <class V>
requires number<V>
[[nodiscard]] constexpr term_size size_of(const V& x) noexcept { return term_size(leading_double(x)); }
template <int N, class V>
[[nodiscard]] constexpr auto size_of(const vec<N, V>& x) noexcept {
    return make_vec<N>([&](int i) { return size_of(x[i]); });
}
template <int N, class V>
[[nodiscard]] constexpr auto size_of(const relative_motion<N, V, V, V>& m) noexcept {
    return relative_motion{size_of(m.dx), size_of(m.du), size_of(m.R)};
}

// A motion each of whose numbers is `count`.
template <int N>
[[nodiscard]] consteval auto counted_motion(const rounding_count& count) {
    const auto each = make_vec<N>([&](int) { return count; });
    return relative_motion{each, each, count};
}

// A computed value and what it can be off by.
template <class V>
struct bounded_value {
    V value;
    double error;

    [[nodiscard]] constexpr int sign() const noexcept { return certain_sign(leading_double(value), error); }
};

// Formulas of a motion whose inputs have taken `Counts` roundings, a type whose value() is the motion in
// rounding_count. What underflows, or is flushed to zero, in lengths L and velocities V is a few times 2^-1022 (L + V +
// L V) after one product; once more multiplied it is below 2^-1010 (1 + L²)(1 + V²), L, V < 2^100.
template <class Arithmetic, class Counts, int N, class V>
struct sized_motion {
    const relative_motion<N, V, V, V>& motion;
    relative_motion<N, term_size, term_size, term_size> size;
    double length2, speed2;
    double lost;

    // length: the same motion with lengths of which |Δx| and R are at most the norms.
    [[gnu::always_inline]] constexpr sized_motion(const relative_motion<N, V, V, V>& m,
                                                  const relative_motion<N, term_size, term_size, term_size>& s) noexcept
        : motion(m), size(s), length2((graze::squared_norm(s.dx) + s.R * s.R).value),
          speed2(graze::squared_norm(s.du).value), lost(0x1p-1010 * ((1 + length2) * (1 + speed2))) {}

    [[nodiscard, gnu::always_inline]] constexpr bool in_range() const noexcept {
        return (static_cast<unsigned>(within_powers<-200, 200>(length2)) &
                static_cast<unsigned>(within_powers<-200, 200>(speed2))) != 0;
    }

    template <class F>
    [[nodiscard, gnu::always_inline]] constexpr bounded_value<V> operator()(F f) const noexcept {
        constexpr double k = f_count<F>().bound(Arithmetic::unit);
        return {f(motion), k * f(size).value + lost};
    }

    // D by Lagrange's identity: first the error of Δx × Δu, component by component, then what it does to the square.
    [[nodiscard, gnu::always_inline]] constexpr bounded_value<V> discriminant() const noexcept {
        const auto cross = graze::cross(motion.dx, motion.du);
        const auto a = graze::squared_norm(motion.du);
        constexpr auto counts = Counts::value();
        constexpr double of_cross = one_of(graze::cross(counts.dx, counts.du)).bound(Arithmetic::unit);
        constexpr double of_rest = discriminant_of_cross{}(counts.R, graze::squared_norm(counts.du),
                                                           exact_like(graze::cross(counts.dx, counts.du)))
                                       .bound(Arithmetic::unit);
        const auto cross_size = size_of(cross);
        const double terms = discriminant_of_cross{}(size.R, graze::squared_norm(size.du), cross_size).value;
        const double moved = square_moved(cross_size, graze::cross(size.dx, size.du), of_cross);
        return {discriminant_of_cross{}(motion.R, a, cross), of_rest * terms + moved + lost};
    }

  private:
    template <class F>
    [[nodiscard]] static consteval rounding_count f_count() {
        return F{}(Counts::value());
    }
    [[nodiscard]] static consteval rounding_count one_of(const rounding_count& x) { return x; }
    [[nodiscard]] static consteval rounding_count one_of(const vec<3, rounding_count>& x) { return x[0]; }
    [[nodiscard]] static consteval rounding_count exact_like(const rounding_count&) {
        return rounding_count::exact_input();
    }
    [[nodiscard]] static consteval vec<3, rounding_count> exact_like(const vec<3, rounding_count>&) { return {}; }

    // |X² - x²| <= e (2|x| + e) for |X - x| <= e.
    [[nodiscard]] static constexpr double square_moved(const term_size& x, const term_size& terms, double k) noexcept {
        const double e = k * terms.value;
        return e * (2 * x.value + e);
    }
    [[nodiscard]] static constexpr double square_moved(const vec<3, term_size>& x, const vec<3, term_size>& terms,
                                                       double k) noexcept {
        return square_moved(x[0], terms[0], k) + square_moved(x[1], terms[1], k) + square_moved(x[2], terms[2], k);
    }
};

// The encounter, or `undecided`, from a sized motion.
inline constexpr int undecided = -1;
template <class M>
[[nodiscard, gnu::always_inline]] constexpr int decided_encounter(const M& m) noexcept {
    const int h = m(coefficient_h{}).sign();
    if (h == open) {
        return undecided;
    }
    if (h > 0) {
        return static_cast<int>(encounter::recede);
    }
    const int c = m(coefficient_c{}).sign();
    if (c == open) {
        return undecided;
    }
    if (c < 0) {
        return static_cast<int>(encounter::overlap);
    }
    const int d = m.discriminant().sign();
    return d == open ? undecided : static_cast<int>(d < 0 ? encounter::miss : encounter::hit);
}

} // namespace graze::inline v0_1::detail
