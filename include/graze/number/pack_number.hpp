// Lanes as a number: a formula runs in all of them at once.
#pragma once

#include <graze/machine/pack.hpp>
#include <graze/number/floating.hpp>

template <class T, int Lanes>
struct graze::number_traits<graze::detail::pack<T, Lanes>> {
    static constexpr const char* name = "pack";
    static constexpr bool is_exact = false;
    static constexpr int digits = number_traits<T>::digits;
};
