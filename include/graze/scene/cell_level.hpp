// One grid of cells with the balls that are in them.
#pragma once

#include <graze/scene/cell_faces.hpp>
#include <graze/scene/event_heap.hpp>
#include <graze/shape/flight.hpp>

#include <cstdint>

namespace graze::inline v0_1::detail {

// A face of a ball's cell that it reaches: when, and the axis and sense in which it then moves on.
struct face_crossing {
    double when = std::numeric_limits<double>::max();
    int axis = 0;
    int step = 0;
};

// Balls in cells. Owners are offered to everyone in the cells around them, guests to owners alone.
//
// What it guarantees, for the true flights of which these here are roundings: until its next crossing a ball's centre
// is in its cell or less than `slack` outside of it. Cells are at least 2r + 2 slack wide for the largest radius r of
// an owner, so that two balls that touch, one of them an owner, are in the same cell or in neighbouring ones.
template <int N>
class cell_level {
  public:
    using place = std::array<std::int32_t, N>;

    // Cells for balls of which the largest owner has this radius; at most `wanted` of them, with or without guests.
    cell_level(std::span<const flight<N, double>> balls, double largest, double wanted, bool with_guests) {
        std::array<std::vector<double>, N> coordinates;
        std::array<double, N> extent{};
        double widest = 0;
        double farthest = 0;
        for (std::size_t i = 0; i < N; ++i) {
            for (const auto& b : balls) {
                coordinates[i].push_back(b.state.position[static_cast<int>(i)]);
            }
            const auto [low, high] = std::minmax_element(coordinates[i].begin(), coordinates[i].end());
            extent[i] = *high - *low;
            widest = std::max(widest, extent[i]);
            farthest = std::max({farthest, std::fabs(*low), std::fabs(*high)});
        }
        const double spacing = std::max(2.25 * largest, widest * 0x1p-16); // 2r + 2 slack
        slack_ = spacing / 18;
        next_.resize(balls.size(), no_body);
        previous_.resize(balls.size(), no_body);
        places_.resize(balls.size());
        std::array<std::size_t, N> along;
        along.fill(1);
        // Beyond this a face would not be known to within the slack: one cell then holds all.
        if (farthest * 0x1p-46 < slack_ && widest < std::numeric_limits<double>::max()) {
            std::array<double, N> most{};
            for (std::size_t i = 0; i < N; ++i) {
                most[i] = extent[i] / spacing;
            }
            along = cells_along(most, wanted);
        }
        std::size_t cells = 1;
        for (std::size_t i = 0; i < N; ++i) {
            if (along[i] > 1) {
                faces_[i] = faces_among(coordinates[i], along[i], spacing);
            }
            stride_[i] = cells;
            cells *= faces_[i].size() + 1;
        }
        owners_.assign(cells, no_body);
        guests_.assign(with_guests ? cells : 0, no_body);
    }

    // Puts a ball that is nowhere where it is at a time.
    void enter(body a, const flight<N, double>& f, double now, bool owner) noexcept {
        for (std::size_t i = 0; i < N; ++i) {
            const int axis = static_cast<int>(i);
            const double x = f.state.position[axis] + f.state.velocity[axis] * (now - f.since);
            const auto face = std::upper_bound(faces_[i].begin(), faces_[i].end(), x);
            places_[a][i] = static_cast<std::int32_t>(face - faces_[i].begin());
        }
        link(a, owner);
    }
    void leave(body a, bool owner) noexcept {
        body& head = (owner ? owners_ : guests_)[cell_of(places_[a])];
        (previous_[a] == no_body ? head : next_[previous_[a]]) = next_[a];
        if (next_[a] != no_body) {
            previous_[next_[a]] = previous_[a];
        }
    }
    void cross(body a, const face_crossing& c, bool owner) noexcept {
        leave(a, owner);
        places_[a][static_cast<std::size_t>(c.axis)] += c.step;
        link(a, owner);
    }

