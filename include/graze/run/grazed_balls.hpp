// The balls that have grazed something at the current time, and what else they meet at exactly that time.
#pragma once

#include <graze/run/moving_scene.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <utility>

namespace graze::inline v0_1::detail {

// Whether they are certainly equal.
template <int N, class T>
[[nodiscard]] bool are_equal(const vec<N, T>& x, const vec<N, T>& y) {
    try {
        return std::equal(x.component, x.component + N, y.component,
                          [](const T& a, const T& b) { return !(a < b) && !(b < a); });
    } catch (const graze::undecided&) {
        return false;
    }
}

// A graze changes no velocity. So events predicted for the same time still happen. They are computed from the flight as
// it was before the graze, which nothing has rounded.
template <mechanics M>
class grazed_balls {
  public:
    void clear() noexcept { balls_.clear(); }

    // Whether f still happens: each ball that has had an event since f was predicted has only grazed.
    [[nodiscard]] bool leave(const moving_scene<M>& scene, const predicted& f) const noexcept {
        return is_left(scene, f.a, f.count_a) && is_left(scene, f.b, f.count_b);
    }
    // Gives ball a the flight for which it was predicted with that count.
    void take_back(moving_scene<M>& scene, body a, std::uint32_t count) {
        if (a < scene.balls() && scene.count(a) != count) {
            scene.take_back(a, find(a)->before);
        }
    }
    // Ball a has met something. before: its state before that.
    void note(const moving_scene<M>& scene, body a, const typename moving_scene<M>::memory& before) {
        const auto known = find(a);
        const bool grazed =
            !scene[a].point && are_equal(before.ball.state.state.velocity, scene[a].state.state.velocity);
        if (!grazed) {
            if (known != balls_.end()) {
                balls_.erase(known);
            }
        } else if (known != balls_.end()) {
            known->count = scene.count(a);
        } else {
            balls_.push_back({a, scene.count(a), before});
        }
    }

  private:
    // before: the first graze. count: after the last one.
    struct entry {
        body a;
        std::uint32_t count;
        typename moving_scene<M>::memory before;
    };

    [[nodiscard]] auto find(body a) noexcept {
        return std::find_if(balls_.begin(), balls_.end(), [&](const entry& e) { return e.a == a; });
    }
    [[nodiscard]] bool is_left(const moving_scene<M>& scene, body a, std::uint32_t count) const noexcept {
        return a >= scene.balls() || scene.count(a) == count ||
               std::any_of(balls_.begin(), balls_.end(), [&](const entry& e) {
                   return e.a == a && e.before.count == count && e.count == scene.count(a);
               });
    }

    records<entry> balls_;
};

} // namespace graze::inline v0_1::detail
