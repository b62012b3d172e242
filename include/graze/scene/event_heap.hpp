// What a run has foreseen, the earliest first.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace graze::inline v0_1::detail {

// A ball, plane or wall of a run: the balls first, then the planes, then the walls.
using body = std::uint32_t;
inline constexpr body no_body = 0xffffffffU;

// Body a, a ball, meets body b not before lower, unless one of the two has had another event since (counts). Or a
// reaches the border of its cell on a level of the grid: then b is crossing_of(level).
struct foreseen {
    double lower;
    body a;
    body b;
    std::uint32_t count_a;
    std::uint32_t count_b;
};

inline constexpr body first_crossing = 0xffffff00U;
[[nodiscard]] constexpr body crossing_of(int level) noexcept { return first_crossing + static_cast<body>(level); }
[[nodiscard]] constexpr bool is_crossing(const foreseen& f) noexcept { return f.b >= first_crossing; }
[[nodiscard]] constexpr int level_of(const foreseen& f) noexcept { return static_cast<int>(f.b - first_crossing); }

// The standard heap, by lower bounds alone: doubles have a total order, which exact times that have become meaningless
// would not. Most of what is foreseen never happens, because something else comes first: so only what is near is in
// the heap, which a cache holds. The rest waits behind it, in no order, until the heap is empty; by then most of it is
// no longer true, and is dropped.
class event_heap {
  public:
    [[nodiscard]] std::size_t size() const noexcept { return entries_.size(); }
    void clear() noexcept {
        entries_.clear();
        all_wait();
    }

    // After it, this many pushes neither allocate nor throw.
    void make_room(std::size_t count) {
        if (entries_.capacity() - entries_.size() < count) {
            entries_.reserve(std::max(2 * entries_.capacity(), entries_.size() + count));
        }
    }
    void push(const foreseen& f) {
        entries_.push_back(f);
        if (f.lower <= horizon_) {
            std::swap(entries_[near_], entries_.back());
            ++near_;
            std::push_heap(entries_.begin(), heap_end(), is_later{});
        }
    }
    // Whether there is a top. What waits may have to come to the heap first; what is_stale is dropped by the way.
    template <class F>
    [[nodiscard]] bool has_top(F is_stale) noexcept {
        if (near_ == 0 && !entries_.empty()) {
            bring_near(is_stale);
        }
        return near_ > 0;
    }
    [[nodiscard]] const foreseen& top() const noexcept { return entries_.front(); }
    void pop() noexcept {
        std::pop_heap(entries_.begin(), heap_end(), is_later{});
        --near_;
        entries_[near_] = entries_.back();
        entries_.pop_back();
    }
    // Drops everything of which is_stale is true.
    template <class F>
    void purge(F is_stale) noexcept {
        entries_.erase(std::remove_if(entries_.begin(), entries_.end(), is_stale), entries_.end());
        all_wait();
    }

  private:
    struct is_later {
        [[nodiscard]] bool operator()(const foreseen& x, const foreseen& y) const noexcept { return x.lower > y.lower; }
    };
    [[nodiscard]] std::vector<foreseen>::iterator heap_end() noexcept {
        return entries_.begin() + static_cast<std::ptrdiff_t>(near_);
    }

    void all_wait() noexcept {
        near_ = 0;
        horizon_ = std::numeric_limits<double>::lowest();
    }
    // Fills an empty heap with about a sixteenth of what waits, by a sample of it; where that is little, with all.
    template <class F>
    void bring_near(F is_stale) noexcept {
        purge(is_stale);
        horizon_ = std::numeric_limits<double>::max();
        if (std::array<double, 256> sample; entries_.size() > 4 * sample.size()) {
            for (std::size_t i = 0; i < sample.size(); ++i) {
                sample[i] = entries_[entries_.size() / sample.size() * i].lower;
            }
            const auto quantile = sample.begin() + sample.size() / 16;
            std::nth_element(sample.begin(), quantile, sample.end());
            horizon_ = *quantile;
        }
        const auto is_near = [&](const foreseen& f) { return f.lower <= horizon_; };
        near_ = static_cast<std::size_t>(std::partition(entries_.begin(), entries_.end(), is_near) - entries_.begin());
        std::make_heap(entries_.begin(), heap_end(), is_later{});
    }

    std::vector<foreseen> entries_;                          // the heap, then what waits
    std::size_t near_ = 0;                                   // so many are in the heap
    double horizon_ = std::numeric_limits<double>::lowest(); // what waits is after it
};

} // namespace graze::inline v0_1::detail
