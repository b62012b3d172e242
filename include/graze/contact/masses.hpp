// The masses of two balls that meet: which are allowed, and how the formulas take them.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/pair/input_check.hpp>
#include <graze/pair/moving.hpp>

namespace graze::inline v0_1::detail {

// By the bits: whether x is positive and finite.
[[nodiscard]] constexpr bool is_plain_mass(const double& x) noexcept {
    return bits_of(x) - 1 < 0x7ff0000000000000U - 1;
}
[[nodiscard]] constexpr bool is_plain_mass(const float& x) noexcept { return bits_of(x) - 1 < 0x7f800000U - 1; }

// Whether x is +∞, by its bits.
[[nodiscard]] constexpr bool is_infinite_mass(const double& x) noexcept { return bits_of(x) == 0x7ff0000000000000U; }
[[nodiscard]] constexpr bool is_infinite_mass(const float& x) noexcept { return bits_of(x) == 0x7f800000U; }

// Names what is wrong with the masses of two balls that meet.
template <moving B, class Tell>
constexpr void inspect_masses(const B& a, const B& b, Tell tell_of_a, Tell tell_of_b) {
    const auto& mass_a = state_of(a).mass;
    const auto& mass_b = state_of(b).mass;
    if (!is_plain_mass(mass_a) && !is_infinite_mass(mass_a)) {
        tell_of_a("mass", "mass is not positive");
    }
    if (!is_plain_mass(mass_b) && !is_infinite_mass(mass_b)) {
        tell_of_b("mass", "mass is not positive");
    }
    if (is_infinite_mass(mass_a) && is_infinite_mass(mass_b)) {
        tell_of_b("mass",
                  is_flight<B> ? "mass is infinite, as that of flight a is" : "mass is infinite, as that of ball a is");
    }
}

// The mass as the formulas take it: 1 for an infinite one, and 0 beside it.
template <class U, class T>
[[nodiscard]] constexpr U effective_mass(const T& mass, const T& other) noexcept {
    return is_infinite_mass(mass) ? U(1) : is_infinite_mass(other) ? U(0) : static_cast<U>(mass);
}

} // namespace graze::inline v0_1::detail
