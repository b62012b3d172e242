// The next event of each ball of a run, the earliest first.
#pragma once

#include <graze/machine/fetch.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace graze::inline v0_1::detail {

// One time per ball. The near future is cut into buckets of equal length, each a list of the balls whose events are in
// it. The current bucket is a small heap; later events wait in one more list. When the buckets are used up, new ones
// are laid over the waiting events. Only the heap is ordered, so changing a time takes a few steps however many balls
// there are.
//
// A function of the time, computed in one place, finds the bucket. Rounding leaves it monotonic: an event in an
// earlier bucket is not later.
class event_calendar {
  public:
    explicit event_calendar(body balls = 0)
        : entries_(balls), heads_(std::max<std::size_t>(16, balls / 4) + 1, no_body) {
        heap_.reserve(balls);
    }

    // Nothing is scheduled at or after the largest double.
    void schedule(body a, double when) noexcept {
        entry& e = entries_[a];
        const bool is_in_heap = e.where == in_heap;
        if (e.where != nowhere && !is_in_heap) {
            unlink(a);
        }
        e.when = when;
        if (!(when < never)) {
            if (is_in_heap) {
                take_out(a);
            }
            e.where = nowhere;
            return;
        }
        const std::uint32_t bucket = bucket_of(when);
        if (bucket > current_) {
            if (is_in_heap) {
                take_out(a);
            }
            link(a, bucket);
        } else if (is_in_heap) {
            move(e.next, {when, a});
        } else {
            e.where = in_heap;
            heap_.push_back({when, a}); // for which there is room
            move(static_cast<std::uint32_t>(heap_.size() - 1), {when, a});
        }
    }
    void remove(body a) noexcept { schedule(a, never); }

    // The ball whose instant is the earliest, or no_body.
    [[nodiscard]] body earliest() noexcept {
        while (heap_.empty()) {
            if (current_ + 1 < waiting()) {
                ++opened_;
                distribute(++current_);
            } else if (!lay_buckets()) {
                return no_body;
            }
        }
        return heap_.front().a;
    }
    // Whether the earliest ball is the only one with an event up to a time. False if it would take a longer search to
    // find out.
    [[nodiscard]] bool is_only_until(double time) const noexcept {
        const double second = heap_.size() > 2   ? std::min(heap_[1].when, heap_[2].when)
                              : heap_.size() > 1 ? heap_[1].when
                                                 : never;
        return second > time && bucket_of(time) <= current_;
    }
    [[nodiscard]] double when(body a) const noexcept { return entries_[a].when; }

    // How many buckets have been opened.
    [[nodiscard]] std::uint64_t opened() const noexcept { return opened_; }
    // f(a) for the balls whose events are in the bucket that is so many after the current one, if it has been laid.
    template <class F>
    void for_each_in(std::uint32_t later, F f) const noexcept {
        for (body a = later < waiting() - current_ ? heads_[current_ + later] : no_body; a != no_body;
             a = entries_[a].next) {
            f(a);
        }
    }
    // Fetches from memory what for_each_in reads of the first one in that bucket.
    void fetch(std::uint32_t later) const noexcept {
        if (const body a = later < waiting() - current_ ? heads_[current_ + later] : no_body; a != no_body) {
            detail::fetch(entries_[a]);
        }
    }

  private:
    static constexpr double never = std::numeric_limits<double>::max();
    static constexpr std::uint32_t nowhere = 0xffffffffU;
    static constexpr std::uint32_t in_heap = 0xfffffffeU;

    // where: a bucket, or one of these. next: in the heap, its place there.
    struct entry {
        double when = never;
        std::uint32_t next = 0;
        std::uint32_t previous = 0;
        std::uint32_t where = nowhere;
    };
    struct instant {
        double when;
        body a;
    };

