// What a run has foreseen, the earliest first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze::detail {

// A ball, plane or wall of a run: the balls first, then the planes, then the walls.
using body = std::uint32_t;
inline constexpr body no_body = 0xffffffffU;

// Body a, a ball, meets body b not before lower and not after upper, unless one of the two has had another event since
// (counts). Or a reaches the border of its cell on a level of the grid: then b is crossing_of(level).
struct foreseen {
    double lower;
    double upper;
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
// would not. What is no longer true is left where it is until it comes to the top.
class event_heap {
  public:
    [[nodiscard]] bool empty() const noexcept { return entries_.empty(); }
    [[nodiscard]] std::size_t size() const noexcept { return entries_.size(); }
    [[nodiscard]] const foreseen& top() const noexcept { return entries_.front(); }
    void clear() noexcept { entries_.clear(); }

    // After it, this many pushes neither allocate nor throw.
    void make_room(std::size_t count) {
        if (entries_.capacity() - entries_.size() < count) {
            entries_.reserve(std::max(2 * entries_.capacity(), entries_.size() + count));
        }
    }
    void push(const foreseen& f) {
        entries_.push_back(f);
        std::push_heap(entries_.begin(), entries_.end(), is_later{});
    }
    void pop() noexcept {
        std::pop_heap(entries_.begin(), entries_.end(), is_later{});
        entries_.pop_back();
    }
    // Drops everything of which is_stale is true.
    template <class F>
    void purge(F is_stale) noexcept {
        entries_.erase(std::remove_if(entries_.begin(), entries_.end(), is_stale), entries_.end());
        std::make_heap(entries_.begin(), entries_.end(), is_later{});
    }

  private:
    struct is_later {
        [[nodiscard]] bool operator()(const foreseen& x, const foreseen& y) const noexcept { return x.lower > y.lower; }
    };
    std::vector<foreseen> entries_;
};

} // namespace graze::detail
