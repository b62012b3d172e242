// The signs of a motion's formulas by the sizes of their terms: stages 2 and 3 of a decision.
#pragma once

#include <graze/analysis/rounding_count.hpp>
#include <graze/analysis/word_rounding.hpp>
#include <graze/exact/binary.hpp>
#include <graze/filter/static_filter.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/number/loose_word.hpp>
#include <graze/pair/open_number.hpp>

namespace graze::inline v0_1::detail {

// What is known of the arithmetic: a number type of the analysis with the inputs of a motion, and the bound that it
// stands for. Doubles hold inputs that have been rounded once, in any rounding mode; loose words hold exact ones.
struct of_doubles {
    using count = rounding_count;
    static constexpr rounding_count input = rounding_count::rounded_input();
    static constexpr rounding_count exact = rounding_count::exact_input();
    static constexpr rounding_count given = rounding_count::exact_input(); // a number of the input
    [[nodiscard]] static consteval double bound(const rounding_count& x) { return x.bound(0x1p-52); }
};
struct of_words {
    using count = word_rounding;
    static constexpr word_rounding input = word_rounding::exact_input();
    static constexpr word_rounding exact = word_rounding::exact_input();
    static constexpr word_rounding given = word_rounding::exact_double();
    [[nodiscard]] static consteval double bound(const word_rounding& x) { return x.bound(); }
};

[[nodiscard]] constexpr double leading_double(double x) noexcept { return x; }
template <bool Fused>
[[nodiscard]] constexpr double leading_double(const loose_word<Fused>& x) noexcept {
    return settled(x.high + x.low); // where terms cancel, low may be the larger one
}

// The same number with its low part at most half a last place of the high one: as an input is.
[[nodiscard]] constexpr double as_input(double x) noexcept { return x; }
template <bool Fused>
[[nodiscard, gnu::always_inline]] constexpr loose_word<Fused> as_input(const loose_word<Fused>& x) noexcept {
    return loose_word<Fused>(two_sum(x.high, x.low));
}
template <class V>
[[nodiscard, gnu::always_inline]] constexpr vec<3, V> as_input(const vec<3, V>& x) noexcept {
    return {{as_input(x[0]), as_input(x[1]), as_input(x[2])}};
}

template <class V>
requires number<V>
[[nodiscard]] constexpr term_size size_of(const V& x) noexcept { return term_size(leading_double(x)); }
template <int N, class V>
[[nodiscard, gnu::always_inline]] constexpr inline vec<N, term_size> size_of(const vec<N, V>& x) noexcept {
    if constexpr (N == 2) {
        return {{size_of(x[0]), size_of(x[1])}};
    } else {
        return {{size_of(x[0]), size_of(x[1]), size_of(x[2])}};
    }
}
template <int N, class V>
[[nodiscard, gnu::always_inline]] constexpr inline auto size_of(const relative_motion<N, V, V, V>& m) noexcept {
    return relative_motion{size_of(m.dx), size_of(m.du), size_of(m.R)};
}

// A computed value and a bound on its error.
template <class V>
struct bounded_value {
    V value;
    double error;

    [[nodiscard]] constexpr int sign() const noexcept { return certain_sign(leading_double(value), error); }
};

// Bounds on the errors of Δx × Δu, component by component, and of D from it, relative to the sizes of their terms.
template <class Arithmetic, class Motion, int N>
class lagrange_bounds {
    using count = typename Arithmetic::count;

    [[nodiscard]] static constexpr count component(const count& x) { return x; }
    [[nodiscard]] static constexpr count component(const vec<3, count>& x) { return x[0]; }
    [[nodiscard]] static constexpr count exact_like(const count&) { return Arithmetic::exact; }
    [[nodiscard]] static constexpr vec<3, count> exact_like(const vec<3, count>&) {
        return {{Arithmetic::exact, Arithmetic::exact, Arithmetic::exact}};
    }
    struct constants {
        double of_cross, of_rest;

        consteval constants() : of_cross(0), of_rest(0) {
            const auto m = Motion::template value<N, Arithmetic>();
            const auto cross = graze::cross(m.dx, m.du);
            of_cross = Arithmetic::bound(component(cross));
            of_rest = Arithmetic::bound(discriminant_of_cross{}(m.R, graze::squared_norm(m.du), exact_like(cross)));
        }
    };

