// Bounds on the time at which two flights meet, for finding the earliest of many events.
#pragma once

#include <graze/time/time_of_flights.hpp>

namespace graze::inline v0_1::detail {

// By how much c + 2hT may be off at most, T = left.
//
// Of the values here, with the filter's scales L and V = √a, the error of c is at most K_c L², that of 2hT at most 2T
// K_h L V <= K_h (L² + a T²). T itself is rounded once, by 2^-52 of it, and so is each of the products and the sum:
// 2^-52 (2|h|T + 3 (|c| + 2|h|T)) <= 2^-52 (7 L² + 4 a T²), since |c| <= L² and 2|h|T <= 2LVT <= L² + a T². 2^-48 in
// place of 7 2^-52 covers the roundings of the bound.
template <class Constants>
[[nodiscard, gnu::always_inline]] inline double error_until(double a, double length2, double left) noexcept {
    constexpr double k = Constants::c + Constants::h + 0x1p-48;
    return k * (length2 + a * (left * left));
}

// Whether the two flights of the filter f, which are not certainly parting, certainly don't meet until `latest`.
//
// From the later start on for a time T the quadratic a t² + 2ht + c is, for h < 0, at least c + 2hT: where that is
// positive nothing is met.
template <class F, int N, class T>
[[nodiscard, gnu::always_inline]] inline bool is_beyond(const F& f, const flight<N, T>& a, const flight<N, T>& b,
                                                        double latest) {
    const double left =
        latest - static_cast<double>(as_stored(as_stored(a.since) < as_stored(b.since) ? b.since : a.since));
    return f.q.c + 2 * f.q.h * left > error_until<filter_of<flight<N, T>>>(f.q.a, f.length2, left);
}

// Doubles between which the time of two flights lies; the largest double and up if they don't meet, or certainly don't
// until `latest`. The latter settles most pairs before any root is taken. Throws as classify does.
template <int N, class T>
[[nodiscard, gnu::flatten]] enclosure bounds_until(const flight<N, T>& a, const flight<N, T>& b, double latest) {
    constexpr enclosure none{enclosure::unknown, 0};
    if (const auto f = start_filter(a, b); f.in_range) [[likely]] {
        if (f.is_parting() || is_beyond(f, a, b, latest)) {
            return none;
        }
        if (const auto hit = f.find_clear_hit(); hit.certain) [[likely]] {
            const enclosure from_start = enclosure_from_start<flight<N, T>>(f, hit.discriminant);
            if (has_error_free_doubles || from_start.is_known()) [[likely]] {
                const auto start =
                    static_cast<double>(as_stored(as_stored(a.since) < as_stored(b.since) ? b.since : a.since));
                return counted_from<T>(start, from_start);
            }
        } else if (const filtered_balls found = f.finish(); found.certain && !is_collision(found.what())) {
            return none;
        }
    }
    stage unused{};
    const auto further = time_of_impact_further(a, b, unused);
    return further ? further->enclosure() : none;
}

} // namespace graze::inline v0_1::detail
