// The sign of any formula of a pair: filter first, integers where the filter is not certain.
#pragma once

#include <graze/filter/scaled_filter.hpp>
#include <graze/formula/wall_encounter.hpp>
#include <graze/pair/exact_sign.hpp>
#include <graze/pair/pair.hpp>
#include <graze/pair/stage.hpp>

#include <type_traits>

namespace graze::inline v0_1::detail {

struct identity_view {
    template <class M>
    [[nodiscard]] constexpr const M& operator()(const M& m) const noexcept {
        return m;
    }
};

// Asks formulas of one pair of kind P: M its motion in doubles, Bounds the same in error_bound, Row its packed inputs.
template <class P, class Bounds, class M, class Row>
class certain_signs {
  public:
    constexpr certain_signs(const M& motion, const magnitudes& scales, const Row& row) noexcept
        : motion_(motion), scales_(scales), row_(row),
          filter_(!std::is_constant_evaluated() && usable<typename Row::value_type>(scales)) {}

    // Of a ball whose velocity is zero: every formula in which it takes part is zero.
    constexpr void rest() noexcept {
        at_rest_ = true;
        scales_.velocity = 1;
        filter_ = !std::is_constant_evaluated() && usable<typename Row::value_type>(scales_);
    }

    template <class F>
    [[nodiscard]] constexpr int operator()(F f) {
        return ask(identity_view{}, f);
    }
    template <class F>
    [[nodiscard]] constexpr int operator()(wall_view view, F f) {
        return ask([view](const auto& m) { return seen_from(m, view); }, f);
    }

    // p + flip q√d, d >= 0, by the signs of p, q and p² - q²d.
    template <class F, class Q, class D>
    [[nodiscard]] constexpr int root(wall_view view, F p, Q q, D d, int flip) {
        const int sign_p = (*this)(view, p);
        const int sign_q = flip * (*this)(view, q);
        if (sign_q == 0 || sign_q == sign_p || (*this)(view, d) == 0) {
            return sign_p;
        }
        return sign_p == 0 ? sign_q : sign_p * (*this)(view, root_norm<F, Q, D>{});
    }
    [[nodiscard]] constexpr int edge_discriminant(wall_view view) { return (*this)(view, edge_reduced_discriminant{}); }
    [[nodiscard]] constexpr int corner_discriminant(wall_view view) {
        return (*this)(view, corner_formula<discriminant_lagrange>{});
    }

    // Which stage the answers so far came from: exact as soon as one of them did.
    [[nodiscard]] constexpr stage decided_by() const noexcept { return lifted_ ? stage::exact : stage::filter; }

  private:
    template <class View, class F>
    [[nodiscard]] constexpr int ask(View view, F f) {
        if constexpr (filter_degrees(F{}, Bounds::value())[1] > 0) {
            if (at_rest_) {
                return 0;
            }
        }
        if (filter_) {
            if (const int s = filtered_sign<Bounds>(f, view(motion_), scales_); s != open) {
                return s;
            }
        }
        if (!lifted_) {
            inputs_ = lift_row<P>(row_);
            lifted_ = true;
        }
        return with_exact_motion<P>(
            inputs_, [&](const auto& m) { return exact_sign(m, [&](const auto& x) { return f(view(x)); }); });
    }

    const M& motion_;
    magnitudes scales_;
    const Row& row_;
    bool filter_;
    bool lifted_ = false;
    bool at_rest_ = false;
    lifted_inputs<P::lengths, P::velocities, P::normals> inputs_{};
};

} // namespace graze::inline v0_1::detail
