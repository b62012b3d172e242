// Which balls may soon meet: each ball is in a shell, and leaves it before it can meet a ball that is not on its list.
#pragma once

#include <graze/machine/fetch.hpp>
#include <graze/scene/bodies_found.hpp>
#include <graze/scene/centre_cells.hpp>
#include <graze/scene/home_place.hpp>
#include <graze/scene/idle_count.hpp>
#include <graze/scene/neighbour_lists.hpp>
#include <graze/scene/records.hpp>
#include <graze/scene/shell.hpp>
#include <graze/scene/standing_cells.hpp>

#include <span>

namespace graze::inline v0_1::detail {

// A ball's shell is a sphere of radius s around a point X, in which the ball's centre is until it leaves. Leaving is an
// event, which gives the ball another shell. Two balls that touch have |X_a - X_b| <= R + s_a + s_b: those are on each
// other's lists. This only selects the pairs to be examined: every pair that touches is among them, and surplus pairs
// cost only time. Balls whose position doubles cannot tell are in no cell and are examined with every other ball.
template <int N>
class surroundings {
  public:
    surroundings() = default;

    // The balls as they fly at the time `now`. Without cells, every pair is examined. period: of space, along each
    // axis; 0 where there is none. Where there is one, everyone has a shell.
    surroundings(std::span<const flight<N, double>> balls, double now, standing_cells<N> standing, bool with_cells,
                 const vec<N, double>& period = {})
        : standing_(std::move(standing)), period_(period), shortest_(shortest(period)),
          lists_(static_cast<body>(balls.size()), is_periodic()), shells_(balls.size()),
          balls_(static_cast<body>(balls.size())), idle_(balls.size()), with_cells_(with_cells) {
        everywhere_.reserve(balls.size());
        double largest = 0;
        for (const auto& b : balls) {
            largest = std::max(largest, b.state.radius);
        }
        const double spacing = std::max({spacing_of<N>(balls, period), largest / 4, 0x1p-390});
        spacing_ = spacing;
        const auto shell_around = [&](double r) {
            return std::max({crowded * spacing - r, narrowest * spacing, r / 8});
        };
        cells_ = centre_cells<N>(balls.size(), 1.0625 * std::max(crowded * spacing, largest + shell_around(largest)),
                                 period);
        for (body a = 0; a < balls_; ++a) {
            shells_[a].radius = shell_around(balls[a].state.radius);
            if ((with_cells || is_periodic()) && look_around(a, balls[a], now)) {
                make_room(a);
                settle(a);
            } else {
                shells_[a].everywhere = true;
                everywhere_.push_back(a);
            }
        }
    }

    [[nodiscard]] bool is_periodic() const noexcept { return shortest_ < shell_end<N>::never; }
    [[nodiscard]] bool is_everywhere(body a) const noexcept { return shells_[a].everywhere; }
    [[nodiscard]] std::span<const body> everywhere() const noexcept { return everywhere_; }
    [[nodiscard]] std::span<const body> of(body a) const noexcept { return lists_.of(a); }
    // Fetches a ball's shell from memory, and where its list is; then the list.
    void fetch(body a) const noexcept {
        detail::fetch(shells_[a]);
        lists_.fetch_place(a);
        cells_.fetch(a);
    }
    void fetch_list(body a) const noexcept { lists_.fetch(a); }
    void fetch_lists_around(body a) const noexcept {
        for (const body b : lists_.of(a)) {
            if (b < balls_) {
                lists_.fetch(b);
            }
        }
    }
    // In a periodic space: the image that may be near of b, the i-th on a's list, counted as in `predicted`.
    [[nodiscard]] image_index image(body a, std::size_t i, body b) const noexcept {
        return decoded(lists_.images_of(a)[i]) + shells_[a].place - (b < balls_ ? shells_[b].place : image_index{});
    }
    // In a periodic space: which images of these may be near, as seen from the shell. [place]
    [[nodiscard]] std::span<const image_code> images_of(body a) const noexcept { return lists_.images_of(a); }
    [[nodiscard]] std::span<const image_code> fresh_images() const noexcept { return fresh_images_; }
    // In which period the centre of a's shell is, or that of its next one.
    [[nodiscard]] image_index place(body a) const noexcept { return shells_[a].place; }
    [[nodiscard]] image_index fresh_place() const noexcept { return next_.place; }
    // Until when a ball in flight is in its shell. gone: how many periods it has gone back.
    [[nodiscard]] shell_end<N> end(body a, const flight<N, double>& f, double now,
                                   image_index gone = {}) const noexcept {
        return shells_[a].everywhere
                   ? shell_end<N>{shell_end<N>::never, true}
                   : end_of_shell(f, now, from_flight(cells_[a], shells_[a].place - gone), shells_[a].radius);
    }

