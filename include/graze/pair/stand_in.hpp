// Two flights in place of a flight and another one's image, in a space with periods.
#pragma once

#include <graze/exact/dyadic.hpp>
#include <graze/machine/environment.hpp>
#include <graze/machine/error_free.hpp>
#include <graze/pair/image_shift.hpp>
#include <graze/shape/flight.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace graze::inline v0_1::detail {

// x - y - count length as a sum of two doubles, by error-free steps; empty where these don't suffice.
[[nodiscard]] inline std::optional<std::array<double, 2>> quick_difference(double x, double y, std::int32_t count,
                                                                           double length) noexcept {
    if constexpr (has_error_free_doubles) {
        if (count >= -2 && count <= 2 && rounds_to_nearest()) { // else the product may be rounded
            const auto apart = two_difference(x, y);
            const auto sum = two_difference(apart.value, count * length);
            const auto rest = two_sum(apart.error, sum.error);
            const auto high = two_sum(sum.value, rest.value);
            const auto low = two_sum(high.error, rest.error);
            if (low.error == 0) {
                return std::array{high.value, low.value};
            }
        }
    }
    return std::nullopt;
}

// x - y - count length as a sum of two T; empty where it takes more.
template <class T>
[[nodiscard]] std::optional<std::array<T, 2>> difference_as_two(const T& x, const T& y, std::int32_t count,
                                                                const T& length) {
    if constexpr (std::is_same_v<T, double>) {
        if (const auto quick = quick_difference(x, y, count, length)) {
            return quick;
        }
    }
    const dyadic sum = dyadic(x) - dyadic(y) - dyadic(static_cast<double>(count)) * dyadic(length);
    const T high = sum.towards_zero<T>();
    if (!is_finite_input(high)) {
        return std::nullopt;
    }
    const dyadic rest = sum - dyadic(high);
    const T low = rest.towards_zero<T>();
    return rest == dyadic(low) ? std::optional(std::array{high, low}) : std::nullopt;
}

// Two flights that are at all times exactly as far from each other as a flight and an image of another one, some
// periods away: they meet when and how those do, but elsewhere. Throws std::range_error where no two T have this
// distance, since a coordinate is tiny beside the period.
template <int N, class T>
struct stand_ins {
    flight<N, T> a, b;

    stand_ins(const flight<N, T>& x, const flight<N, T>& y, const image_shift<N, T>& image) : a(x), b(y) {
        for (int i = 0; i < N; ++i) {
            if (const std::int32_t count = image.periods[static_cast<std::size_t>(i)]; count != 0) {
                const auto distance =
                    difference_as_two(x.state.position[i], y.state.position[i], count, image.period[i]);
                if (!distance) {
                    throw std::range_error("a coordinate is too small beside the period for an exact distance");
                }
                a.state.position[i] = (*distance)[0];
                b.state.position[i] = -(*distance)[1];
            }
        }
    }
};

// A place some periods away, or a wall or triangle there. Throws std::range_error where numbers T cannot hold it.
template <int N, class T>
[[nodiscard]] vec<N, T> moved_exactly(vec<N, T> x, const image_shift<N, T>& image) {
    for (int i = 0; i < N; ++i) {
        const std::int32_t count = image.periods[static_cast<std::size_t>(i)];
        const T old = x[i];
        x.component[i] = T(old + T(T(count) * image.period[i]));
        bool held = true;
        if constexpr (std::is_floating_point_v<T>) {
            held = dyadic(x[i]) == dyadic(old) + dyadic(static_cast<T>(count)) * dyadic(image.period[i]);
        }
        if (!held) {
            throw std::range_error("the image in another period has a coordinate that is no number of this type");
        }
    }
    return x;
}
template <int N, class T, class W>
[[nodiscard]] W displaced_exactly(W w, const image_shift<N, T>& image) {
    w.corner = moved_exactly(w.corner, image);
    return w;
}

} // namespace graze::inline v0_1::detail
