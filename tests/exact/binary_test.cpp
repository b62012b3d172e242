// Numbers as significand and exponent, and lifted to a common scale, exactly.
#include "../machine/wide_values.hpp"

#include <graze/exact/binary.hpp>
#include <graze/exact/integer.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace {

template <class T>
mpq_class exact(T x) {
    if constexpr (std::is_floating_point_v<T>) {
        return mpq_class(static_cast<double>(x));
    } else {
        return mpq_class(wide::from_signed(x));
    }
}
mpq_class power(int exponent) {
    const mpz_class p = wide::power(std::abs(exponent));
    return exponent < 0 ? mpq_class(1, p) : mpq_class(p);
}

template <class T>
void check_number(T x) {
    const graze::detail::binary b = graze::detail::to_binary(x);
    PROPERTY_ASSERT(wide::from_signed(b.significand) * power(b.exponent) == exact(x));
    PROPERTY_ASSERT((b.significand % 2 != 0) == (x != 0));
    PROPERTY_ASSERT(graze::detail::is_finite_input(x));
}

// Any finite number of T: random bits, an end of the range, or small.
template <class T>
T any_number() {
    using limits = std::numeric_limits<T>;
    switch (property::in_range(0, 4)) {
    case 0:
        return property::one_of(limits::max(), limits::lowest(), limits::min(), limits::denorm_min(), T(0), T(1));
    case 1:
        return static_cast<T>(property::in_range(-100, 101));
    default:
        if constexpr (std::is_floating_point_v<T>) {
            using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
            const T x = std::bit_cast<T>(property::any<bits>());
            return std::isfinite(x) ? x : T(0);
        } else {
            return property::any<T>();
        }
    }
}

template <class T>
void check_lifted() {
    std::array<T, 5> values{};
    for (T& x : values) {
        x = any_number<T>();
    }
    graze::detail::lifted<5> group;
    graze::detail::lift(group, values.data());
    graze::detail::workspace_of<10> room;
    group.room = &room;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const mpq_class whole = exact(values[i]) / power(group.exponent);
        PROPERTY_ASSERT(whole.get_den() == 1);
        PROPERTY_ASSERT(abs(whole.get_num()) < wide::power(group.width) || whole == 0);
        PROPERTY_ASSERT(group.width <= 2098);
        PROPERTY_ASSERT(wide::value(group.template get<graze::detail::big_integer>(i)) == whole.get_num());
        PROPERTY_ASSERT(wide::value(group.template get<graze::integer<2098>>(i)) == whole.get_num());
    }
}

// Two groups lifted to one scale keep their values.
void check_aligned() {
    std::array<double, 3> x{};
    std::array<double, 2> y{};
    for (double& v : x) {
        v = any_number<double>();
    }
    for (double& v : y) {
        v = any_number<double>();
    }
    x[0] = x[0] == 0 ? 1 : x[0];
    y[0] = y[0] == 0 ? 1 : y[0];
    graze::detail::lifted<3> a;
    graze::detail::lifted<2> b;
    graze::detail::lift(a, x.data());
    graze::detail::lift(b, y.data());
    graze::detail::align(a, b);
    PROPERTY_ASSERT(a.exponent == b.exponent);
    PROPERTY_ASSERT(a.width == b.width);
    PROPERTY_ASSERT(a.width <= 2098);
    graze::detail::workspace_of<10> room;
    a.room = b.room = &room;
    const auto check = [](const auto& group, const auto& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const mpz_class whole = wide::value(group.template get<graze::detail::big_integer>(i));
            PROPERTY_ASSERT(whole * power(group.exponent) == exact(values[i]));
        }
    };
    check(a, x);
    check(b, y);
}

using limits = std::numeric_limits<double>;
static_assert(graze::detail::to_binary(-0.0).significand == 0);
static_assert(graze::detail::to_binary(limits::denorm_min()).exponent == -1074);
static_assert(graze::detail::to_binary(-1.5).significand == -3 && graze::detail::to_binary(-1.5).exponent == -1);
static_assert(graze::detail::to_binary(std::numeric_limits<std::int64_t>::min()).significand == -1);
static_assert(graze::detail::to_binary(std::numeric_limits<std::int64_t>::min()).exponent == 63);
static_assert(!graze::detail::is_finite_input(limits::infinity()) &&
              !graze::detail::is_finite_input(-limits::quiet_NaN()));
static_assert(!graze::detail::is_finite_input(std::numeric_limits<float>::signaling_NaN()));
static_assert(graze::detail::is_finite_input(limits::max()) && graze::detail::is_finite_input(limits::denorm_min()));

} // namespace

TEST_CASE("A number is significand 2^exponent") {
    CHECK(property::check([] { check_number(any_number<double>()); }));
    CHECK(property::check([] { check_number(any_number<float>()); }));
    CHECK(property::check([] { check_number(any_number<std::int32_t>()); }));
    CHECK(property::check([] { check_number(any_number<std::int64_t>()); }));
}

TEST_CASE("Every power of two is taken apart") {
    int wrong = 0;
    for (int e = -1074; e < 1024; ++e) {
        const graze::detail::binary b = graze::detail::to_binary(std::ldexp(-1.0, e));
        wrong += b.significand == -1 && b.exponent == e ? 0 : 1;
    }
    for (int e = -149; e < 128; ++e) {
        const graze::detail::binary b = graze::detail::to_binary(std::ldexp(1.0F, e));
        wrong += b.significand == 1 && b.exponent == e ? 0 : 1;
    }
    CHECK(wrong == 0);
}

TEST_CASE("Lifted numbers are integers of the width that is said") {
    CHECK(property::check([] { check_lifted<double>(); }));
    CHECK(property::check([] { check_lifted<float>(); }));
    CHECK(property::check([] { check_lifted<std::int32_t>(); }));
    CHECK(property::check([] { check_lifted<std::int64_t>(); }));
    CHECK(property::check([] { check_aligned(); }));
}

TEST_CASE("Zeros take no part in the scale, nor do bits that are zero in all") {
    const std::array<double, 3> values{0, 3 * 0x1p300, 0x1p301};
    graze::detail::lifted<3> group;
    graze::detail::lift(group, values.data());
    CHECK(group.exponent == 300);
    CHECK(group.width <= 4);
    const std::array<double, 2> zeros{0, -0.0};
    graze::detail::lifted<2> none;
    graze::detail::lift(none, zeros.data());
    CHECK(none.width == 0);
    CHECK(none.get<graze::integer<61>>(1).sign() == 0);
}
