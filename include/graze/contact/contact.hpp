// Where and how things leave when they meet.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/exact/rounding.hpp>
#include <graze/formula/wall_encounter.hpp>
#include <graze/linear/vec.hpp>
#include <graze/machine/fence.hpp>

namespace graze::inline v0_1 {

// The contact of two balls, each component the exact value rounded once, to nearest with ties to even. time: from the
// instant at which the positions are given, τ >= 0. position_a, position_b: the centres then. normal: the unit vector
// from b to a; zero when two points meet. velocity_a, velocity_b: after the impact; for a graze, and for a ball of
// infinite mass, unchanged, bit for bit. An exact zero is +0; a value that rounds beyond the largest T is an infinity.
template <int N, class T = double>
struct contact {
    T time{};
    vec<N, T> position_a{}, position_b{};
    vec<N, T> normal{};
    vec<N, T> velocity_a{}, velocity_b{};

    [[nodiscard]] friend constexpr bool operator==(const contact&, const contact&) = default;
};

// The contact of a ball and a plane, a wall or a triangle, rounded alike. position: the centre then. point: where the
// plane or wall is touched; for an overlap its point nearest to the centre. normal: the unit vector from there to the
// ball; zero when a point grazes a border. feature, index: which feature of the wall or triangle is met, as in
// wall_encounter; for a plane always the face.
template <int N, class T = double>
struct wall_contact {
    T time{};
    vec<N, T> position{}, point{};
    vec<N, T> normal{};
    vec<N, T> velocity{};
    graze::feature feature = graze::feature::face;
    int index = 0;

    [[nodiscard]] friend constexpr bool operator==(const wall_contact&, const wall_contact&) = default;
};

namespace detail {

// A contact of zeros. Where the compiler sees that they are zeros it clears them by an instruction that takes longer
// than storing each.
template <int N, class T>
struct zero_contact {
    [[nodiscard, gnu::always_inline]] constexpr operator contact<N, T>() const noexcept { // NOLINT
        const T zero = settled(T(0));
        const auto zeros = make_vec<N>([&](int) { return zero; });
        return {zero, zeros, zeros, zeros, zeros, zeros};
    }
};

// x, with a zero as +0: by its bits, since with -fno-signed-zeros x + 0 and x == 0 ? 0 : x are x.
template <class T>
[[nodiscard]] constexpr T with_plain_zero(const T& x) noexcept {
    return from_bits<T>(is_zero(x) ? 0 : bits_of(x), false);
}
template <int N, class T>
[[nodiscard]] constexpr vec<N, T> with_plain_zeros(const vec<N, T>& x) noexcept {
    return make_vec<N>([&](int i) { return with_plain_zero(x[i]); });
}

} // namespace detail
} // namespace graze::inline v0_1
