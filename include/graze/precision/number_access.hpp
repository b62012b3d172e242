// How the precision regression converts numbers into a type and back, without an error of its own.
#pragma once

#include <graze/number/floating.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace graze::inline v0_1::precision {

// A number in doubles: exactly the sum of the parts, times 2^exponent 10^decimal_exponent. There is at least one part.
// A part that is not finite means that the value is not a number.
struct reading {
    std::vector<double> parts;
    int exponent = 0;
    int decimal_exponent = 0;
};

namespace detail {

inline constexpr std::size_t most_parts = 32;

// The exponent field of x. Being an integer, it can be compared under flags that promise finite numbers.
[[nodiscard]] constexpr int exponent_field(double x) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52U & 0x7ffU);
}

template <class T>
concept cast_from_and_to_double = requires(double x, const T& y) {
    static_cast<T>(x);
    static_cast<double>(y);
};

} // namespace detail

// Specialise it for a number type that static_cast does not convert from and to double, or that is not a sum of a few
// doubles.
//   from   the value of T that the formulas start from; the regression computes the truth for that value, not for x
//   read   the value of a result, exactly
template <number T>
struct number_access {
    static_assert(
        detail::cast_from_and_to_double<T>,
        "specialise graze::precision::number_access for this number type: static_cast does not convert it from and "
        "to double (docs/how-to/precision-of-your-own.md)");

    [[nodiscard]] static T from(double x) {
        if constexpr (detail::cast_from_and_to_double<T>) {
            return static_cast<T>(x);
        } else {
            return T(0);
        }
    }

    // The leading double, then that of the remainder, and so on. Beyond the range of double, powers of two are taken
    // out first.
    [[nodiscard]] static reading read(T x) {
        reading r;
        if constexpr (std::is_same_v<T, float> || std::is_same_v<T, double>) {
            r.parts.push_back(static_cast<double>(x));
            return r;
        } else {
            constexpr int step = 512, low = 1023 - 400, high = 1023 + 900, steps = 64;
            for (int i = 0; i < steps && graze::sign(x) != 0 && digits_exceed_double(); ++i) {
                const int field = detail::exponent_field(nearest(x));
                if (field >= low && field <= high) {
                    break;
                }
                const bool is_large = field > high;
                x = x * from(is_large ? 0x1p-512 : 0x1p512);
                r.exponent += is_large ? step : -step;
            }
            do {
                const double part = nearest(x);
                r.parts.push_back(part);
                if (detail::exponent_field(part) == 0x7ff) {
                    break;
                }
                x = x - from(part);
            } while (graze::sign(x) != 0 && r.parts.size() < detail::most_parts);
            return r;
        }
    }

  private:
    // Whether the range may exceed double's too. Types without a number of digits, such as fixed-point types, have a
    // range of their own.
    static constexpr bool digits_exceed_double() { return number_traits<T>::digits > 53; }

    // Through memory, so that no flag lets a compiler drop the conversion and its inverse.
    [[nodiscard]] static double nearest(const T& x) {
        if constexpr (detail::cast_from_and_to_double<T>) {
            const volatile double y = static_cast<double>(x);
            return y;
        } else {
            return 0;
        }
    }
};

// What the regression must know of a type. digits: those of the significand; errors are in units of its last place, or
// for a decimal type of the last of its decimal_digits. lowest: the exponent of the smallest positive number, if there
// is one.
struct number_type {
    std::string name;
    int digits = 53;
    int decimal_digits = 0;
    int lowest = std::numeric_limits<int>::min();
    double (*held)(double) = nullptr; // x as the type holds it; a binary one of 53 digits or more holds every double
    reading (*rounded)(double) = nullptr; // of a decimal type: what it holds for x, which is no double
};

// A name as one word of tables, and of files of figures, in which a slash, # and ! have meanings of their own.
[[nodiscard]] inline std::string word_of(std::string name) {
    constexpr std::string_view marks = " \t\n\r/#!";
    for (char& letter : name) {
        letter = marks.find(letter) != std::string_view::npos ? '_' : letter;
    }
    return name.empty() ? "_" : name;
}

// The name is word_of that of the traits; that of long double contains its digits, which differ between platforms. A
// type without a number of digits gets those of double. Sums of several doubles have the exponents of double, but a
// unit in the last place far below the smallest double; for them, lowest is as if the exponents had no lower limit.
template <number T>
[[nodiscard]] number_type describe() {
    using traits = number_traits<T>;
    using limits = std::numeric_limits<T>;
    number_type type;
    type.name = word_of(traits::name);
    if constexpr (traits::digits > 0) {
        type.digits = traits::digits;
    }
    if constexpr (std::is_same_v<T, long double>) {
        type.name += "_" + std::to_string(type.digits);
    }
    if constexpr (limits::is_specialized && limits::radix == 2 && traits::digits > 0) {
        constexpr bool is_sum =
            traits::digits > 53 && limits::min_exponent == std::numeric_limits<double>::min_exponent;
        if constexpr (limits::min_exponent > std::numeric_limits<int>::min() / 2 && !is_sum) {
            type.lowest = static_cast<int>(limits::min_exponent) - type.digits;
        }
    }
    if constexpr (limits::is_specialized && limits::radix == 10) {
        type.decimal_digits = limits::digits10;
        type.held = [](double x) { return static_cast<void>(number_access<T>::from(x)), x; }; // it may throw
        type.rounded = [](double x) { return number_access<T>::read(number_access<T>::from(x)); };
        return type;
    }
    type.held = [](double x) {
        const T value = number_access<T>::from(x);
        if (traits::digits >= 53) {
            return x;
        }
        const reading r = number_access<T>::read(value);
        double sum = 0;
        for (const double part : r.parts) {
            sum += part;
        }
        return std::ldexp(sum, r.exponent);
    };
    return type;
}

} // namespace graze::inline v0_1::precision