    // The next face that a ball in flight reaches, if it first crosses the one of `before`.
    [[nodiscard]] face_crossing next_crossing(body a, const flight<N, double>& f,
                                              const face_crossing& before = {}) const noexcept {
        face_crossing first;
        for (std::size_t i = 0; i < N; ++i) {
            const int axis = static_cast<int>(i);
            const double u = f.state.velocity[axis];
            const auto cell = static_cast<std::size_t>(places_[a][i] + (axis == before.axis ? before.step : 0));
            if (u > 0 ? cell < faces_[i].size() : u < 0 && cell > 0) {
                const double face = faces_[i][u > 0 ? cell : cell - 1];
                const double when = f.since + (face - f.state.position[axis]) / u;
                if (!(when >= first.when)) {
                    first = {when, axis, u > 0 ? 1 : -1};
                }
            }
        }
        return first;
    }
    // Whether the slack covers the errors of that time: of its computation, of the roundings in f (2^-50, relatively),
    // and of the times of events with which it is compared (2^-40): along the axis they move the ball by no more than
    // 2^-48 |x| + 2^-38 |u| |when|, of which half the slack is left to positions that are rounded when a ball bounces.
    [[nodiscard]] bool resolves(const face_crossing& c, const flight<N, double>& f) const noexcept {
        return c.step == 0 || std::fabs(f.state.position[c.axis]) * 0x1p-48 +
                                      std::fabs(f.state.velocity[c.axis]) * std::fabs(c.when) * 0x1p-38 <
                                  slack_ / 2;
    }
    // Whether it covers, likewise, where a ball is put at a time.
    [[nodiscard]] bool resolves(const flight<N, double>& f, double now) const noexcept {
        for (std::size_t i = 0; i < N; ++i) {
            if (!faces_[i].empty() && !resolves(face_crossing{now, static_cast<int>(i), 1}, f)) {
                return false;
            }
        }
        return true;
    }

    // f(b) for all in the cells around a ball; the guests only for an owner.
    template <class F>
    void around(body a, bool owner, F&& f) const {
        place low = places_[a];
        place high = places_[a];
        for (std::size_t i = 0; i < N; ++i) {
            low[i] = std::max(low[i] - 1, 0);
            high[i] = std::min(high[i] + 1, static_cast<std::int32_t>(faces_[i].size()));
        }
        within(low, high, owner, f);
    }
    // f(b) for all that come to be around a ball by a crossing.
    template <class F>
    void ahead(body a, const face_crossing& c, bool owner, F&& f) const {
        const auto along = static_cast<std::size_t>(c.axis);
        const std::int32_t layer = places_[a][along] + 2 * c.step;
        if (layer < 0 || layer > static_cast<std::int32_t>(faces_[along].size())) {
            return;
        }
        place low = places_[a];
        place high = places_[a];
        for (std::size_t i = 0; i < N; ++i) {
            low[i] = i == along ? layer : std::max(low[i] - 1, 0);
            high[i] = i == along ? layer : std::min(high[i] + 1, static_cast<std::int32_t>(faces_[i].size()));
        }
        within(low, high, owner, f);
    }

  private:
    [[nodiscard]] std::size_t cell_of(const place& p) const noexcept {
        std::size_t cell = 0;
        for (std::size_t i = 0; i < N; ++i) {
            cell += static_cast<std::size_t>(p[i]) * stride_[i];
        }
        return cell;
    }
    void link(body a, bool owner) noexcept {
        body& head = (owner ? owners_ : guests_)[cell_of(places_[a])];
        previous_[a] = no_body;
        next_[a] = head;
        if (head != no_body) {
            previous_[head] = a;
        }
        head = a;
    }
    template <class F>
    void within(const place& low, const place& high, bool owner, F&& f) const {
        const bool guests_too = owner && !guests_.empty();
        place p = low;
        while (true) {
            for (std::size_t row = cell_of(p), x = row; x <= row + static_cast<std::size_t>(high[0] - low[0]); ++x) {
                each(owners_[x], f);
                if (guests_too) {
                    each(guests_[x], f);
                }
            }
            std::size_t axis = 1;
            while (axis < N && p[axis] == high[axis]) {
                p[axis] = low[axis];
                ++axis;
            }
            if (axis == N) {
                return;
            }
            ++p[axis];
        }
    }
    template <class F>
    void each(body head, F&& f) const {
        for (body b = head; b != no_body; b = next_[b]) {
            f(b);
        }
    }

    std::array<cell_faces, N> faces_;
    std::array<std::size_t, N> stride_{}; // 1 along the first axis
    double slack_ = 0;
    std::vector<body> owners_, guests_; // the first in each cell
    std::vector<body> next_, previous_;
    std::vector<place> places_;
};

} // namespace graze::inline v0_1::detail
