// The 113-bit __float128 of g++ with libquadmath (link quadmath). If the compiler has no quadmath.h, as clang, this
// header declares nothing and GRAZE_HAS_FLOAT128 is 0.
#pragma once

#include <graze/number/traits.hpp>

#if defined(__SIZEOF_FLOAT128__) && __has_include(<quadmath.h>)
#define GRAZE_HAS_FLOAT128 1
#include <quadmath.h>

namespace graze::inline v0_1 {

template <>
struct number_traits<__float128> {
    static constexpr const char* name = "__float128";
    static constexpr bool is_exact = false;
    static constexpr int digits = FLT128_MANT_DIG;
    static __float128 sqrt(__float128 x) noexcept { return sqrtq(x); }
    static __float128 fma(__float128 x, __float128 y, __float128 z) noexcept { return fmaq(x, y, z); }
};

} // namespace graze::inline v0_1
#else
#define GRAZE_HAS_FLOAT128 0
#endif
