// The exact time of a collision of flights, as a value.
#pragma once

#include <graze/time/flight_event.hpp>
#include <graze/time/impact_time.hpp>

namespace graze::inline v0_1 {

namespace detail {

// Two doubles between which a time lies, whose lower end may be unknown as well. At its start: on both.
struct timed_enclosure {
    double first = -enclosure::unknown;
    double last = enclosure::unknown;

    [[nodiscard]] constexpr bool is_point() const noexcept { return bits_of(first) == bits_of(last); }
    [[nodiscard]] constexpr double lower() const noexcept { return first; }
    [[nodiscard]] constexpr double upper() const noexcept { return last; }
};

// start + τ, τ in the enclosure given. A sum is off by at most u of itself in any rounding mode, and by what a mode
// makes zero where it is subnormal, as it does with a start, a subnormal T.
template <class T>
[[nodiscard]] inline timed_enclosure counted_from(double start, const enclosure& e) noexcept {
    constexpr double flushed = std::is_same_v<T, float> ? 0x1p-124 : 0x1p-1020;
    const double low = start + e.lower();
    const double high = start + e.upper();
    const double lower = low - (0x1p-51 * std::fabs(low) + flushed);
    const double upper = high + (0x1p-51 * std::fabs(high) + flushed);
    return {lower, e.is_known() && upper < enclosure::unknown ? upper : enclosure::unknown};
}

} // namespace detail

// The first time at which two flights, or a flight and a plane or a wall, touch: on the clock of `since`, not before
// the later one's. A regular type but for a default value, as impact_time is, and made by time_of_impact only: two are
// equal exactly when their times are, whatever met whatever and since when. Comparisons look at an enclosure in doubles
// first and at the inputs, which the value keeps, only when the enclosures overlap; they never round, throw or
// allocate. 168 bytes for N = 3 and doubles, 120 for N = 2.
template <int N, class T = double>
class flight_time {
  public:
    [[nodiscard]] friend constexpr std::strong_ordering operator<=>(const flight_time& x, const flight_time& y) {
        return x.compare(y) <=> 0;
    }
    [[nodiscard]] friend constexpr bool operator==(const flight_time& x, const flight_time& y) {
        return x.compare(y) == 0;
    }

    // Against a time in any of these types, exactly: neither side is rounded. Unordered with NaN.
    template <detail::time_number U>
    [[nodiscard]] friend constexpr std::partial_ordering operator<=>(const flight_time& x, const U& time) {
        return detail::compare_with_number(x.event_, x.bounds_, time);
    }
    template <detail::time_number U>
    [[nodiscard]] friend constexpr bool operator==(const flight_time& x, const U& time) {
        return detail::compare_with_number(x.event_, x.bounds_, time) == 0;
    }

    // The sign of *this - y: -1, 0 or 1. The observer is told which stage decided.
    template <class Observer = ignore_stage>
    [[nodiscard]] constexpr int compare(const flight_time& y, Observer&& observer = {}) const {
        if (bounds_.last < y.bounds_.first || bounds_.first > y.bounds_.last) {
            observer(stage::filter);
            return bounds_.last < y.bounds_.first ? -1 : 1;
        }
        if (bounds_.is_point() && y.bounds_.is_point() &&
            detail::bits_of(bounds_.last) == detail::bits_of(y.bounds_.last)) { // both touch or overlap then
            observer(stage::filter);
            return 0;
        }
        observer(stage::exact);
        return detail::compare_exactly(event_, y.event_);
    }

    // The nearest number, ties to even; beyond the largest one, an infinity.
    [[nodiscard]] explicit constexpr operator T() const { return rounded(rounding::nearest); }
    // The largest number that is not later, and the smallest that is not earlier.
    [[nodiscard]] constexpr T lower() const { return rounded(rounding::downward); }
    [[nodiscard]] constexpr T upper() const { return rounded(rounding::upward); }

    // A double near the time, at no cost: for reports, not for decisions. In a constant expression 0.
    [[nodiscard]] constexpr double about() const noexcept { return 0.5 * bounds_.first + 0.5 * bounds_.last; }

    // Two doubles between which it lies, at no cost. In a constant expression they tell nothing.
    [[nodiscard]] constexpr const detail::timed_enclosure& enclosure() const noexcept { return bounds_; }

    // For time_of_impact: an event, by the arguments of its constructor, and its enclosure.
    template <class... Event>
    constexpr flight_time(detail::impact_time_key, const detail::timed_enclosure& bounds,
                          const Event&... arguments) noexcept
        : event_(arguments...), bounds_(bounds) {}

  private:
    [[nodiscard]] constexpr T rounded(rounding mode) const {
        return bounds_.is_point() ? event_.start() : detail::round_exactly<T>(event_, mode);
    }

    detail::flight_event<N, T> event_;
    detail::timed_enclosure bounds_;
};

} // namespace graze::inline v0_1