    [[nodiscard]] std::uint32_t waiting() const noexcept { return static_cast<std::uint32_t>(heads_.size() - 1); }
    [[nodiscard, gnu::noinline]] std::uint32_t bucket_of(double when) const noexcept {
        const double x = (when - start_) * per_time_;
        return !(x < static_cast<double>(waiting())) ? waiting() : x > 0 ? static_cast<std::uint32_t>(x) : 0;
    }

    void link(body a, std::uint32_t bucket) noexcept {
        entry& e = entries_[a];
        e.where = bucket;
        e.previous = no_body;
        e.next = std::exchange(heads_[bucket], a);
        if (e.next != no_body) {
            entries_[e.next].previous = a;
        }
    }
    void unlink(body a) noexcept {
        const entry& e = entries_[a];
        (e.previous == no_body ? heads_[e.where] : entries_[e.previous].next) = e.next;
        if (e.next != no_body) {
            entries_[e.next].previous = e.previous;
        }
    }

    void put(std::uint32_t at, const instant& x) noexcept {
        heap_[at] = x;
        entries_[x.a].next = at;
    }
    // Puts x where it belongs once the entry at `from` is gone; a copy of x may be at `from`.
    void move(std::uint32_t from, instant x) noexcept {
        std::uint32_t at = from;
        for (; at > 0 && x.when < heap_[(at - 1) / 2].when; at = (at - 1) / 2) {
            put(at, heap_[(at - 1) / 2]);
        }
        const auto size = static_cast<std::uint32_t>(heap_.size());
        while (at >= from && 2 * at + 1 < size) {
            std::uint32_t child = 2 * at + 1;
            child += child + 1 < size && heap_[child + 1].when < heap_[child].when ? 1 : 0;
            if (!(heap_[child].when < x.when)) {
                break;
            }
            put(at, heap_[child]);
            at = child;
        }
        put(at, x);
    }
    void take_out(body a) noexcept {
        const std::uint32_t at = entries_[a].next;
        const instant last = heap_.back();
        heap_.pop_back();
        if (at < heap_.size()) {
            move(at, last);
        }
    }
    // Schedules all of a list anew.
    void distribute(std::uint32_t bucket) noexcept {
        for (body a = std::exchange(heads_[bucket], no_body); a != no_body;) {
            const body next = entries_[a].next;
            entries_[a].where = nowhere;
            schedule(a, entries_[a].when);
            a = next;
        }
    }
    // Lays buckets over the waiting events, so that the first hold about one each, by a sample of the first quarter.
    // False if none waits.
    [[nodiscard]] bool lay_buckets() noexcept {
        std::array<double, 128> sample{};
        std::size_t taken = 0;
        const std::size_t stride = entries_.size() / sample.size() + 1;
        if (heads_[waiting()] == no_body) {
            return false;
        }
        sample[taken++] = entries_[heads_[waiting()]].when;
        for (std::size_t i = 0; i < entries_.size() && taken < sample.size(); i += stride) {
            if (entries_[i].where != nowhere) {
                sample[taken++] = entries_[i].when;
            }
        }
        const auto quarter = sample.begin() + static_cast<std::ptrdiff_t>(taken / 4);
        std::nth_element(sample.begin(), quarter, sample.begin() + static_cast<std::ptrdiff_t>(taken));
        start_ = *std::min_element(sample.begin(), quarter + 1);
        const double length = (*quarter - start_) * 4 / static_cast<double>(heads_.size());
        per_time_ = length > 0x1p-1000 ? 1 / length : 0x1p1000;
        current_ = 0;
        distribute(waiting());
        return true;
    }

    records<entry> entries_;
    records<body> heads_; // of the buckets, and of the waiting list
    records<instant> heap_;
    double start_ = -never, per_time_ = 1; // of the first bucket; buckets per time
    std::uint32_t current_ = 0;            // the events of this bucket and those before are in the heap
    std::uint64_t opened_ = 0;
};

} // namespace graze::inline v0_1::detail
