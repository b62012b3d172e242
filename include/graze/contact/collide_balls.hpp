// When, where and how two balls meet and leave, every number correctly rounded.
#pragma once

#include <graze/contact/exact_balls.hpp>
#include <graze/predicate/classify_balls.hpp>

#include <concepts>
#include <optional>

namespace graze {

namespace detail {

// Two balls' row with their masses, which have a scale of their own.
template <int N>
struct two_massive_balls {
    struct inputs {
        decltype(lift_row<two_balls<N>>(std::array<double, two_balls<N>::lengths + two_balls<N>::velocities>{})) pair;
        lifted<2> mass;

        [[nodiscard]] constexpr int width() const noexcept { return std::max(pair.width(), mass.width); }
    };

    template <class I>
    [[nodiscard]] static constexpr auto motion(const inputs& in) noexcept {
        const auto vector = [](const auto& group, std::size_t from) {
            return make_vec<N>([&](int i) { return group.template get<I>(from + static_cast<std::size_t>(i)); });
        };
        const auto relative = two_balls<N>::template motion<I>(in.pair);
        return exact_balls<N, I, std::remove_cvref_t<decltype(relative)>>{relative,
                                                                          vector(in.pair.length, 0),
                                                                          vector(in.pair.length, N),
                                                                          vector(in.pair.velocity, 0),
                                                                          vector(in.pair.velocity, N),
                                                                          in.mass.template get<I>(0),
                                                                          in.mass.template get<I>(1)};
    }
};

// By the bits: whether x is positive and finite.
[[nodiscard]] constexpr bool is_plain_mass(const double& x) noexcept {
    return bits_of(x) - 1 < 0x7ff0000000000000U - 1;
}
[[nodiscard]] constexpr bool is_plain_mass(const float& x) noexcept { return bits_of(x) - 1 < 0x7f800000U - 1; }

// Whether x is +∞, by its bits.
[[nodiscard]] constexpr bool is_infinite_mass(const double& x) noexcept { return bits_of(x) == 0x7ff0000000000000U; }
[[nodiscard]] constexpr bool is_infinite_mass(const float& x) noexcept { return bits_of(x) == 0x7f800000U; }

template <class T>
constexpr void check_masses(const T& a, const T& b) {
    if (is_plain_mass(a) && is_plain_mass(b)) [[likely]] {
        return;
    }
    if (!is_plain_mass(a) && !is_infinite_mass(a)) {
        reject("ball a", "mass is not positive");
    }
    if (!is_plain_mass(b) && !is_infinite_mass(b)) {
        reject("ball b", "mass is not positive");
    }
    if (is_infinite_mass(a) && is_infinite_mass(b)) {
        reject("ball b", "mass is infinite, as that of ball a is");
    }
}

// Rounds the wanted components of the contact of two balls that meet, by integers.
template <int N, class T>
[[gnu::noinline]] constexpr void complete(contact<N, T>& c, parts wanted, encounter what, const ball<N, T>& a,
                                          const ball<N, T>& b) {
    typename two_massive_balls<N>::inputs in{lift_row<two_balls<N>>(packed<two_balls<N>>(a, b)), {}};
    const bool heavy_a = is_infinite_mass(a.mass);
    const bool heavy_b = is_infinite_mass(b.mass);
    const T masses[2] = {heavy_a ? T(1) : heavy_b ? T(0) : a.mass, heavy_b ? T(1) : heavy_a ? T(0) : b.mass};
    lift(in.mass, masses);
    const scales s{in.pair.length.exponent, in.pair.velocity.exponent};
    with_exact_motion<two_massive_balls<N>>(in, [&](const auto& e) { round_balls(c, wanted, what, e, s); });
}

} // namespace detail

// The contact of two balls, every component correctly rounded; empty for recede and miss. Throws as classify does, and
// when a mass is not positive or both are infinite. The observer is told `exact` if integers were needed for the
// decision or any component.
template <int N, std::floating_point T, class Observer = ignore_stage>
requires is_binary_input<T>
[[nodiscard]] constexpr std::optional<contact<N, T>> collide(const ball<N, T>& a, const ball<N, T>& b,
                                                             Observer&& observer = {}) {
    auto decided_by = stage::filter;
    const encounter what = classify(a, b, [&](stage s) { decided_by = s; });
    detail::check_masses(a.mass, b.mass);
    if (!is_collision(what)) {
        observer(decided_by);
        return std::nullopt;
    }
    std::optional<contact<N, T>> c(std::in_place);
    c->velocity_a = a.velocity;
    c->velocity_b = b.velocity;
    if (what == encounter::overlap) {
        c->position_a = detail::with_plain_zeros(a.position);
        c->position_b = detail::with_plain_zeros(b.position);
    }
    detail::complete(*c, detail::all_parts, what, a, b);
    observer(stage::exact);
    return c;
}

} // namespace graze
