// The components of a contact by number, so that each stage can round those that the stage before left open.
#pragma once

#include <graze/exact/workspace.hpp>
#include <graze/linear/vec.hpp>

namespace graze::inline v0_1::detail {

// A set of components: bit 0 is the time, then come the vectors of a contact in their order, three bits each.
using component_set = unsigned;
inline constexpr component_set all_components = ~0U;

enum class contact_component { position_a = 1, position_b = 4, normal = 7, velocity_a = 10, velocity_b = 13 };
enum class wall_component { position = 1, point = 4, normal = 7, velocity = 10 };

[[nodiscard]] constexpr bool has_time(component_set wanted) noexcept { return (wanted & 1U) != 0; }

// x[i] = f(i) for the wanted components of x, the first of which has the number `first`. Gives back what f takes from
// the workspace.
template <int N, class T, class Part, class F>
constexpr void fill(vec<N, T>& x, component_set wanted, Part first, workspace* room, F f) {
    const component_set mine = wanted >> static_cast<unsigned>(first);
    for (int i = 0; i < N; ++i) {
        if ((mine >> i & 1U) != 0) {
            const workspace::scope scope(room);
            x[i] = f(i);
        }
    }
}

} // namespace graze::inline v0_1::detail
