// Masses of two that meet: what is allowed, and as the formulas take them.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/machine/failure.hpp>
#include <graze/pair/input_check.hpp>

namespace graze::inline v0_1::detail {

// By the bits: whether x is positive and finite.
[[nodiscard]] constexpr bool is_plain_mass(const double& x) noexcept {
    return bits_of(x) - 1 < 0x7ff0000000000000U - 1;
}
[[nodiscard]] constexpr bool is_plain_mass(const float& x) noexcept { return bits_of(x) - 1 < 0x7f800000U - 1; }

// Whether x is +∞, by its bits.
[[nodiscard]] constexpr bool is_infinite_mass(const double& x) noexcept { return bits_of(x) == 0x7ff0000000000000U; }
[[nodiscard]] constexpr bool is_infinite_mass(const float& x) noexcept { return bits_of(x) == 0x7f800000U; }

// Never constexpr, as reject.
[[noreturn]] inline void reject_infinite_masses(const char* a, const char* b) {
    fail<std::domain_error>(std::string(b) + ": mass is infinite, as that of " + a + " is");
}

template <class T>
constexpr void check_masses(const T& a, const T& b, const char* name_a = "ball a", const char* name_b = "ball b") {
    if (is_plain_mass(a) && is_plain_mass(b)) [[likely]] {
        return;
    }
    if (!is_plain_mass(a) && !is_infinite_mass(a)) {
        reject(name_a, "mass is not positive");
    }
    if (!is_plain_mass(b) && !is_infinite_mass(b)) {
        reject(name_b, "mass is not positive");
    }
    if (is_infinite_mass(a) && is_infinite_mass(b)) {
        reject_infinite_masses(name_a, name_b);
    }
}

// The mass as the formulas take it: 1 for an infinite one, and 0 beside it.
template <class U, class T>
[[nodiscard]] constexpr U effective_mass(const T& mass, const T& other) noexcept {
    return is_infinite_mass(mass) ? U(1) : is_infinite_mass(other) ? U(0) : static_cast<U>(mass);
}

} // namespace graze::inline v0_1::detail
