// Who may soon meet whom: each ball in a shell that it leaves before it can meet anyone who is not on its list.
#pragma once

#include <graze/scene/centre_cells.hpp>
#include <graze/scene/neighbour_lists.hpp>
#include <graze/scene/shell.hpp>
#include <graze/scene/standing_cells.hpp>

#include <span>

namespace graze::inline v0_1::detail {

// A ball's shell is a sphere of radius s around a point X, in which the ball's centre is until it leaves; that is an
// event, by which it gets another shell. Two balls that touch have |X_a - X_b| <= R + s_a + s_b: those are on each
// other's lists. Decides only what is offered: whoever touches has been, and who is offered too much costs time alone.
// Balls whose whereabouts doubles cannot tell in time belong to no cell and are offered to everyone.
template <int N>
class surroundings {
  public:
    surroundings() = default;

    // The balls as they fly at the time `now`. Without cells, everyone is offered to everyone.
    surroundings(std::span<const flight<N, double>> balls, double now, standing_cells<N> standing, bool with_cells)
        : standing_(std::move(standing)), lists_(static_cast<body>(balls.size()), false), shells_(balls.size()) {
        everywhere_.reserve(balls.size());
        double largest = 0;
        for (const auto& b : balls) {
            largest = std::max(largest, b.state.radius);
        }
        const double spacing = std::max({spacing_of<N>(balls), largest / 4, 0x1p-390});
        least_ = spacing / 64;
        cells_ = centre_cells<N>(balls.size(), 1.0625 * std::max(crowded * spacing, largest * 1.125), {});
        for (body a = 0; a < balls.size(); ++a) {
            const double r = balls[a].state.radius;
            shells_[a].radius = std::max(crowded * spacing - r, r / 8);
            if (with_cells && look_around(a, balls[a], now)) {
                make_room(a);
                settle(a);
            } else {
                shells_[a].everywhere = true;
                everywhere_.push_back(a);
            }
        }
    }

    [[nodiscard]] bool is_everywhere(body a) const noexcept { return shells_[a].everywhere; }
    [[nodiscard]] std::span<const body> everywhere() const noexcept { return everywhere_; }
    [[nodiscard]] std::span<const body> of(body a) const noexcept { return lists_.of(a); }
    // Until when a ball in flight is in its shell.
    [[nodiscard]] shell_end<N> end(body a, const flight<N, double>& f, double now) const noexcept {
        return shells_[a].everywhere ? shell_end<N>{shell_end<N>::never, true}
                                     : end_of_shell(f, now, cells_[a], shells_[a].radius);
    }

    // The neighbours that a has if its shell is where it flies at `now`, into fresh(). False if it can have no shell.
    // more: how much farther the shell has to reach than would do.
    // Where nothing has happened for so long that each ball has left some dozens of shells, it may be that nothing
    // will.
    [[nodiscard]] bool look_around(body a, const flight<N, double>& f, double now, double more = 0) {
        next_ = {f.state.radius, shells_[a].radius, false, true};
        if (shells_[a].is_there) {
            resize(next_, lists_.of(a).size());
        }
        next_.radius += more;
        centre_ = position_at(f.state.position, f.state.velocity, now - f.since);
        if (idle_ > 32 * shells_.size() + 256 || !end_of_shell(f, now, centre_, next_.radius).known) {
            return false;
        }
        fresh_.clear();
        const double reach = next_.ball + next_.radius;
        cells_.around(centre_, reach, [&](body b) {
            if (b != a) {
                fresh_.push_back(b);
            }
        });
        const auto add = [&](body b) { fresh_.push_back(b); };
        standing_.planes_around(centre_, reach, add);
        standing_.walls_around(centre_, reach, add);
        return true;
    }
    [[nodiscard]] std::span<const body> fresh() const noexcept { return fresh_; }
    // Until when it will be in that shell.
    [[nodiscard]] double fresh_end(const flight<N, double>& f, double now) const noexcept {
        return end_of_shell(f, now, centre_, next_.radius).when;
    }
    // After it, settle neither allocates nor throws.
    void make_room(body a) {
        cells_.make_level(next_.ball + next_.radius);
        for (const body b : fresh_) {
            if (b < shells_.size()) {
                lists_.make_room(b, 1);
            }
        }
        lists_.make_room(a, fresh_.size());
    }
    void settle(body a) noexcept {
        ++idle_;
        if (shells_[a].is_there) {
            retire(a);
        }
        shells_[a] = next_;
        cells_.enter(a, centre_, next_.ball + next_.radius);
        for (const body b : fresh_) {
            lists_.add(a, b, 0);
            if (b < shells_.size()) {
                lists_.add(b, a, 0);
            }
        }
    }
    // Something happens.
    void note_event() noexcept { idle_ = 0; }
    // From now on a is offered to everyone.
    void spread(body a) noexcept {
        retire(a);
        shells_[a].everywhere = true;
        everywhere_.push_back(a);
    }

  private:
    // A shell and its ball are to reach so many distances between balls: then a dozen are on a list in space.
    static constexpr double crowded = 0.8;
    static constexpr std::size_t fewest = 2, most = N == 2 ? 16 : 32;

    struct shell {
        double ball = 0;   // its radius
        double radius = 0; // the shell's
        bool everywhere = false;
        bool is_there = false;
    };

    // Shells grow where there are few neighbours, and shrink where there are many.
    void resize(shell& s, std::size_t neighbours) const noexcept {
        if (neighbours < fewest) {
            s.radius *= neighbours == 0 ? 2 : 1.5;
        } else if (neighbours > most && s.radius > std::max(s.ball / 16, least_)) {
            s.radius *= 0.75;
        }
    }
    void retire(body a) noexcept {
        cells_.leave(a);
        for (const body b : lists_.of(a)) {
            if (b < shells_.size()) {
                lists_.remove(b, a);
            }
        }
        lists_.clear(a);
    }

    standing_cells<N> standing_;
    centre_cells<N> cells_;
    neighbour_lists lists_;
    std::vector<shell> shells_;
    std::vector<body> everywhere_;
    double least_ = 0;     // to which a shell shrinks
    std::size_t idle_ = 0; // so many shells since something has happened
    // of the ball looked at last
    shell next_;
    vec<N, double> centre_{};
    std::vector<body> fresh_;
};

} // namespace graze::inline v0_1::detail
