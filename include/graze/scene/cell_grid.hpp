// Who may soon meet whom: cells, so that a ball is offered to its neighbours alone.
#pragma once

#include <graze/scene/cell_level.hpp>

#include <functional>

namespace graze::inline v0_1::detail {

// A level of cells for balls of like radius. A ball owns its place on one level and is a guest on the coarser ones, so
// that a pair is offered on the level of the larger ball. Decides only what is offered: whoever touches has been, and
// who is offered too much costs time alone. Balls whose crossings doubles cannot tell in time (cell_level::resolves)
// belong to no cell and are offered to everyone.
template <int N>
class cell_grid {
  public:
    cell_grid() = default;

    // The balls as they fly at the time `now`. Without cells, everyone is offered to everyone.
    cell_grid(std::span<const flight<N, double>> balls, double now, bool with_cells) : levels_of_(balls.size()) {
        everywhere_.reserve(balls.size());
        if (balls.empty()) {
            return;
        }
        constexpr std::size_t fewest = 32; // that are worth a grid
        std::vector<int> classes(balls.size());
        std::vector<int> used;
        double largest = 0;
        for (const auto& b : balls) {
            largest = std::max(largest, b.state.radius);
        }
        for (std::size_t i = 0; i < balls.size(); ++i) { // radii of a class differ by less than a factor of 4
            classes[i] = 0;
            for (double r = largest / 4; classes[i] < deepest && balls[i].state.radius < r; r /= 4) {
                ++classes[i];
            }
            used.push_back(classes[i]);
        }
        std::sort(used.begin(), used.end(), std::greater<>());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        std::vector<flight<N, double>> present;
        for (std::size_t level = 0; level < used.size(); ++level) {
            double radius = 0;
            std::size_t count = 0;
            for (std::size_t i = 0; i < balls.size(); ++i) {
                if (classes[i] == used[level]) {
                    levels_of_[i] = static_cast<std::uint8_t>(level);
                    radius = std::max(radius, balls[i].state.radius);
                }
                count += classes[i] >= used[level] ? 1 : 0;
            }
            const double wanted = with_cells && balls.size() >= fewest ? static_cast<double>(count) : 1.0;
            levels_.emplace_back(balls, radius, wanted, level > 0);
        }
        for (body a = 0; a < balls.size(); ++a) {
            bool resolved = true;
            for (int level = first_level(a); level < levels(); ++level) {
                at(level).enter(a, balls[a], now, owns(a, level));
                resolved = resolved && at(level).resolves(balls[a], now);
            }
            if (!resolved) {
                spread(a);
            }
        }
    }

    [[nodiscard]] int levels() const noexcept { return static_cast<int>(levels_.size()); }
    [[nodiscard]] int first_level(body a) const noexcept { return levels_of_[a]; }
    [[nodiscard]] bool is_everywhere(body a) const noexcept { return levels_of_[a] == nowhere; }

    // f(b) once or more for everyone that a may meet before the next crossing of either.
    template <class F>
    void around(body a, F&& f) const {
        const auto other = [&](body b) {
            if (b != a) {
                f(b);
            }
        };
        if (is_everywhere(a)) {
            everyone(other);
            return;
        }
        for (int level = first_level(a); level < levels(); ++level) {
            at(level).around(a, owns(a, level), other);
        }
        std::for_each(everywhere_.begin(), everywhere_.end(), other);
    }
    template <class F>
    void everyone(F&& f) const {
        for (body b = 0; b < levels_of_.size(); ++b) {
            f(b);
        }
    }

    [[nodiscard]] face_crossing next_crossing(int level, body a, const flight<N, double>& f,
                                              const face_crossing& before = {}) const noexcept {
        return at(level).next_crossing(a, f, before);
    }
    [[nodiscard]] bool resolves(int level, const face_crossing& c, const flight<N, double>& f) const noexcept {
        return at(level).resolves(c, f);
    }
    template <class F>
    void ahead(int level, body a, const face_crossing& c, F&& f) const {
        at(level).ahead(a, c, owns(a, level), f);
    }
    void cross(int level, body a, const face_crossing& c) noexcept { at(level).cross(a, c, owns(a, level)); }

    // From now on a is offered to everyone.
    void spread(body a) noexcept {
        for (int level = first_level(a); level < levels(); ++level) {
            at(level).leave(a, owns(a, level));
        }
        levels_of_[a] = nowhere;
        everywhere_.push_back(a);
    }

  private:
    static constexpr int deepest = 7;
    static constexpr std::uint8_t nowhere = 0xff;

    [[nodiscard]] bool owns(body a, int level) const noexcept { return levels_of_[a] == level; }
    [[nodiscard]] cell_level<N>& at(int level) noexcept { return levels_[static_cast<std::size_t>(level)]; }
    [[nodiscard]] const cell_level<N>& at(int level) const noexcept { return levels_[static_cast<std::size_t>(level)]; }

    std::vector<cell_level<N>> levels_; // of the smallest balls first
    std::vector<std::uint8_t> levels_of_;
    std::vector<body> everywhere_;
};

} // namespace graze::inline v0_1::detail
