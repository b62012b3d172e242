// In which period of space a place is, by doubles.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/scene/body.hpp>

#include <algorithm>
#include <cmath>

namespace graze::inline v0_1::detail {

// x less so many whole periods is at `at`, within half a period of 0 but for rounding. Axes without a period (0) stay.
template <int N>
struct home_place {
    vec<N, double> at;
    whole_periods whole{};

    home_place(const vec<N, double>& x, const vec<N, double>& period) noexcept : at(x) {
        for (int i = 0; i < N; ++i) {
            if (period[i] > 0) {
                const double periods = std::nearbyint(std::clamp(x[i] / period[i], -0x1p30, 0x1p30));
                whole[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(periods);
                at.component[i] = x[i] - periods * period[i];
            }
        }
    }
};

} // namespace graze::inline v0_1::detail
