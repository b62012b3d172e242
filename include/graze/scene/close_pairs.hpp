// Which balls of a scene are near each other.
#pragma once

#include <graze/scene/centre_cells.hpp>
#include <graze/scene/home_place.hpp>
#include <graze/scene/records.hpp>
#include <graze/scene/shell.hpp>

#include <utility>

namespace graze::inline v0_1::detail {

// How far from its centre a ball may reach if its numbers were rounded by no more than 2^-50 of them.
template <int N>
[[nodiscard]] double reach_of(const ball<N, double>& b) noexcept {
    double far = 0;
    for (int i = 0; i < N; ++i) {
        far += std::fabs(b.position[i]);
    }
    return b.radius * (1 + 0x1p-40) + far * 0x1p-44;
}

// f(a, b, image), a < b, for balls that may overlap and images of the second ones, among them all that do. Finds them
// through cells; balls with numbers beyond 2^356 are compared with all others, without images.
template <int N, class F>
void for_each_close_pair(const records<flight<N, double>>& balls, const vec<N, double>& period, F f) {
    double largest = 0;
    records<body> far;
    for (body a = 0; a < balls.size(); ++a) {
        const double reach = reach_of(balls[a].state);
        if (reach < 0x1p356) {
            largest = std::max(largest, reach);
        } else {
            far.push_back(a);
        }
    }
    const double spacing = std::max({spacing_of<N>(balls, period), largest / 0x1p20, 0x1p-390});
    centre_cells<N> cells(balls.size(), 1.0625 * std::max(spacing / 2, largest), period);
    records<image_index> whole(balls.size());
    auto next_far = far.begin();
    for (body a = 0; a < balls.size(); ++a) {
        if (next_far != far.end() && *next_far == a) {
            ++next_far;
            for (body b = 0; b < balls.size(); ++b) {
                if (b < a || (b > a && !std::binary_search(far.begin(), far.end(), b))) {
                    f(std::min(a, b), std::max(a, b), image_index{});
                }
            }
            continue;
        }
        const double reach = std::max(reach_of(balls[a].state), spacing / 64);
        const home_place<N> home(balls[a].state.position, period);
        whole[a] = home.whole;
        cells.make_level(reach);
        cells.around(home.at, reach, false,
                     [&](body b, image_code image) { f(b, a, whole[b] - decoded(image) - whole[a]); });
        cells.enter(a, home.at, reach);
    }
}

} // namespace graze::inline v0_1::detail
