// The five encounters of a pair, and the rule that derives them from three signs.
#pragma once

#include <graze/number/traits.hpp>

namespace graze::inline v0_1 {

// recede: they come no closer (at relative rest, parting, sliding along). overlap: inside each other and getting
// deeper. miss, graze, hit: apart and approaching, with a least distance that is more than, equal to, or less than that
// of contact.
enum class encounter { overlap, recede, miss, graze, hit };

[[nodiscard]] constexpr const char* to_string(encounter e) noexcept {
    switch (e) {
    case encounter::overlap:
        return "overlap";
    case encounter::recede:
        return "recede";
    case encounter::miss:
        return "miss";
    case encounter::graze:
        return "graze";
    case encounter::hit:
        return "hit";
    }
    return "unknown";
}

// Whether an encounter has a time and a contact.
[[nodiscard]] constexpr bool is_collision(encounter e) noexcept {
    return e == encounter::overlap || e == encounter::graze || e == encounter::hit;
}

// From h = ⟨Δx,Δu⟩, c = |Δx|² - R² and D = h² - ac: each argument is a function that returns its sign, called only when
// the ones before it leave the answer open.
template <class H, class C, class D>
[[nodiscard]] constexpr encounter encounter_of(H sign_h, C sign_c, D sign_discriminant) {
    if (sign_h() >= 0) {
        return encounter::recede;
    }
    if (sign_c() < 0) {
        return encounter::overlap;
    }
    const int d = sign_discriminant();
    return d < 0 ? encounter::miss : d == 0 ? encounter::graze : encounter::hit;
}

} // namespace graze::inline v0_1
