// Reads Boost's cpp_bin_float.
#pragma once

#include "../reader.hpp"

#include <graze/number/adapter/boost.hpp>

namespace compare {

template <unsigned Digits>
using cpp_bin_float =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>, boost::multiprecision::et_off>;

template <unsigned Digits>
struct reader<cpp_bin_float<Digits>> {
    static_assert(std::numeric_limits<cpp_bin_float<Digits>>::digits <= wide_digits);
    [[nodiscard]] static computed read(const cpp_bin_float<Digits>& x, const true_value&) {
        return isfinite(x) ? computed(wide(x)) : computed(not_finite{});
    }
};

} // namespace compare
