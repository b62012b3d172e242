// The balls of a scene as a run starts with them.
#pragma once

#include <graze/run/mover.hpp>
#include <graze/scene/canonical_order.hpp>
#include <graze/scene/images.hpp>
#include <graze/scene/records.hpp>
#include <graze/scene/scene.hpp>

#include <algorithm>
#include <span>

namespace graze::inline v0_1::detail {

// In canonical order of their images within half a period of 0, so that nothing depends on which images were given.
// names: their indices in the scene.
template <mechanics M>
struct numbered_balls {
    records<int> names;
    records<mover<typename M::state>> movers;

    numbered_balls(std::span<const ball<M::dimension, typename M::number>> balls, const images<M>& all) {
        records<ball<M::dimension, typename M::number>> starts;
        records<typename M::state> states;
        for (const auto& b : balls) {
            states.push_back(all.rules().start(b));
            (void)all.bring_back(states.back());
            starts.push_back(states.back().state);
        }
        names = canonical_order(std::span<const ball<M::dimension, typename M::number>>(starts));
        movers.reserve(names.size());
        for (const int i : names) {
            mover<typename M::state> b{std::move(states[static_cast<std::size_t>(i)])};
            b.immovable = all.rules().immovable(b.state);
            b.point = !b.immovable && all.rules().is_point(b.state);
            movers.push_back(std::move(b));
        }
    }
    [[nodiscard]] bool has_points() const {
        return std::any_of(movers.begin(), movers.end(), [](const auto& b) { return b.point; });
    }
};

} // namespace graze::inline v0_1::detail
