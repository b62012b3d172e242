// The exact time of a collision, as a value.
#pragma once

#include <graze/pair/stage.hpp>
#include <graze/time/compare_with_number.hpp>
#include <graze/time/enclosure.hpp>
#include <graze/time/exact_event.hpp>
#include <graze/time/round_time.hpp>

#include <compare>
#include <type_traits>

namespace graze::inline v0_1 {

namespace detail {

// Only time_of_impact can make impact times.
struct impact_time_key {
    explicit constexpr impact_time_key() = default;
};

} // namespace detail

// Law 5 of classify_balls.hpp, and
//   11. numbers belong to the same order: lower() <= τ <= upper(), τ is one of them only if it is both, and a time
//       before a number that is before another time is before that time.

// The first time at which a pair touches (its start for an overlap). For balls it counts from the instant at which
// their positions are given, for flights on the clock of `since`; a flight's time is not before the later epoch. It is
// one clock, since a ball is a flight since 0. A regular type without a default value: two are equal exactly when their
// times are, of whatever pair kinds and epochs. Comparisons use an enclosure in doubles first, and the inputs, which
// the value keeps, only where enclosures overlap; they never round, throw or allocate. A conversion rounds once, in any
// floating-point environment. Only time_of_impact makes it; std::optional orders that function's empty answer before
// every time. 168 bytes for N = 3 and doubles, 128 for N = 2.
template <int N, class T = double>
class impact_time {
  public:
    [[nodiscard]] friend constexpr std::strong_ordering operator<=>(const impact_time& x, const impact_time& y) {
        return x.compare(y) <=> 0;
    }
    [[nodiscard]] friend constexpr bool operator==(const impact_time& x, const impact_time& y) {
        return x.compare(y) == 0;
    }

    // Compares with a time in any of these types, exactly: neither side is rounded. Unordered with NaN.
    template <detail::time_number U>
    [[nodiscard]] friend constexpr std::partial_ordering operator<=>(const impact_time& x, const U& time) {
        return detail::compare_with_number(x.event_, x.bounds(), time);
    }
    template <detail::time_number U>
    [[nodiscard]] friend constexpr bool operator==(const impact_time& x, const U& time) {
        return detail::compare_with_number(x.event_, x.bounds(), time) == 0;
    }

    // The sign of *this - y: -1, 0 or 1. The observer is told which stage decided.
    template <class Observer = ignore_stage>
    [[nodiscard, gnu::always_inline]] constexpr int compare(const impact_time& y, Observer&& observer = {}) const {
        if (bounds().is_apart_from(y.bounds())) [[likely]] {
            observer(stage::filter);
            return near_ < y.near_ ? -1 : 1;
        }
        if (bounds().is_point() && y.bounds().is_point() && detail::bits_of(near_) == detail::bits_of(y.near_)) {
            // both touch or overlap then
            observer(stage::filter);
            return 0;
        }
        observer(stage::exact);
        return detail::compare_exactly(event_, y.event_);
    }

    // The type to which a time is rounded: T, or double if T is an integer type.
    using rounded_type = std::conditional_t<std::is_floating_point_v<T>, T, double>;

    // The nearest number, ties to even; beyond the largest one, an infinity.
    [[nodiscard, gnu::always_inline]] explicit constexpr operator rounded_type() const {
        return detail::round_time<rounded_type, rounding::nearest>(event_, bounds());
    }
    // The largest number that is not later, and the smallest number that is not earlier.
    [[nodiscard]] constexpr rounded_type lower() const {
        return detail::round_time<rounded_type, rounding::downward>(event_, bounds());
    }
    [[nodiscard]] constexpr rounded_type upper() const {
        return detail::round_time<rounded_type, rounding::upward>(event_, bounds());
    }

    // A double near the time, at no cost: for reports, not for decisions. In a constant expression 0.
    [[nodiscard]] constexpr double about() const noexcept { return near_; }

    // Two doubles between which it lies, at no cost. In a constant expression they say nothing.
    [[nodiscard]] constexpr detail::enclosure enclosure() const noexcept { return bounds(); }

    // For time_of_impact: the arguments of an event's constructor, and its enclosure.
    template <class... Event>
    constexpr impact_time(detail::impact_time_key, const detail::enclosure& bounds, const Event&... arguments) noexcept
        : error_(bounds.error), event_(arguments...), near_(bounds.near) {}

  private:
    [[nodiscard]] constexpr detail::enclosure bounds() const noexcept { return {near_, error_}; }

    // Not next to near_: a compiler would store both together, and a conversion that needs one would wait for both.
    double error_;
    detail::event<N, T> event_;
    double near_;
};

} // namespace graze::inline v0_1
