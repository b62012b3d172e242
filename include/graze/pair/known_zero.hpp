// Of a number only whether it is known to be 0.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/linear/vec.hpp>
#include <graze/number/traits.hpp>

namespace graze::inline v0_1::detail {

// A formula that runs in it tells whether it vanishes because its inputs are zeros, as u·n does for what moves along an
// axis and a plane parallel to it. It computes nothing, so nothing is rounded, and no flags or modes change it. It does
// not know of terms that cancel.
class known_zero {
  public:
    constexpr known_zero() = default;
    constexpr explicit(false) known_zero(int x) noexcept : is_zero_(x == 0) {}
    template <class T>
    requires is_binary_input<T>
    constexpr explicit known_zero(const T& x) noexcept : is_zero_(detail::is_zero(x)) {}

    [[nodiscard]] constexpr bool is_zero() const noexcept { return is_zero_; }

    [[nodiscard]] constexpr known_zero operator-() const noexcept { return *this; }
    [[nodiscard]] friend constexpr known_zero operator+(known_zero x, known_zero y) noexcept {
        return of(x.is_zero_ && y.is_zero_);
    }
    [[nodiscard]] friend constexpr known_zero operator-(known_zero x, known_zero y) noexcept { return x + y; }
    [[nodiscard]] friend constexpr known_zero operator*(known_zero x, known_zero y) noexcept {
        return of(x.is_zero_ || y.is_zero_);
    }

  private:
    [[nodiscard]] static constexpr known_zero of(bool is_zero) noexcept { return is_zero ? 0 : 1; }

    bool is_zero_ = true;
};

template <int N, class T>
[[nodiscard]] constexpr vec<N, known_zero> known_zeros(const vec<N, T>& x) noexcept {
    return make_vec<N>([&](int i) { return known_zero(x[i]); });
}

} // namespace graze::inline v0_1::detail

template <>
struct graze::number_traits<graze::detail::known_zero> {
    static constexpr const char* name = "known_zero";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0;
};
