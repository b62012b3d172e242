// Bounds on when a flight meets an image of another one, in a space with periods.
#pragma once

#include <graze/pair/stand_in.hpp>
#include <graze/time/bounds_until.hpp>

#include <concepts>

namespace graze::inline v0_1::detail {

// Whether a and the image of b certainly don't meet until `latest`, by doubles alone.
//
// The image is at b's position plus the periods, but for the roundings of product and sum: less than 2^-51 of their
// magnitudes along each axis. So it is inside a ball at the computed place that is wider by as much. If that ball,
// which is outside at first, parts or is not reached by then, nothing is met.
template <int N>
[[nodiscard, gnu::flatten]] bool is_image_missed(const flight<N, double>& a, const flight<N, double>& b,
                                                 const image_shift<N, double>& image, double latest) {
    using constant = filter_of<flight<N, double>>;
    flight<N, double> wider = b;
    double magnitudes = b.state.radius;
    for (int i = 0; i < N; ++i) {
        if (const std::int32_t count = image.periods[static_cast<std::size_t>(i)]; count != 0) {
            const double by = count * image.period[i];
            magnitudes += std::fabs(b.state.position[i]) + std::fabs(by);
            wider.state.position.component[i] = b.state.position[i] + by;
        }
    }
    wider.state.radius = b.state.radius + 0x1p-49 * magnitudes;
    const auto f = start_filter(a, wider);
    if (!f.in_range) {
        return false;
    }
    if (f.is_parting()) {
        return f.q.c > (constant::c + 0x1p-48) * f.length2;
    }
    return is_beyond(f, a, b, latest);
}

// As bounds_until returns them. Throws std::range_error if the distance is no difference of two T. [stand_ins]
template <int N, class T>
[[nodiscard]] enclosure bounds_of_image(const flight<N, T>& a, const flight<N, T>& b, const image_shift<N, T>& image,
                                        double latest) {
    if constexpr (std::same_as<T, double>) {
        if (is_image_missed(a, b, image, latest)) {
            return {enclosure::unknown, 0};
        }
    }
    const stand_ins<N, T> pair(a, b, image);
    return bounds_until(pair.a, pair.b, latest);
}

} // namespace graze::inline v0_1::detail
