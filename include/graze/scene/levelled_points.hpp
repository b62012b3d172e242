// Points with a reach, in cells of many sizes.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/machine/fetch.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/cell_level.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace graze::inline v0_1::detail {

// Points, each with a reach. Those whose reaches differ by less than a factor of 2 are on one level, in cells twice as
// wide as the largest of these, and also in those of all levels two or more above, where a larger reach finds them: so
// a search passes few cells, whatever sizes there are. Space has no end, and an empty cell takes no memory: a hash of a
// cell's coordinates finds its points. Along an axis with period[i] > 0 space is a circle of that length, and points
// are within half of it around 0. There, cells are wider by as much as it takes to have a whole number of them.
template <int N>
class levelled_points {
  public:
    using point = vec<N, double>;

    levelled_points() = default;
    // For so many points; cells are cut so that usual_reach is the largest on its level.
    levelled_points(std::size_t points, double usual_reach, const point& period)
        : entries_(points), heads_(std::bit_ceil(2 * points + 16), no_body), base_(std::min(usual_reach, 0x1p1000)),
          period_(period) {
        for (int i = 0; i < N; ++i) {
            slack_ = std::max(slack_, 0x1p-40 * period[i]);
        }
    }

    // To be called before `enter` with this reach, and before `around`, which otherwise looks at more cells.
    void make_level(double reach) {
        const int power = power_of(reach);
        if (find(power) < levels_.size()) {
            return;
        }
        std::erase_if(levels_, [](const level& l) { return l.count == 0; });
        level made(power, 2 * std::ldexp(base_, power), period_);
        for (level& l : levels_) {
            if (is_far_below(l.power, made)) {
                made.finer.make_room(entries_.size());
            }
            if (is_far_below(power, l)) {
                l.finer.make_room(entries_.size());
            }
        }
        for (body a = 0; a < entries_.size(); ++a) {
            if (is_far_below(entries_[a].power, made)) {
                made.finer.enter(a, made.key_at(entries_[a].at));
            }
        }
        levels_.push_back(std::move(made));
    }
    void enter(body a, const point& x, double reach) noexcept {
        entry& e = entries_[a];
        e.at = x;
        e.reach = reach;
        e.power = power_of(reach);
        level& l = levels_[find(e.power)];
        l.reach = std::max(l.reach, reach);
        ++l.count;
        e.key = l.key_at(x);
        body& head = heads_[e.key & (heads_.size() - 1)];
        e.previous = no_body;
        e.next = head;
        if (head != no_body) {
            entries_[head].previous = a;
        }
        head = a;
        for (level& above : levels_) {
            if (is_far_below(e.power, above)) {
                above.finer.enter(a, above.key_at(x));
            }
        }
    }
    void leave(body a) noexcept {
        entry& e = entries_[a];
        (e.previous == no_body ? heads_[e.key & (heads_.size() - 1)] : entries_[e.previous].next) = e.next;
        if (e.next != no_body) {
            entries_[e.next].previous = e.previous;
        }
        for (level& l : levels_) {
            l.count -= l.power == e.power ? 1 : 0;
            if (is_far_below(e.power, l)) {
                l.finer.leave(a);
            }
        }
        e.power = out;
    }
    [[nodiscard]] const point& operator[](body a) const noexcept { return entries_[a].at; }
    void fetch(body a) const noexcept { detail::fetch(entries_[a]); }

  protected:
    static constexpr int out = 1 << 20;
    using level = cell_level<N>;
    using cell = typename level::cell;

    struct entry {
        point at{};
        double reach = 0;
        std::uint64_t key = 0;
        body next = no_body, previous = no_body;
        int power = out;
    };

    [[nodiscard]] static bool is_far_below(int power, const level& l) noexcept { return power <= l.power - 2; }
    // The smallest with reach <= base 2^power.
    [[nodiscard]] int power_of(double reach) const noexcept {
        int power = 0;
        double top = base_;
        for (; reach > top; top *= 2) {
            ++power;
        }
        for (; reach <= top / 2 && top / 2 < top; top /= 2) { // an infinite top stays
            --power;
        }
        return power;
    }
    [[nodiscard]] std::size_t find(int power) const noexcept {
        const auto is_it = [power](const level& l) { return l.power == power; };
        return static_cast<std::size_t>(std::find_if(levels_.begin(), levels_.end(), is_it) - levels_.begin());
    }
    records<entry> entries_;
    records<body> heads_; // of the cells' lists, some of which are of several cells; a power of two
    records<level> levels_;
    double base_ = 1;
    point period_{};
    double slack_ = 0; // more than the rounding of whole periods and of places within them
};

} // namespace graze::inline v0_1::detail
