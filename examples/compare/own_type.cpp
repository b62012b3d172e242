#include "own_type.hpp"

#include "exact_access.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace compare {

void tell(const graze::precision::reading& x, const request& asked) {
    exact_integer sum = 0;
    int unit = 0; // the sum is in units of 2^unit
    for (const double part : x.parts) {
        if (!std::isfinite(part)) {
            asked.to.not_finite();
            return;
        }
        int exponent = 0;
        const auto significand = static_cast<long long>(std::ldexp(std::frexp(part, &exponent), 53));
        exponent -= 53;
        if (significand != 0 && exponent < unit) {
            sum <<= static_cast<unsigned>(unit - exponent);
            unit = exponent;
        }
        if (significand != 0) {
            sum += exact_integer(significand) << static_cast<unsigned>(exponent - unit);
        }
    }
    const long power = static_cast<long>(unit) + x.exponent;
    if (x.decimal_exponent == 0) {
        asked.to.number({whole_of(sum), power});
        return;
    }
    // 2^-k is 5^k 10^-k.
    const auto size = static_cast<unsigned>(std::labs(power));
    sum = power < 0 ? exact_integer(sum * boost::multiprecision::pow(exact_integer(5), size))
                    : exact_integer(sum << size);
    asked.to.decimal(sum < 0, exact_integer(abs(sum)).str(), x.decimal_exponent + std::min(power, 0L));
}

} // namespace compare
