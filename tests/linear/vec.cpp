#include "../property.hpp"

#include <graze/linear/vec.hpp>
#include <graze/number/adapter/gmp.hpp>
#include <graze/number/floating.hpp>

#include <doctest/doctest.h>

#include <type_traits>

using graze::vec;
using number = graze::gmp_rational;

static_assert(std::is_aggregate_v<vec<2, double>> && sizeof(vec<3, double>) == 3 * sizeof(double));
static_assert(vec<2, double>{{1, 2}} + vec<2, double>{{3, 4}} == vec<2, double>{{4, 6}});
static_assert(vec<3, double>{{1, 2, 3}} - vec<3, double>{{3, 2, 1}} == vec<3, double>{{-2, 0, 2}});
static_assert(-vec<2, double>{{1, -2}} == vec<2, double>{{-1, 2}});
static_assert(2.0 * vec<2, double>{{1, 2}} == vec<2, double>{{2, 4}});
static_assert(vec<2, double>{{1, 2}} / 2.0 == vec<2, double>{{0.5, 1}});
static_assert(!(vec<3, double>{{1, 2, 3}} == vec<3, double>{{1, 2, 4}}));
static_assert(dot(vec<2, double>{{1, 2}}, vec<2, double>{{3, 4}}) == 11);
static_assert(dot(vec<3, double>{{1, 2, 3}}, vec<3, double>{{4, 5, 6}}) == 32);
static_assert(cross(vec<2, double>{{1, 2}}, vec<2, double>{{3, 4}}) == -2);
static_assert(cross(vec<3, double>{{1, 0, 0}}, vec<3, double>{{0, 1, 0}}) == vec<3, double>{{0, 0, 1}});
static_assert(cross(vec<3, double>{{0, 1, 0}}, vec<3, double>{{0, 0, 1}}) == vec<3, double>{{1, 0, 0}});
static_assert(cross(vec<3, double>{{0, 0, 1}}, vec<3, double>{{1, 0, 0}}) == vec<3, double>{{0, 1, 0}});
static_assert(graze::squared_norm(vec<3, double>{{1, 2, 3}}) == 14 && graze::squared_norm(3.0) == 9);
static_assert(vec<2, double>{{1, 2}}.x() == 1 && vec<2, double>{{1, 2}}.y() == 2 && vec<3, double>{{1, 2, 3}}.z() == 3);
template <class V>
concept has_z = requires(V x) {
    x.z();
};
static_assert(has_z<vec<3, double>> && !has_z<vec<2, double>>);
static_assert(graze::make_vec<3>([](int i) { return i * 1.0; }) == vec<3, double>{{0, 1, 2}});

// Components of different types combine.
static_assert(std::is_same_v<decltype(vec<2, float>{} + vec<2, double>{}), vec<2, double>>);
static_assert(std::is_same_v<decltype(dot(vec<3, float>{}, vec<3, double>{})), double>);

template <int N>
static vec<N, number> draw() {
    return graze::make_vec<N>([](int) { return number(property::in_range(-100, 101)); });
}

TEST_CASE("identities of the products") {
    CHECK(property::check("Lagrange's in the plane and in space", [] {
        const auto x = draw<2>(), y = draw<2>();
        PROPERTY_ASSERT(squared_norm(cross(x, y)) == squared_norm(x) * squared_norm(y) - dot(x, y) * dot(x, y));
        const auto v = draw<3>(), w = draw<3>();
        PROPERTY_ASSERT(squared_norm(cross(v, w)) == squared_norm(v) * squared_norm(w) - dot(v, w) * dot(v, w));
    }));
    CHECK(property::check("x × y is perpendicular to both and turns with them", [] {
        const auto x = draw<3>(), y = draw<3>(), z = draw<3>();
        PROPERTY_ASSERT(graze::sign(dot(cross(x, y), x)) == 0);
        PROPERTY_ASSERT(graze::sign(dot(cross(x, y), y)) == 0);
        PROPERTY_ASSERT(cross(x, y) == -cross(y, x));
        PROPERTY_ASSERT(dot(cross(x, y), z) == dot(cross(y, z), x));
        PROPERTY_ASSERT(cross(x, cross(y, z)) == dot(x, z) * y - dot(x, y) * z);
    }));
    CHECK(property::check("products are linear", [] {
        const auto x = draw<3>(), y = draw<3>(), z = draw<3>();
        const number s(property::in_range(1, 100));
        PROPERTY_ASSERT(dot(x + y, z) == dot(x, z) + dot(y, z));
        PROPERTY_ASSERT(cross(s * x - y, z) == s * cross(x, z) - cross(y, z));
        PROPERTY_ASSERT((s * x) / s == x);
    }));
}
