// The components of two balls' contact as exact numbers (p + q√D)/r, each rounded once.
//
// With τ = (-h - √D)/a the formulas of formula/ give, over common denominators and without a division (m' is the other
// ball's mass, M = m_a + m_b, N = a Δx - h Δu, D = h² - ac):
//   position  x + u τ                          = (a x - h u - u √D)/a                                       (13)
//   normal    (Δx + Δu τ)/R                    = (N - Δu √D)/(a R)                                          (20)
//   velocity  u ∓ (2m'/M) ⟨Δu,X̂⟩ X̂            = (M a R² u ∓ 2m' D Δu ± 2m' √D N)/(M a R²)                  (23), (29)
// since ⟨Δu,X̂⟩ = (h + aτ)/R = -√D/R; upper signs for ball a. For an overlap X̂ = Δx/|Δx| and ⟨Δu,X̂⟩ X̂ = h Δx/|Δx|².
#pragma once

#include <graze/formula/contact.hpp>
#include <graze/time/round_exactly.hpp>

namespace graze::inline v0_1::detail {

// The exponents of the scales of lengths and velocities, and where the integers on them have their digits.
struct scales {
    int length, velocity;
    workspace* room;
    [[nodiscard]] constexpr int time() const noexcept { return length - velocity; }
};

// A path until the smaller root τ of a t² + 2 h t + c.
template <class T, class Z, class A, class H>
struct exact_path {
    A a;
    H h;
    radicand<Z> discriminant;
    scales units;

    template <class From = from_now>
    [[nodiscard]] constexpr T time(const From& counted = {}) const {
        return round_root<T>(a, h, discriminant, units.time(), rounding::nearest, counted);
    }

    // a (x + u τ) + u √D, which is rational.
    template <class I, class J>
    [[nodiscard]] constexpr auto rational_part(const I& x, const J& u) const {
        return a * x - h * u;
    }
    // For a centre that is at x now and moves with u.
    template <class I, class J>
    [[nodiscard]] constexpr T position(const I& x, const J& u) const {
        return round_to<T>(rational_part(x, u), -u, discriminant, a, units.length);
    }
};
template <class T, class Z, class A, class H, class D>
[[nodiscard]] constexpr auto path_until(const A& a, const H& h, const D& discriminant, scales units) {
    return exact_path<T, Z, A, H>{a, h, radicand<Z>(discriminant), units};
}

// Two centres that approach until their distance is m.R.
template <class T, class M>
class exact_contact {
    using Z = root_sum_integer_for<M>;
    using quadratic_type = decltype(quadratic_of(std::declval<M>()));
    using path_type = exact_path<T, Z, decltype(quadratic_type::a), decltype(quadratic_type::h)>;

  public:
    constexpr exact_contact(const M& m, scales units)
        : m_(m), quadratic_(quadratic_of(m)), discriminant_(discriminant_halved{}(quadratic_)),
          path(path_until<T, Z>(quadratic_.a, quadratic_.h, discriminant_, units)) {}

  private:
    const M& m_;
    quadratic_type quadratic_;
    decltype(discriminant_halved{}(quadratic_)) discriminant_;

  public:
    path_type path;

    template <class From = from_now>
    [[nodiscard]] constexpr T time(const From& counted = {}) const {
        return counted.is_now() ? round_root_from_now<T>(quadratic_, path.discriminant, path.units.time())
                                : path.time(counted);
    }

    [[nodiscard]] constexpr T normal(int i) const {
        return round_to<T>(across(i), -m_.du[i], path.discriminant, path.a * m_.R, 0);
    }

    // The denominator of velocities; sum: of the masses.
    template <class W>
    [[nodiscard]] constexpr auto velocity_divisor(const W& sum) const {
        return sum * (path.a * (m_.R * m_.R));
    }
    // For the ball whose velocity was u. share: twice the other's mass, for ball b its negative.
    template <class I, class S, class R>
    [[nodiscard]] constexpr T velocity(const I& u, int i, const S& share, const R& divisor) const {
        return round_to<T>(divisor * u - share * (discriminant_ * m_.du[i]), share * across(i), path.discriminant,
                           divisor, path.units.velocity);
    }

  private:
    [[nodiscard]] constexpr auto across(int i) const { return path.rational_part(m_.dx[i], m_.du[i]); } // N
};

// Two centres inside each other and getting deeper: along the line between them, now.
template <class T, class M>
class exact_overlap {
    using Z = root_sum_integer_for<M>;

  public:
    constexpr exact_overlap(const M& m, scales units) : m_(m), units_(units) {}

    [[nodiscard]] constexpr T normal(int i) const { return round_to<T>(Z(0), m_.dx[i], root_, square_, 0); }

    template <class W>
    [[nodiscard]] constexpr auto velocity_divisor(const W& sum) const {
        return sum * square_;
    }
    template <class I, class S, class R>
    [[nodiscard]] constexpr T velocity(const I& u, int i, const S& share, const R& divisor) const {
        return round_to<T>(divisor * u - share * (h_ * m_.dx[i]), Z(0), radicand<Z>(), divisor, units_.velocity);
    }

  private:
    const M& m_;
    scales units_;
    decltype(coefficient_h{}(std::declval<M>())) h_ = coefficient_h{}(m_);
    decltype(graze::squared_norm(std::declval<M>().dx)) square_ = graze::squared_norm(m_.dx);
    radicand<Z> root_{square_};
};

} // namespace graze::inline v0_1::detail
