// Which balls may still meet, when they have long flown apart.
#pragma once

#include <graze/filter/static_filter.hpp>
#include <graze/formula/contact.hpp>
#include <graze/scene/bodies_found.hpp>
#include <graze/scene/centre_cells.hpp>
#include <graze/shape/flight.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>

namespace graze::inline v0_1::detail {

// Of balls in free flight. Two that meet at t >= now have |Δu| (t - T) <= |Δx(T)| + R for any T < now, since Δx(T) +
// Δu (t - T) is R long then. So their velocities are near each other, the nearer the longer it is since they were all
// in one place. Cells by velocities hold the balls.
template <int N>
class remaining_pairs {
  public:
    // False, after which nothing is known, if more than `most` are left, each counted twice. is_alike(a, b): whether
    // two have the same velocity, so that they never meet; asked of those whose velocities are so in doubles. What is
    // known to shells of these flights is known here. [end_of_shell]
    template <class F>
    [[nodiscard]] bool find(std::span<const flight<N, double>> balls, double now, std::size_t most, F is_alike) {
        lay_cells(balls, now);
        if (!is_selective_) {
            is_known_ = most / balls.size() >= balls.size();
            return is_known_;
        }
        std::size_t count = 0;
        records<body> near;
        for (body a = 0; a < balls.size() && count <= most; ++a) {
            near.clear();
            list_near(a, is_alike, near);
            count += near.size();
        }
        is_known_ = count <= most;
        return is_known_;
    }
    [[nodiscard]] bool is_known() const noexcept { return is_known_; }

    // The flight of ball a is another one. After many of these it is better to begin again.
    void note_change(body a) noexcept {
        if (is_known_ && !is_outdated()) {
            changed_[changes_++] = a;
        }
    }
    [[nodiscard]] bool is_outdated() const noexcept { return changes_ == changed_.size(); }

    // Whether `list` says more than that a may meet all others.
    [[nodiscard]] bool knows(body a) const noexcept {
        return is_selective_ && std::find(changed_.begin(), end_of_changed(), a) == end_of_changed();
    }
    // Adds all balls that a may still meet, some of them twice.
    template <class Alike>
    void list(body a, Alike is_alike, records<body>& found) const {
        list_near(a, is_alike, found);
        std::copy(changed_.begin(), end_of_changed(), std::back_inserter(found));
    }

  private:
    template <class Alike>
    void list_near(body a, Alike is_alike, records<body>& found) const {
        bodies_found near{found, nullptr, a};
        const std::size_t first = found.size();
        cells_.around(cells_[a], window_, false, near);
        const auto never_meets = [&](body b) { return cells_[a] == cells_[b] && is_alike(a, b); };
        found.erase(std::remove_if(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(), never_meets),
                    found.end());
    }
    void lay_cells(std::span<const flight<N, double>> balls, double now) {
        const double window = window_of(balls, now) / 2;  // of each of two
        is_selective_ = within_powers<-400, 400>(window); // no NaN
        if (is_selective_) {
            cells_ = centre_cells<N>(balls.size(), window, {});
            window_ = window;
            cells_.make_level(window);
            for (body a = 0; a < balls.size(); ++a) {
                cells_.enter(a, balls[a].state.velocity, window);
            }
        }
    }
    // Velocities are less than this apart, with a sixteenth to spare for mechanics that round; not a number or infinite
    // where that is not known.
    [[nodiscard]] static double window_of(std::span<const flight<N, double>> balls, double now) noexcept {
        constexpr double never = std::numeric_limits<double>::max();
        double first = never, last = -never;
        for (const auto& b : balls) {
            first = std::min(first, b.since);
            last = std::max(last, b.since);
        }
        // The window is the extent of (x(now) z - u) for z = 1 / (now - T), but for 2 R z: convex in z.
        double low = 1 / (16 * (now - first)), high = 1 / (now - last);
        const auto window = [&](double z) { return window_since(balls, now - 1 / z, now); };
        for (int i = 0; i < 40 && low < high; ++i) {
            const double x = low + (high - low) * 0.45, y = low + (high - low) * 0.55;
            (window(x) < window(y) ? high : low) = window(x) < window(y) ? y : x;
        }
        return now > last ? window(low + (high - low) / 2) : 0;
    }
    [[nodiscard]] static double window_since(std::span<const flight<N, double>> balls, double then,
                                             double now) noexcept {
        double radius = 0, fastest = 0, error = 0, square = 0;
        vec<N, double> low{}, high{};
        for (std::size_t a = 0; a < balls.size(); ++a) {
            const auto& [ball, since] = balls[a];
            const vec<N, double> place = position_at(ball.position, ball.velocity, then - since);
            double far = 0, speed = 0;
            for (int i = 0; i < N; ++i) {
                far += std::fabs(ball.position[i]);
                speed += std::fabs(ball.velocity[i]);
                low.component[i] = a == 0 ? place[i] : std::min(low[i], place[i]);
                high.component[i] = a == 0 ? place[i] : std::max(high[i], place[i]);
            }
            radius = std::max(radius, ball.radius);
            error = std::max(error, 0x1p-46 * (far + speed * (std::fabs(then) + std::fabs(since))));
            fastest = std::max(fastest, speed);
        }
        for (int i = 0; i < N; ++i) {
            square += (high[i] - low[i] + 2 * error) * (high[i] - low[i] + 2 * error);
        }
        return 1.0625 * (std::sqrt(square) + 2 * radius) / (now - then) + 0x1p-48 * fastest;
    }
    [[nodiscard]] auto end_of_changed() const noexcept {
        return changed_.begin() + static_cast<std::ptrdiff_t>(changes_);
    }

    centre_cells<N> cells_;
    double window_ = 0;
    std::array<body, 64> changed_{};
    std::size_t changes_ = 0;
    bool is_known_ = false, is_selective_ = false;
};

} // namespace graze::inline v0_1::detail