    // Writes the neighbours of a, if its shell is where it flies at `now`, to fresh(). False if it can have no shell.
    // more: how much farther the shell has to reach than usual.
    [[nodiscard]] bool look_around(body a, const flight<N, double>& f, double now, image_index gone = {},
                                   double more = 0) {
        next_ = {f.state.radius, shells_[a].radius, false, true, {}};
        if (shells_[a].is_there) {
            resize(next_, lists_.of(a).size());
        }
        next_.radius = std::min(next_.radius, shortest_) + more;
        const vec<N, double> place = moved_along(position_at(f.state.position, f.state.velocity, now - f.since),
                                                 f.state.velocity, way_ahead(next_));
        const auto [at, whole] = home_place<N>(place, period_);
        centre_ = at;
        next_.place = whole + gone;
        const shell_end<N> end = end_of_shell(f, now, from_flight(centre_, whole), next_.radius);
        next_end_ = end.when;
        if (!end.known || next_.radius > 0.25 * most_periods * shortest_) {
            return false;
        }
        fresh_.clear();
        fresh_images_.clear();
        const double reach = next_.ball + next_.radius;
        cells_.make_level(reach);
        bodies_found found{fresh_, is_periodic() ? &fresh_images_ : nullptr, a};
        cells_.around(centre_, reach, !with_cells_, found);
        const auto add = [&](image_code image) { return [&found, image](body b) { found(b, image); }; };
        standing_.planes_around(centre_, reach, add(0)); // their normals have no component along a period
        standing_.for_each_image(centre_, reach, period_, [&](const vec<N, double>& from, const whole_periods& image) {
            standing_.walls_around(from, reach, add(coded(image)));
        });
        return true;
    }
    [[nodiscard]] std::span<const body> fresh() const noexcept { return fresh_; }
    // Until when a will be in that shell.
    [[nodiscard]] double fresh_end() const noexcept { return next_end_; }
    // After this, settle neither allocates nor throws.
    void make_room(body a) {
        for (const body b : fresh_) {
            if (b < balls_) {
                lists_.make_room(b, is_periodic() ? fresh_.size() : 1); // several images of one
            }
        }
        lists_.make_room(a, fresh_.size());
    }
    void settle(body a) noexcept {
        idle_.note_shell();
        if (shells_[a].is_there) {
            retire(a);
        }
        shells_[a] = next_;
        cells_.enter(a, centre_, next_.ball + next_.radius);
        for (std::size_t i = 0; i < fresh_.size(); ++i) {
            const body b = fresh_[i];
            const image_code image = is_periodic() ? fresh_images_[i] : 0;
            lists_.add(a, b, image);
            if (b < balls_) {
                lists_.add(b, a, 0 - image);
            }
        }
    }
    // Since the last event, which is to be noted here.
    [[nodiscard]] idle_count& idle() noexcept { return idle_; }
    // From now on ball a is examined with every other ball.
    void spread(body a) noexcept {
        retire(a);
        shells_[a].everywhere = true;
        everywhere_.push_back(a);
    }

  private:
    // How many distances between balls a shell and its ball are to reach: a dozen balls are then on a list in space. A
    // shell is not less than `narrowest` of them, or the ball would leave it too often.
    static constexpr double crowded = 0.7, narrowest = 0.3;
    static constexpr std::size_t fewest = 3, most = N == 2 ? 16 : 32;

    struct shell {
        double ball = 0;   // its radius
        double radius = 0; // the shell's
        bool everywhere = false;
        bool is_there = false;
        image_index place{}; // of its centre in a path that is never brought back
    };

    [[nodiscard]] static double shortest(const vec<N, double>& period) noexcept {
        double least = shell_end<N>::never;
        for (int i = 0; i < N; ++i) {
            least = period[i] > 0 ? std::min(least, period[i]) : least;
        }
        return least;
    }
    [[nodiscard]] vec<N, double> from_flight(vec<N, double> centre, image_index periods) const noexcept {
        for (int i = 0; i < N && periods != image_index{}; ++i) {
            centre.component[i] += periods[static_cast<std::size_t>(i)] * period_[i];
        }
        return centre;
    }
    // How far a shell's centre is ahead of its ball, which flies on about as far as there is room between balls.
    [[nodiscard]] double way_ahead(const shell& s) const noexcept {
        return std::clamp(spacing_ - 2 * s.ball, 0.0, 0.45 * s.radius);
    }
    // Shells grow where there are few neighbours, and shrink where there are many.
    void resize(shell& s, std::size_t neighbours) const noexcept {
        if (neighbours < fewest) {
            s.radius *= neighbours == 0 ? 2 : 1.5;
        } else if (neighbours > most && s.radius > std::max(s.ball / 16, spacing_ / 64)) {
            s.radius *= 0.75;
        }
    }
    void retire(body a) noexcept {
        cells_.leave(a);
        for (const body b : lists_.of(a)) {
            if (b < balls_) {
                lists_.remove(b, a);
            }
        }
        lists_.clear(a);
    }

    standing_cells<N> standing_;
    vec<N, double> period_{};
    double shortest_ = shell_end<N>::never;
    centre_cells<N> cells_;
    neighbour_lists lists_;
    records<shell> shells_;
    body balls_ = 0; // how many
    records<body> everywhere_;
    double spacing_ = 0; // of balls, about
    idle_count idle_;
    bool with_cells_ = false;
    // of the ball looked at last
    shell next_;
    vec<N, double> centre_{};
    double next_end_ = 0;
    records<body> fresh_;
    records<image_code> fresh_images_;
};

} // namespace graze::inline v0_1::detail
