// The points near another one, by cells of many sizes.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/box_walk.hpp>
#include <graze/scene/cell_level.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace graze::inline v0_1::detail {

// Points, each with a reach. Those whose reaches differ by less than a factor of 2 are on one level, in cells twice as
// wide as the largest of these. Space has no end, and an empty cell takes no memory: a hash of a cell's coordinates
// finds its points. Along an axis with period[i] > 0 space is a circle of that length, and points are within half of it
// around 0. There, cells are wider by as much as it takes to have a whole number of them.
template <int N>
class centre_cells {
  public:
    using point = vec<N, double>;

    centre_cells() = default;
    // For so many points; cells are cut so that usual_reach is the largest on its level.
    centre_cells(std::size_t points, double usual_reach, const point& period)
        : entries_(points), heads_(std::bit_ceil(2 * points + 16), no_body), base_(usual_reach), period_(period) {
        for (int i = 0; i < N; ++i) {
            slack_ = std::max(slack_, 0x1p-40 * period[i]);
        }
    }

    // To be called before `enter` with this reach.
    void make_level(double reach) {
        const int power = power_of(reach);
        if (find(power) == levels_.size()) {
            std::erase_if(levels_, [](const level& l) { return l.count == 0; });
            levels_.emplace_back(power, 2 * std::ldexp(base_, power), period_);
        }
    }
    void enter(body a, const point& x, double reach) noexcept {
        entry& e = entries_[a];
        e.at = x;
        e.reach = reach;
        e.power = power_of(reach);
        level& l = levels_[find(e.power)];
        l.reach = std::max(l.reach, reach);
        ++l.count;
        cell c;
        for (int i = 0; i < N; ++i) {
            c[static_cast<std::size_t>(i)] = l.along_inside(x[i], i);
        }
        e.key = l.key_of(c);
        body& head = heads_[e.key & (heads_.size() - 1)];
        e.previous = no_body;
        e.next = head;
        if (head != no_body) {
            entries_[head].previous = a;
        }
        head = a;
    }
    void leave(body a) noexcept {
        entry& e = entries_[a];
        (e.previous == no_body ? heads_[e.key & (heads_.size() - 1)] : entries_[e.previous].next) = e.next;
        if (e.next != no_body) {
            entries_[e.next].previous = e.previous;
        }
        --levels_[find(e.power)].count;
        e.power = out;
    }
    [[nodiscard]] const point& operator[](body a) const noexcept { return entries_[a].at; }

    // f(b, image) for all points' images that may be within `reach` plus their own reach of x; seldom more than once.
    // everyone: without cells.
    template <class F>
    void around(const point& x, double reach, bool everyone, F f) const {
        for (const level& l : levels_) {
            if (l.count > 0) {
                look(l, x, reach, everyone, f);
            }
        }
    }

  private:
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

    // A place in a cell's list: x as seen from there is at `from`.
    struct cursor {
        point from;
        image_index image;
        std::uint64_t key;
        body next;
    };

    // The smallest with reach <= base 2^power.
    [[nodiscard]] int power_of(double reach) const noexcept {
        int power = 0;
        double top = base_;
        for (; reach > top; top *= 2) {
            ++power;
        }
        for (; reach <= top / 2; top /= 2) {
            --power;
        }
        return power;
    }
    [[nodiscard]] std::size_t find(int power) const noexcept {
        const auto is_it = [power](const level& l) { return l.power == power; };
        return static_cast<std::size_t>(std::find_if(levels_.begin(), levels_.end(), is_it) - levels_.begin());
    }
    // f(b, image) for those of its images that may be near.
    template <class F>
    void offer_all(body b, const point& x, double far, F& f) const {
        const entry& e = entries_[b];
        whole_periods low{}, high{};
        for (int i = 0; i < N; ++i) {
            if (period_[i] > 0) {
                const auto k = static_cast<std::size_t>(i);
                low[k] = -static_cast<std::int32_t>(whole_below((e.at[i] - x[i] + far) / period_[i]));
                high[k] = static_cast<std::int32_t>(whole_below((x[i] - e.at[i] + far) / period_[i]));
            }
        }
        for_each_in_box(low, high, [&](const whole_periods& image) {
            double square = 0;
            for (int i = 0; i < N; ++i) {
                const double d = e.at[i] - x[i] + image[static_cast<std::size_t>(i)] * period_[i];
                square += d * d;
            }
            if (!(square > far * far)) {
                f(b, image);
            }
        });
    }
    template <class F>
    void look(const level& l, const point& x, double own, bool everyone, F& f) const {
        const double reach = 1.001 * (own + l.reach) + slack_;
        cell low, high;
        double cells = 1;
        for (int i = 0; i < N; ++i) {
            const auto k = static_cast<std::size_t>(i);
            low[k] = l.along(x[i] - reach, i);
            high[k] = l.along(x[i] + reach, i);
            cells *= static_cast<double>(high[k] - low[k] + 1);
        }
        if (everyone || !(cells < 2 * static_cast<double>(entries_.size()) + 64)) { // then the points are fewer
            for (body b = 0; b < entries_.size(); ++b) {
                if (entries_[b].power == l.power) {
                    offer_all(b, x, (own + entries_[b].reach) * (1 + 0x1p-30) + slack_, f);
                }
            }
            return;
        }
        if (entries_.size() <= fit_into_cache) {
            l.for_each(low, high, x, period_, [&](const point& from, const whole_periods& image, std::uint64_t key) {
                for (body b = heads_[key & (heads_.size() - 1)]; b != no_body; b = entries_[b].next) {
                    offer({from, image, key, b}, own, f);
                }
            });
            return;
        }
        std::array<cursor, 32> lists;
        std::size_t count = 0;
        l.for_each(low, high, x, period_, [&](const point& from, const whole_periods& image, std::uint64_t key) {
            if (const body first = heads_[key & (heads_.size() - 1)]; first != no_body) {
                __builtin_prefetch(&entries_[first]);
                lists[count++] = {from, image, key, first};
                if (count == lists.size()) {
                    go_along(lists, count, own, f);
                }
            }
        });
        go_along(lists, count, own, f);
    }
    // f(b, image) if b is in that cell and near.
    template <class F>
    [[gnu::always_inline]] void offer(const cursor& c, double own, F& f) const {
        if (const entry& e = entries_[c.next]; e.key == c.key) {
            const double far = (own + e.reach) * (1 + 0x1p-30) + slack_;
            if (!(graze::squared_norm(e.at - c.from) > far * far)) {
                f(c.next, c.image);
            }
        }
    }
    // f(b, image) for those in the lists, along all of these at once: what is next on one is fetched meanwhile.
    template <class Lists, class F>
    void go_along(Lists& lists, std::size_t& count, double own, F& f) const {
        while (count > 0) {
            for (std::size_t i = 0; i < count;) {
                cursor& c = lists[i];
                offer(c, own, f);
                const body next = entries_[c.next].next;
                if (next == no_body) {
                    c = lists[--count];
                } else {
                    c.next = next;
                    __builtin_prefetch(&entries_[next]);
                    ++i;
                }
            }
        }
    }
    std::vector<entry> entries_;
    std::vector<body> heads_; // of the cells' lists, some of which are of several cells; a power of two
    std::vector<level> levels_;
    double base_ = 1;
    point period_{};
    double slack_ = 0; // more than the rounding of whole periods and of places within them
};

} // namespace graze::inline v0_1::detail
