// The points near another one, by cells of many sizes.
#pragma once

#include <graze/machine/fetch.hpp>
#include <graze/scene/box_walk.hpp>
#include <graze/scene/levelled_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace graze::inline v0_1::detail {

template <int N>
class centre_cells : public levelled_points<N> {
  public:
    using typename levelled_points<N>::point;
    using levelled_points<N>::levelled_points;

    // f(b, image), an image_code, for all points' images that may be within `reach` plus their own reach of x; seldom
    // more than once. everyone: without cells.
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
        std::uint64_t key;
        image_code image;
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
                f(b, coded(image));
            }
        });
    }
    // The same for all points with a power from `lowest` to `highest`, without cells.
    template <class F>
    void offer_levels(int lowest, int highest, const point& x, double own, F& f) const {
        for (body b = 0; b < entries_.size(); ++b) {
            if (const entry& e = entries_[b]; lowest <= e.power && e.power <= highest) {
                offer_all(b, x, (own + e.reach) * (1 + 0x1p-30) + slack_, f);
            }
        }
    }
    // Whether there are fewer points than such cells, or too many cells for a walk.
    [[nodiscard]] bool has_fewer_points(const typename level::box& near) const noexcept {
        return !(near.cells() < 2 * static_cast<double>(entries_.size()) + 64);
    }
    template <class F>
    void look(const level& l, const point& x, double own, bool everyone, F& f) const {
        const double far = 1.001 * (own + l.reach) + slack_;
        const typename level::box near = l.cells_within(x, far);
        if (everyone || has_fewer_points(near)) {
            offer_levels(l.power, l.power, x, own, f);
            return;
        }
        const double reach = own + 0x1p-30 * (own + l.reach) + slack_;
        if (entries_.size() <= fit_into_cache) {
            const entry* const entries = entries_.data();
            const body* const heads = heads_.data();
            const std::uint64_t mask = heads_.size() - 1;
            l.for_each(near, x, far, period_, [&](const point& from, image_code image, std::uint64_t key) {
                for (body b = heads[key & mask]; b != no_body; b = entries[b].next) {
                    offer(from, image, key, entries[b], b, reach, f);
                }
            });
            return;
        }
        std::array<cursor, 32> lists;
        std::size_t count = 0;
        l.for_each(near, x, far, period_, [&](const point& from, image_code image, std::uint64_t key) {
            if (const body first = heads_[key & (heads_.size() - 1)]; first != no_body) {
                detail::fetch(entries_[first]);
                lists[count++] = {from, key, image, first};
                if (count == lists.size()) {
                    go_along(lists, count, reach, f);
                }
            }
        });
        go_along(lists, count, reach, f);
    }
    template <class F>
    void look_at_finer(const level& l, const point& x, double own, F& f) const {
        const double largest = std::ldexp(base_, l.power - 2);
        const double far = 1.001 * (own + largest) + slack_;
        const double reach = own + 0x1p-30 * (own + largest) + slack_;
        const typename level::box near = l.cells_within(x, far);
        if (has_fewer_points(near)) {
            offer_levels(std::numeric_limits<int>::min(), l.power - 2, x, own, f);
            return;
        }
        l.for_each(near, x, far, period_, [&](const point& from, image_code image, std::uint64_t key) {
            l.finer.for_each(key, [&](body b) { offer(from, image, entries_[b].key, entries_[b], b, reach, f); });
        });
    }
    // f(b, image) if b, with that entry, is in that cell and near.
    template <class F>
    [[gnu::always_inline]] static void offer(const point& from, image_code image, std::uint64_t key, const entry& e,
                                             body b, double reach, F& f) {
        if (e.key == key) {
            const double far = reach + e.reach;
            if (!(graze::squared_norm(e.at - from) > far * far)) {
                f(b, image);
            }
        }
    }
    // f(b, image) for those in the lists, along all of these at once: what is next on one is fetched meanwhile.
    template <class Lists, class F>
    void go_along(Lists& lists, std::size_t& count, double reach, F& f) const {
        while (count > 0) {
            for (std::size_t i = 0; i < count;) {
                cursor& c = lists[i];
                offer(c.from, c.image, c.key, entries_[c.next], c.next, reach, f);
                const body next = entries_[c.next].next;
                if (next == no_body) {
                    c = lists[--count];
                } else {
                    c.next = next;
                    detail::fetch(entries_[next]);
                    ++i;
                }
            }
        }
    }
};

} // namespace graze::inline v0_1::detail
