// How long a ball in flight is certainly within a sphere.
#pragma once

#include <graze/formula/contact.hpp>
#include <graze/shape/flight.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace graze::inline v0_1::detail {

// when: the flight is in its shell until then. known: whether doubles can tell.
template <int N>
struct shell_end {
    static constexpr double never = std::numeric_limits<double>::max();
    double when;
    bool known;
};

// For a flight whose every number, and every time of an event, is within 2^-50 of the true one, relatively: at a time t
// the true position is within 2^-46 (|x| + |u| (|t| + |since|)) of x + u (t - since) as it is computed here, with sums
// of the components' magnitudes for the norms. A 32nd of the radius is left for that at the end, where it is worst, and
// half as much for the roundings below, of numbers that are 0 or between 2^-400 and 2^400.
template <int N>
[[nodiscard]] inline shell_end<N> end_of_shell(const flight<N, double>& f, double now, const vec<N, double>& centre,
                                               double radius) noexcept {
    constexpr double never = shell_end<N>::never;
    const vec<N, double>& u = f.state.velocity;
    double far = 0, speed = 0, fastest = 0;
#pragma GCC unroll 3
    for (int i = 0; i < N; ++i) {
        far += std::fabs(f.state.position[i]);
        speed += std::fabs(u[i]);
        fastest = std::max(fastest, std::fabs(u[i]));
    }
    const double margin = radius / 32;
    if (fastest == 0) {
        return {never, far * 0x1p-46 < margin};
    }
    const vec<N, double> d = position_at(f.state.position, u, now - f.since) - centre;
    const double a = graze::squared_norm(u);
    const double b = graze::dot(d, u);
    const double inner = radius - 1.5 * margin;
    const double c = inner * inner - graze::squared_norm(d);
    const double root = std::sqrt(b * b + a * std::max(c, 0.0));
    const double left = c > 0 ? (b > 0 ? c / (b + root) : (root - b) / a) : 0;
    const double when = now + left;
    const bool in_range = radius > 0x1p-400 && radius < 0x1p400 && fastest > 0x1p-400 && fastest < 0x1p400;
    return {when,
            in_range &&
                (far + speed * (std::max(std::fabs(now), std::fabs(when)) + std::fabs(f.since))) * 0x1p-46 < margin};
}

// x, that far on along u; x itself where doubles cannot tell.
template <int N>
[[nodiscard]] inline vec<N, double> moved_along(const vec<N, double>& x, const vec<N, double>& u,
                                                double distance) noexcept {
    const double speed = std::sqrt(graze::squared_norm(u));
    return speed > 0x1p-400 && speed < 0x1p400 ? x + distance / speed * u : x;
}

// About how far balls are apart: the side of a cell, if there are as many cells as balls where these are, or in a
// period.
template <int N>
[[nodiscard]] double spacing_of(std::span<const flight<N, double>> balls, const vec<N, double>& period = {}) {
    std::array<double, N> extent{};
    for (std::size_t i = 0; i < N; ++i) {
        double low = shell_end<N>::never, high = -low;
        for (const auto& b : balls) {
            low = std::min(low, b.state.position[static_cast<int>(i)]);
            high = std::max(high, b.state.position[static_cast<int>(i)]);
        }
        const double length = period[static_cast<int>(i)];
        extent[i] = length > 0 ? length : balls.empty() ? 0 : std::min(2 * (high / 2 - low / 2), 0x1p400);
    }
    std::sort(extent.begin(), extent.end());
    double spacing = 0;
    for (std::size_t i = 0; i < N && !(extent[i] > 0 && spacing > 0 && extent[i - 1] >= spacing); ++i) {
        const double share = 1 / static_cast<double>(N - i); // an axis that is shorter than a cell has none
        spacing = std::pow(1 / static_cast<double>(balls.size() + 1), share);
        for (std::size_t k = i; k < N; ++k) {
            spacing *= std::pow(extent[k], share);
        }
    }
    return spacing;
}

} // namespace graze::inline v0_1::detail
