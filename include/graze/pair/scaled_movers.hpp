// Two movers in doubles, brought to a size at which their formulas neither over- nor underflow.
#pragma once

#include <graze/exact/approximate.hpp>
#include <graze/exact/binary.hpp>
#include <graze/filter/static_filter.hpp>
#include <graze/machine/environment.hpp>
#include <graze/machine/fence.hpp>
#include <graze/pair/computed_motion.hpp>
#include <graze/pair/moving.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::inline v0_1::detail {

// The real lengths are 2^length and the real velocities 2^velocity times those of these movers. safe: whether a mode
// that reads or writes subnormals as zeros takes less than 2^-110 of the largest length and velocity.
template <class B>
struct scaled_movers {
    B a, b;
    int length = 0, velocity = 0;
    bool known = false;
    bool safe = false;
};

// The largest magnitude; a NaN may be left out.
[[nodiscard, gnu::always_inline]] inline double largest_size(const vec<2, double>& x) noexcept {
    return std::max(std::fabs(as_stored(x[0])), std::fabs(as_stored(x[1])));
}
[[nodiscard, gnu::always_inline]] inline double largest_size(const vec<3, double>& x) noexcept {
    return std::max(std::max(std::fabs(as_stored(x[0])), std::fabs(as_stored(x[1]))), std::fabs(as_stored(x[2])));
}

template <int N>
[[nodiscard, gnu::always_inline]] inline double largest_length(const ball<N, double>& a,
                                                               const ball<N, double>& b) noexcept {
    return std::max(std::max(largest_size(a.position), largest_size(b.position)),
                    std::max(std::fabs(as_stored(a.radius)), std::fabs(as_stored(b.radius))));
}

// The exponent by which a number is multiplied: the largest is then within [2^-52, 2).
[[nodiscard]] inline int scale_of(double largest) noexcept {
    return std::clamp(1023 - static_cast<int>(bits_of(largest) >> 52), -1022, 1023);
}

// The power of two by which a number is multiplied to be within [1, 2), or less if it is subnormal. Of a number from
// 2^1023 on it is 0 or no power at all.
[[nodiscard, gnu::always_inline]] inline double factor_to_unit(std::uint64_t largest) noexcept {
    return std::bit_cast<double>((std::uint64_t{2046} << 52) - (largest & std::uint64_t{0x7ff} << 52));
}

// The relative motion of two balls alone, its lengths multiplied by a power of two that brings the larger radius into
// [1, 2), its velocities by one that brings the largest into [1, 2). The radius is given by its bits.
template <int N>
struct scaled_motion {
    relative_motion<N, double, double, double> motion;
    double by_length, by_velocity;

    // Whether this can be relied on. Where subnormals are read or written as zeros, less than 2^-110 of these sizes is
    // then lost. A length that has overflowed, also to the largest double, becomes one above 2^284.
    bool safe;

    [[gnu::always_inline]] scaled_motion(const relative_motion<N, double, double, double>& m,
                                         std::uint64_t radius) noexcept
        : motion(m) {
        const double largest = largest_size(m.du);
        by_length = factor_to_unit(radius);
        by_velocity = factor_to_unit(bits_of(largest));
        safe = bits_within_powers<-900, 738>(radius) && within_powers<-900, 1023>(largest);
        motion.dx = make_vec<N>([&](int i) { return as_stored(m.dx[i] * by_length); });
        motion.du = make_vec<N>([&](int i) { return as_stored(m.du[i] * by_velocity); });
        motion.R = as_stored(m.R * by_length);
    }

    // The power of two that is the unit of a time.
    [[nodiscard]] int unit() const noexcept { return exponent_of(by_velocity) - exponent_of(by_length); }

    // The balls in the same units.
    [[nodiscard, gnu::always_inline]] scaled_movers<ball<N, double>> scaled(const ball<N, double>& a,
                                                                            const ball<N, double>& b) const noexcept {
        const auto each = [&](const ball<N, double>& x) __attribute__((always_inline)) {
            return ball<N, double>{
                make_vec<N>([&](int i) { return as_stored(as_stored(x.position[i]) * by_length); }),
                make_vec<N>([&](int i) { return as_stored(as_stored(x.velocity[i]) * by_velocity); }),
                as_stored(as_stored(x.radius) * by_length)};
        };
        return {each(a), each(b), 1023 - exponent_of(by_length), 1023 - exponent_of(by_velocity), safe, safe};
    }

  private:
    [[nodiscard]] static int exponent_of(double x) noexcept { return static_cast<int>(bits_of(x) >> 52); }
};

// One power of two multiplies all lengths and one all velocities, chosen from the largest; their quotient multiplies
// instants. Parts below 2^-1074 of the largest are lost. Not known if one is infinite or an instant would be too large.
template <class B>
[[nodiscard, gnu::always_inline]] inline scaled_movers<B> scaled(const B& a, const B& b) noexcept {
    scaled_movers<B> r;
    const double length = largest_length(state_of(a), state_of(b));
    const double velocity = std::max(largest_size(state_of(a).velocity), largest_size(state_of(b).velocity));
    if (!(std::max(length, velocity) <= std::numeric_limits<double>::max())) {
        return r;
    }
    const int up = scale_of(length);
    const int faster = scale_of(velocity);
    const double by = power_of_two(up);
    const double speed = power_of_two(faster);
    constexpr int N = dimension_of<B>;
    const auto put = [&](ball<N, double> & to, const ball<N, double>& from) __attribute__((always_inline)) {
        to.position = make_vec<N>([&](int i) { return as_stored(as_stored(from.position[i]) * by); });
        to.velocity = make_vec<N>([&](int i) { return as_stored(as_stored(from.velocity[i]) * speed); });
        to.radius = as_stored(as_stored(from.radius) * by);
    };
    if constexpr (is_flight<B>) {
        put(r.a.state, a.state);
        put(r.b.state, b.state);
        if (up - faster < -1022 || up - faster > 1023) {
            return r;
        }
        const double later = power_of_two(up - faster);
        r.a.since = as_stored(as_stored(a.since) * later);
        r.b.since = as_stored(as_stored(b.since) * later);
        // Instants that overflow, also to the largest double, are no longer apart.
        if (!(std::max(std::fabs(r.a.since), std::fabs(r.b.since)) < 0x1p1000)) {
            return r;
        }
        r.safe = !is_subnormal(a.since) && !is_subnormal(b.since); // `later` may make it as large as a length
    } else {
        put(r.a, a);
        put(r.b, b);
        r.safe = true;
    }
    r.length = -up;
    r.velocity = -faster;
    r.known = true;
    r.safe = r.safe && std::min(length, velocity) > 0x1p-900;
    return r;
}

} // namespace graze::inline v0_1::detail
