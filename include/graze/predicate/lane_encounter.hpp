// What lanes of all pair kinds share: constants, ranges and answers.
#pragma once

#include <graze/filter/static_filter.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/machine/pack.hpp>

#include <limits>

namespace graze::inline v0_1::detail {

// Inputs of T in arithmetic of T: exact ones, and differences and sums that are rounded once.
template <class T>
using lane_bound = basic_error_bound<std::numeric_limits<T>::digits>;

// K as a T that is not less.
template <class T>
[[nodiscard]] consteval T rounded_up(double k) {
    return static_cast<T>(k * (1 + 2 * static_cast<double>(std::numeric_limits<T>::epsilon())));
}

// Squared scales above `smallest` whose products in pairs are below `largest`: for doubles as in started_filter. For
// floats, what underflow loses (2^-126 a time, also where an input is read as 0) is below 2^-40 of any such product,
// and the slack of a constant is more than 2^-35 of it. A square is below 2^120: nothing has overflowed.
template <class T>
struct lane_range {
    static constexpr T smallest = static_cast<T>(sizeof(T) == 4 ? 0x1p-40 : 0x1p-450);
    static constexpr T largest = static_cast<T>(sizeof(T) == 4 ? 0x1p80 : 0x1p570);
};

// The encounters as numbers, from three certain answers: whether the two come no closer, are inside each other, or
// miss.
template <class T, int Lanes>
[[nodiscard, gnu::always_inline]] inline pack<T, Lanes>
encounter_codes(pack_mask<T, Lanes> parting, pack_mask<T, Lanes> inside, pack_mask<T, Lanes> missing) noexcept {
    static_assert(static_cast<int>(encounter::overlap) == 0);
    const auto code = [](encounter e) { return pack<T, Lanes>(static_cast<T>(static_cast<int>(e))).bits(); };
    const auto apart = code(encounter::hit) ^ (missing & (code(encounter::hit) ^ code(encounter::miss)));
    return pack<T, Lanes>::of((parting & code(encounter::recede)) | (~(parting | inside) & apart));
}

// The answers of lanes, and in `open` the lanes that have none.
template <class V>
struct lane_encounters {
    V codes;
    unsigned open;

    void store(encounter* what) const noexcept { codes.store_integers(what); }
};
template <class V>
struct lane_overlaps {
    unsigned inside;
    unsigned open;

    void store(bool* what) const noexcept {
        for (int k = 0; k < V::lanes; ++k) {
            what[k] = (inside >> k & 1U) != 0;
        }
    }
};

} // namespace graze::inline v0_1::detail
