// Which points of space are near another one: cells of many sizes.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/scene/body.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze::inline v0_1::detail {

// Points, each with a reach. Those whose reaches differ by less than a factor of 2 are on one level, in cells twice as
// wide as the largest of these. Space has no end, and an empty cell takes no memory: where a cell's points are is found
// by a hash of its coordinates. Along an axis of which period[i] > 0 space is a circle of that length, on which points
// are within half of it around 0; there cells are wider by as much as it takes to have a whole number of them.
template <int N>
class centre_cells {
  public:
    using point = vec<N, double>;

    centre_cells() = default;
    // Of so many points; cells are cut so that usual_reach is the largest on its level.
    centre_cells(std::size_t points, double usual_reach, const point& period)
        : entries_(points), heads_(std::bit_ceil(2 * points + 16), no_body), base_(usual_reach), period_(period) {}

    // To be called before `enter` with this reach.
    void make_level(double reach) {
        const int power = power_of(reach);
        if (find(power) == levels_.size()) {
            std::erase_if(levels_, [](const level& l) { return l.count == 0; });
            level l{power, {}, {}, 0, 0};
            const double width = 2 * std::ldexp(base_, power);
            for (int i = 0; i < N; ++i) {
                const auto k = static_cast<std::size_t>(i);
                const bool circle = period_[i] > 0;
                l.around[k] = circle ? std::max<std::int64_t>(1, floor_of(std::min(period_[i] / width, 0x1p30))) : 0;
                l.per_length.component[i] = circle ? static_cast<double>(l.around[k]) / period_[i] : 1 / width;
            }
            levels_.push_back(l);
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
            c[static_cast<std::size_t>(i)] = wrapped(l, cell_along(l, x, i), i);
        }
        e.key = key_of(l, c);
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

    // f(b) for all points of which an image may be within `reach` and its own of x, but for those that certainly are
    // not; seldom more than once.
    template <class F>
    void around(const point& x, double reach, F f) const {
        for (const level& l : levels_) {
            if (l.count > 0) {
                look(l, x, reach, f);
            }
        }
    }

  private:
    static constexpr int out = 1 << 20;
    using cell = std::array<std::int64_t, N>;

    // around: so many cells are a period. reach: the largest yet.
    struct level {
        int power;
        point per_length;
        cell around;
        double reach;
        std::size_t count;
    };
    struct entry {
        point at{};
        double reach = 0;
        std::uint64_t key = 0;
        body next = no_body, previous = no_body;
        int power = out;
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
        std::size_t i = 0;
        while (i < levels_.size() && levels_[i].power != power) {
            ++i;
        }
        return i;
    }
    [[nodiscard]] static std::int64_t floor_of(double x) noexcept {
        const auto whole = static_cast<std::int64_t>(std::clamp(x, -0x1p60, 0x1p60));
        return whole - (static_cast<double>(whole) > x ? 1 : 0);
    }
    // Monotonic in x, however its product is rounded.
    [[nodiscard]] static std::int64_t cell_along(const level& l, const point& x, int i) noexcept {
        return floor_of(x[i] * l.per_length[i]);
    }
    [[nodiscard]] static std::int64_t wrapped(const level& l, std::int64_t along, int i) noexcept {
        const std::int64_t n = l.around[static_cast<std::size_t>(i)];
        if (n == 0) {
            return along;
        }
        const std::int64_t rest = along % n;
        return rest < 0 ? rest + n : rest;
    }
    // Cells side by side along the first axis have their lists side by side.
    [[nodiscard]] static std::uint64_t key_of(const level& l, const cell& c) noexcept {
        std::uint64_t key = static_cast<std::uint64_t>(c[0]) +
                            static_cast<std::uint64_t>(l.power) * 0xd6e8feb86659fd93U +
                            static_cast<std::uint64_t>(c[1]) * 0x9e3779b97f4a7c55U;
        if constexpr (N == 3) {
            key += static_cast<std::uint64_t>(c[2]) * 0xc2b2ae3d27d4eb4fU;
        }
        return key;
    }
    [[nodiscard, gnu::always_inline]] static bool is_near(const entry& e, const point& x, double reach) noexcept {
        double square = 0;
        for (int i = 0; i < N; ++i) {
            const double d = e.at[i] - x[i];
            square += d * d;
        }
        const double far = (reach + e.reach) * (1 + 0x1p-30);
        return !(square > far * far);
    }
    template <class F>
    void look(const level& l, const point& x, double own, F& f) const {
        const double reach = 1.001 * (own + l.reach);
        cell low, size, c{};
        double cells = 1;
        for (int i = 0; i < N; ++i) {
            const auto k = static_cast<std::size_t>(i);
            point from = x, to = x;
            from.component[i] -= reach;
            to.component[i] += reach;
            low[k] = cell_along(l, from, i);
            size[k] = cell_along(l, to, i) - low[k] + 1;
            if (l.around[k] != 0) {
                size[k] = std::min(size[k], l.around[k]);
            }
            cells *= static_cast<double>(size[k]);
        }
        if (!(cells < 2 * static_cast<double>(entries_.size()) + 64)) { // then the points are fewer
            for (body b = 0; b < entries_.size(); ++b) {
                if (entries_[b].power == l.power && is_near(entries_[b], x, own)) {
                    f(b);
                }
            }
            return;
        }
        while (true) {
            cell at;
            for (int i = 0; i < N; ++i) {
                const auto k = static_cast<std::size_t>(i);
                at[k] = wrapped(l, low[k] + c[k], i);
            }
            const std::uint64_t key = key_of(l, at);
            for (body b = heads_[key & (heads_.size() - 1)]; b != no_body; b = entries_[b].next) {
                if (entries_[b].key == key && is_near(entries_[b], x, own)) {
                    f(b);
                }
            }
            std::size_t axis = 0;
            while (axis < N && ++c[axis] == size[axis]) {
                c[axis++] = 0;
            }
            if (axis == N) {
                return;
            }
        }
    }

    std::vector<entry> entries_;
    std::vector<body> heads_; // of the cells' lists, some of which are of several cells; a power of two
    std::vector<level> levels_;
    double base_ = 1;
    point period_{};
};

} // namespace graze::inline v0_1::detail
