// Between exact_view and the numbers without Boost on one side and Boost's numbers on the other.
#pragma once

#include "convert.hpp"
#include "rounding.hpp"

namespace compare {

struct exact_access {
    [[nodiscard]] static exact_view view(const exact& x) { return exact_view(&x); } // valid as long as x lives
    [[nodiscard]] static const exact& behind(const exact_view& x) { return *static_cast<const exact*>(x.value_); }
};

[[nodiscard]] whole_number whole_of(const exact_integer& x);
[[nodiscard]] exact_integer integer_of(const whole_number& x);
[[nodiscard]] exact exact_of(const fraction& x);

template <class T>
[[nodiscard]] T convert(const exact& x) {
    return convert<T>(exact_access::view(x));
}

} // namespace compare