  public:
    static constexpr double of_cross = constants().of_cross;
    static constexpr double of_rest = constants().of_rest;
};

// Formulas of a motion in numbers V; Motion::value<N, Arithmetic>() is the same motion in the analysis. Losses by
// underflow, or by flushing to zero, in lengths L, velocities V and a lead are a few times 2^-1022 (L + V + L V) after
// one product, or 2^-922 with a lead below 2^100; multiplied once more they are below 2^-900 (1 + L²)(1 + V²). The
// range holds all floats.
template <class Arithmetic, class Motion, int N, class V>
struct sized_motion {
    const relative_motion<N, V, V, V>& motion;
    relative_motion<N, term_size, term_size, term_size> size;
    double length2, speed2;
    double lost;

    bool has_range;

    // s: the sizes of the terms of the motion's numbers. epochs: whether epochs are in range.
    [[gnu::always_inline]] constexpr sized_motion(const relative_motion<N, V, V, V>& m,
                                                  const relative_motion<N, term_size, term_size, term_size>& s,
                                                  bool epochs) noexcept
        : motion(m), size(s), length2((graze::squared_norm(size.dx) + size.R * size.R).value),
          speed2(graze::squared_norm(size.du).value), lost(0x1p-900 * ((1 + length2) * (1 + speed2))),
          has_range((static_cast<unsigned>(within_powers<-300, 262>(length2)) &
                     static_cast<unsigned>(within_powers<-300, 262>(speed2)) & static_cast<unsigned>(epochs)) != 0) {}

    [[nodiscard]] constexpr bool in_range() const noexcept { return has_range; }

    template <class F>
    [[nodiscard, gnu::always_inline]] constexpr bounded_value<V> operator()(F f) const noexcept {
        constexpr double k = Arithmetic::bound(F{}(Motion::template value<N, Arithmetic>()));
        return {f(motion), k * f(size).value + lost};
    }

    // D by Lagrange's identity.
    [[nodiscard, gnu::always_inline]] constexpr bounded_value<V> discriminant() const noexcept {
        using lagrange = lagrange_bounds<Arithmetic, Motion, N>;
        const auto cross = as_input(graze::cross(motion.dx, motion.du));
        const auto cross_size = size_of(cross);
        const double terms = discriminant_of_cross{}(size.R, graze::squared_norm(size.du), cross_size).value;
        const double moved = square_moved(cross_size, graze::cross(size.dx, size.du), lagrange::of_cross);
        return {discriminant_of_cross{}(motion.R, graze::squared_norm(motion.du), cross),
                lagrange::of_rest * terms + moved + lost};
    }

  private:
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

// The encounter, or `undecided`, from a sized motion, and the numbers on which it rests, in this order. If one is open,
// the later ones are not computed.
inline constexpr int undecided = -1;
template <class V>
struct bounded_encounter {
    int what = undecided;
    bounded_value<V> h{}, c{}, discriminant{};
};
template <class M>
[[nodiscard, gnu::always_inline]] constexpr auto encounter_of_sized(const M& m) noexcept {
    bounded_encounter<decltype(m(coefficient_h{}).value)> r;
    r.h = m(coefficient_h{});
    if (const int h = r.h.sign(); h != -1) {
        r.what = h == open ? undecided : static_cast<int>(encounter::recede);
        return r;
    }
    r.c = m(coefficient_c{});
    if (const int c = r.c.sign(); c != 1) {
        r.what = c == open ? undecided : static_cast<int>(encounter::overlap);
        return r;
    }
    r.discriminant = m.discriminant();
    const int d = r.discriminant.sign();
    r.what = d == open ? undecided : static_cast<int>(d < 0 ? encounter::miss : encounter::hit);
    return r;
}
template <class M>
[[nodiscard, gnu::always_inline]] constexpr int decided_encounter(const M& m) noexcept {
    return encounter_of_sized(m).what;
}

// More than the magnitude of an open number: that is at most twice its error, and the error's own roundings are small.
// 0, which says nothing, if Dekker's product made a NaN of a velocity that is out of its range.
template <class V>
[[nodiscard]] constexpr double limit_of(const bounded_value<V>& x) noexcept {
    const double value = leading_double(x.value);
    return is_finite_input(value) ? 4 * x.error : 0;
}

// Where an encounter is undecided, the number that leaves it open: the last one computed, as an error is never 0.
struct limited_encounter {
    int what;
    open_number::name left;
    double limit;
};
template <class V>
[[nodiscard, gnu::always_inline]] constexpr limited_encounter limited(const bounded_encounter<V>& r) noexcept {
    if (r.discriminant.error != 0) {
        return {r.what, open_number::discriminant, limit_of(r.discriminant)};
    }
    return r.c.error != 0 ? limited_encounter{r.what, open_number::c, limit_of(r.c)}
                          : limited_encounter{r.what, open_number::h, limit_of(r.h)};
}

} // namespace graze::inline v0_1::detail
