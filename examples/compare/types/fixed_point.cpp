#include "../../fixed_point.hpp"
#include "../measure.hpp"
#include "types.hpp"

#include <stdexcept>

namespace compare {

// The nearest multiple of 2^-32, ties away from zero.
template <>
struct converter<fixed_point> {
    [[nodiscard]] static fixed_point from(const exact_view& x) {
        const whole_number units = x.in_units(32);
        std::uint64_t magnitude = 0;
        for (const std::uint32_t digit : units.digits) {
            magnitude = magnitude << 32U | digit;
        }
        if (units.digits.size() > 2 || magnitude >> 63U != 0) {
            throw std::overflow_error("beyond 2^31");
        }
        const auto raw = static_cast<std::int64_t>(magnitude);
        return fixed_point::from_raw(units.negative ? -raw : raw);
    }
};

template <>
struct reader<fixed_point> {
    static void read(fixed_point x, const request& asked) {
        const bool negative = x.raw() < 0;
        const auto bits = static_cast<std::uint64_t>(x.raw());
        const std::uint64_t magnitude = negative ? 0 - bits : bits;
        asked.to.number(
            {{negative, {static_cast<std::uint32_t>(magnitude >> 32U), static_cast<std::uint32_t>(magnitude)}}, -32});
    }
};

namespace types {

measurable of_fixed_point() {
    return measurable_type<fixed_point>("example", false,
                                        "32.32 fixed point, a type of one's own: multiples of 2^-32 below 2^31");
}

} // namespace types
} // namespace compare
