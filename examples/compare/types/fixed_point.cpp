#include "../../fixed_point.hpp"
#include "../measure.hpp"
#include "../rounding.hpp"
#include "types.hpp"

#include <stdexcept>

namespace compare {

// The nearest multiple of 2^-32, ties away from zero.
template <>
struct converter<fixed_point> {
    [[nodiscard]] static fixed_point from(const exact& x) {
        const exact_integer twice_above = numerator(x) * (exact_integer(1) << 33U), below = denominator(x);
        const exact_integer raw = (abs(twice_above) + below) / (below * 2);
        if (raw > std::numeric_limits<std::int64_t>::max()) {
            throw std::overflow_error("beyond 2^31");
        }
        const auto magnitude = static_cast<std::int64_t>(raw);
        return fixed_point::from_raw(x.sign() < 0 ? -magnitude : magnitude);
    }
};

template <>
struct reader<fixed_point> {
    [[nodiscard]] static computed read(fixed_point x, const true_value&) { return wide(ldexp(wide(x.raw()), -32)); }
};

namespace types {

measurable of_fixed_point() {
    return measurable_type<fixed_point>("example", false,
                                        "32.32 fixed point, a type of one's own: multiples of 2^-32 below 2^31");
}

} // namespace types
} // namespace compare
