// The balls that have grazed something at the current time, and what else they meet at exactly that time.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/run/image_ledger.hpp>
#include <graze/run/mover.hpp>
#include <graze/scene/mechanics.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

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

// What an event changes of a ball, to put it back. Point: what is known of one beside its state.
template <class State, class Point>
struct ball_memory {
    mover<State> ball;
    std::uint32_t count;
    std::optional<Point> among;
    std::size_t passed;
    image_ledger::entry image;
};

// A graze changes no velocity. So events predicted for the same time still happen. They are computed from the flight as
// it was before the graze, which nothing has rounded.
template <class Memory>
class grazed_balls {
  public:
    void clear() noexcept { balls_.clear(); }

    // Whether f still happens: each ball that has had an event since f was predicted has only grazed.
    template <class Scene>
    [[nodiscard]] bool leave(const Scene& scene, const predicted& f) const noexcept {
        const auto is_left = [&](body a, std::uint32_t count) {
            return a >= scene.balls() || scene.count(a) == count || has_grazed(a, count, scene.count(a));
        };
        return is_left(f.a, f.count_a) && is_left(f.b, f.count_b);
    }
    // Gives ball a the flight for which it was predicted with that count.
    template <class Scene>
    void take_back(Scene& scene, body a, std::uint32_t count) {
        if (a < scene.balls() && scene.count(a) != count) {
            scene.take_back(a, find(a)->before);
        }
    }
    // Ball a has met something. before: its state before that.
    template <class Scene>
    void note(const Scene& scene, body a, const Memory& before) {
        const bool grazed =
            !scene[a].point && are_equal(before.ball.state.state.velocity, scene[a].state.state.velocity);
        if (grazed || !balls_.empty()) {
            note(a, before, scene.count(a), grazed);
        }
    }

  private:
    // before: the first graze. count: after the last one.
    struct entry {
        body a;
        std::uint32_t count;
        Memory before;
    };

    [[gnu::noinline]] void note(body a, const Memory& before, std::uint32_t count, bool grazed) {
        const auto known = find(a);
        if (!grazed) {
            if (known != balls_.end()) {
                balls_.erase(known);
            }
        } else if (known != balls_.end()) {
            known->count = count;
        } else {
            balls_.push_back({a, count, before});
        }
    }
    [[nodiscard]] auto find(body a) noexcept {
        return std::find_if(balls_.begin(), balls_.end(), [&](const entry& e) { return e.a == a; });
    }
    [[nodiscard, gnu::noinline]] bool has_grazed(body a, std::uint32_t before, std::uint32_t now) const noexcept {
        return std::any_of(balls_.begin(), balls_.end(),
                           [&](const entry& e) { return e.a == a && e.before.count == before && e.count == now; });
    }

    records<entry> balls_;
};

} // namespace graze::inline v0_1::detail
