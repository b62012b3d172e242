// The points near another one, by cells of many sizes.
#pragma once

#include <graze/scene/box_walk.hpp>
#include <graze/scene/levelled_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

template <int N>
class centre_cells : public levelled_points<N> {
  public:
    using typename levelled_points<N>::point;
    using levelled_points<N>::levelled_points;

    // f(b, image) for all points' images that may be within `reach` plus their own reach of x; seldom more than once.
    // everyone: without cells.
    template <class F>
    void around(const point& x, double reach, bool everyone, F&& f) const {
        const int power = power_of(reach);
        const bool every_level = everyone || find(power) == levels_.size();
        for (const level& l : levels_) {
            if (l.count > 0 && (every_level || l.power >= power - 1)) {
                look(l, x, reach, everyone, f);
            }
            if (l.power == power && !every_level && !l.finer.empty()) {
                look_at_finer(l, x, reach, f);
            }
        }
    }

  private:
    using typename levelled_points<N>::level;
    using typename levelled_points<N>::entry;
    using levelled_points<N>::entries_;
    using levelled_points<N>::heads_;
    using levelled_points<N>::levels_;
    using levelled_points<N>::base_;
    using levelled_points<N>::period_;
    using levelled_points<N>::slack_;
    using levelled_points<N>::power_of;
    using levelled_points<N>::find;

    // A place in a cell's list: x as seen from there is at `from`.
    struct cursor {
        point from;
        image_index image;
        std::uint64_t key;
        body next;
    };

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
        const auto [low, high] = l.cells_within(x, 1.001 * (own + l.reach) + slack_);
        double cells = 1;
        for (std::size_t k = 0; k < N; ++k) {
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
                body b = heads_[key & (heads_.size() - 1)];
                if (b == no_body) {
                    return;
                }
                const image_index there = image;
                for (; b != no_body; b = entries_[b].next) {
                    offer(from, there, key, b, own, f);
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
    template <class F>
    void look_at_finer(const level& l, const point& x, double own, F& f) const {
        const auto [low, high] = l.cells_within(x, 1.001 * (own + std::ldexp(base_, l.power - 2)) + slack_);
        l.for_each(low, high, x, period_, [&](const point& from, const whole_periods& image, std::uint64_t key) {
            l.finer.for_each(key, [&](body b) { offer(from, image, entries_[b].key, b, own, f); });
        });
    }
    // f(b, image) if b is in that cell and near.
    template <class F>
    [[gnu::always_inline]] void offer(const point& from, const image_index& image, std::uint64_t key, body b,
                                      double own, F& f) const {
        if (const entry& e = entries_[b]; e.key == key) {
            const double far = (own + e.reach) * (1 + 0x1p-30) + slack_;
            if (!(graze::squared_norm(e.at - from) > far * far)) {
                f(b, image);
            }
        }
    }
    // f(b, image) for those in the lists, along all of these at once: what is next on one is fetched meanwhile.
    template <class Lists, class F>
    void go_along(Lists& lists, std::size_t& count, double own, F& f) const {
        while (count > 0) {
            for (std::size_t i = 0; i < count;) {
                cursor& c = lists[i];
                offer(c.from, c.image, c.key, c.next, own, f);
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
};

} // namespace graze::inline v0_1::detail
