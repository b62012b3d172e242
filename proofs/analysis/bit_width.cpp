// For every formula of a decision, bit_width says how many bits the integers' types have.
#include <graze/exact/integer.hpp>
#include <graze/formula/exact_in.hpp>
#include <graze/formula/wall_features.hpp>
#include <graze/number/floating.hpp>

#include <cstdint>
#include <type_traits>

namespace {

using namespace graze;

// Motions of inputs with L-bit lengths, V-bit velocities and E-bit normals: in integers, and in bit widths.
template <int N, class X, class U>
constexpr auto balls(const X& x, const U& u) {
    const auto vector = [](const auto& c) { return make_vec<N>([&](int) { return c; }); };
    return relative_motion{vector(x) - vector(x), vector(u) - vector(u), x + x};
}
template <int N, class X, class U, class E>
constexpr auto ball_and_plane(const X& x, const U& u, const E& n) {
    const auto vector = [](const auto& c) { return make_vec<N>([&](int) { return c; }); };
    return plane_motion{vector(x) - vector(x), vector(u), vector(n), x};
}
template <int N, class X, class U>
constexpr auto ball_and_wall(const X& x, const U& u) {
    const auto vector = [](const auto& c) { return make_vec<N>([&](int) { return c; }); };
    std::array<vec<N, X>, N - 1> e{};
    for (auto& one : e) {
        one = vector(x);
    }
    return wall_motion_of(vector(x) - vector(x), vector(u), e, x);
}

// Only the types matter; nothing is evaluated.
template <class F, class I, class W>
constexpr bool same_bits(const I&, const W& widths) {
    using result = std::remove_cvref_t<decltype(F{}(std::declval<const I&>()))>;
    return F{}(widths).bits == result::bits;
}

struct halved_of_motion {
    template <class M>
    constexpr auto operator()(const M& m) const {
        return discriminant_halved{}(quadratic_of(m));
    }
};
struct textbook_of_motion {
    template <class M>
    constexpr auto operator()(const M& m) const {
        return discriminant_textbook{}(quadratic_of(m));
    }
};

template <int N, int L, int V>
constexpr bool balls_agree() {
    const auto i = balls<N>(integer<L>(), integer<V>());
    const auto w = balls<N>(bit_width::of(L), bit_width::of(V));
    return same_bits<coefficient_a>(i, w) && same_bits<coefficient_h>(i, w) && same_bits<coefficient_c>(i, w) &&
           same_bits<halved_of_motion>(i, w) && same_bits<textbook_of_motion>(i, w) &&
           same_bits<discriminant_lagrange>(i, w);
}
static_assert(balls_agree<2, 1, 1>() && balls_agree<2, 24, 10>() && balls_agree<2, 53, 53>());
static_assert(balls_agree<3, 1, 1>() && balls_agree<3, 10, 24>() && balls_agree<3, 61, 61>());

template <int N, int L, int V, int E>
constexpr bool planes_agree() {
    const auto i = ball_and_plane<N>(integer<L>(), integer<V>(), integer<E>());
    const auto w = ball_and_plane<N>(bit_width::of(L), bit_width::of(V), bit_width::of(E));
    return same_bits<plane_height>(i, w) && same_bits<plane_speed>(i, w) && same_bits<plane_clearance>(i, w);
}
static_assert(planes_agree<2, 24, 10, 3>() && planes_agree<3, 53, 53, 53>());

template <int N, int L, int V>
constexpr bool walls_agree() {
    const auto i = ball_and_wall<N>(integer<L>(), integer<V>());
    const auto w = ball_and_wall<N>(bit_width::of(L), bit_width::of(V));
    if constexpr (N == 3) {
        if (!same_bits<edge_a>(i, w) || !same_bits<edge_h>(i, w) || !same_bits<edge_c>(i, w) ||
            !same_bits<edge_discriminant>(i, w)) {
            return false;
        }
    }
    return same_bits<plane_height>(face_of(i), face_of(w)) && same_bits<plane_clearance>(face_of(i), face_of(w));
}
static_assert(walls_agree<2, 20, 12>() && walls_agree<3, 20, 12>());

// W-bit inputs in space give a and h of 2W + 4 bits, c of one more, D of 4W + 10 and in Lagrange's form of 4W + 9.
static_assert(coefficient_a{}(balls<3>(bit_width::of(30), bit_width::of(30))).bits == 2 * 30 + 4);
static_assert(coefficient_h{}(balls<3>(bit_width::of(30), bit_width::of(30))).bits == 2 * 30 + 4);
static_assert(coefficient_c{}(balls<3>(bit_width::of(30), bit_width::of(30))).bits == 2 * 30 + 5);
static_assert(halved_of_motion{}(balls<3>(bit_width::of(30), bit_width::of(30))).bits == 4 * 30 + 10);
static_assert(discriminant_lagrange{}(balls<3>(bit_width::of(30), bit_width::of(30))).bits == 4 * 30 + 9);

// The width that classify uses for int32 coordinates.
static_assert(bits_to_decide<3, variant::halved>({31, 31}) == 134);

// The widths are attained: -1 and 1 at the ends of a 1-bit range differ by 2, which takes two bits.
static_assert((bit_width(1) - bit_width(-1)).bits == 2 && bit_width(0).bits == 0 && bit_width(-8).bits == 4);

// What machine types can hold.
static_assert(exact_bits<float>() == 24 && exact_bits<double>() == 53 && exact_bits<std::int32_t>() == 31 &&
              exact_bits<std::int64_t>() == 63 && exact_bits<integer<9>>() == std::numeric_limits<int>::max());
static_assert(exact_in<double>(coefficient_h{}, balls<2>(bit_width::of(26), bit_width::of(24))) &&
              !exact_in<double>(coefficient_h{}, balls<2>(bit_width::of(26), bit_width::of(25))));

// Each bit of a length or a velocity costs two bits of D; Lagrange's form is the narrowest.
static_assert(bits_to_decide<2>({13, 10}) == 53 && bits_to_decide<2>({14, 10}) == 55 &&
              bits_to_decide<2>({13, 11}) == 55 && bits_to_decide<2>({10, 13}) == 53);
static_assert(exact_in<double, 2>({13, 10}) && !exact_in<double, 2>({14, 10}) && exact_in<std::int64_t, 2>({14, 14}));
static_assert(!exact_in<double, 2, variant::halved>({13, 10}));
static_assert(bits_to_decide<3>({12, 10}) < bits_to_decide<3, variant::halved>({12, 10}) &&
              bits_to_decide<3, variant::halved>({12, 10}) < bits_to_decide<3, variant::textbook>({12, 10}));

} // namespace
