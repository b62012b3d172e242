// Lanes as a number: a formula runs in all of them at once.
#pragma once

#include <graze/machine/pack.hpp>
#include <graze/number/floating.hpp>

template <class T, int Lanes>
struct graze::number_traits<graze::detail::pack<T, Lanes>> {
    static constexpr const char* name = "pack";
    static constexpr bool is_exact = false;
    static constexpr int digits = number_traits<T>::digits;

    using lanes = detail::pack<T, Lanes>;
    [[nodiscard, gnu::always_inline]] static inline lanes larger(const lanes& x, const lanes& y) noexcept {
        return detail::chosen(x < y, y, x);
    }
    [[nodiscard, gnu::always_inline]] static inline lanes smaller(const lanes& x, const lanes& y) noexcept {
        return detail::chosen(y < x, y, x);
    }
};
