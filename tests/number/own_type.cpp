// A user's number type in a namespace that has functions of the same names: the formulas must not call those.
#include <graze/graze.hpp>

#include <doctest/doctest.h>

#include <compare>

namespace user {

struct metres {
    double value = 0;
    metres() = default;
    explicit metres(int x) : value(x) {}
    explicit metres(double x) : value(x) {}
    friend metres operator-(metres x) { return metres(-x.value); }
    friend metres operator+(metres x, metres y) { return metres(x.value + y.value); }
    friend metres operator-(metres x, metres y) { return metres(x.value - y.value); }
    friend metres operator*(metres x, metres y) { return metres(x.value * y.value); }
    friend metres operator/(metres x, metres y) { return metres(x.value / y.value); }
    friend auto operator<=>(metres, metres) = default;
};

// These are not what graze means by the names.
inline bool sign(metres x) { return x.value < 0; }
inline metres twice(metres) { return metres(-1); }
inline metres square_root(metres) { return metres(-1); }
inline metres root(metres) { return metres(-1); }

} // namespace user

template <>
struct graze::number_traits<user::metres> {
    static constexpr const char* name = "metres";
    static constexpr bool is_exact = false;
    static constexpr int digits = 53;
    static user::metres sqrt(user::metres x) { return user::metres(number_traits<double>::sqrt(x.value)); }
};

template <class T>
static graze::vec<3, T> point(double x, double y, double z) {
    return {{T(x), T(y), T(z)}};
}

// T's results, as doubles.
template <class T, class F>
static void check_same(const graze::vec<3, T>& x, const graze::vec<3, double>& y, F value) {
    for (int i = 0; i < 3; ++i) {
        CHECK(value(x[i]) == y[i]);
    }
}

template <class T>
static auto balls() {
    const graze::ball<3, T> a{point<T>(0, 0.5, 0.1), point<T>(3, 0, 0), T(1), T(2)};
    const graze::ball<3, T> b{point<T>(7, 0, 0), point<T>(-1, 0.1, 0), T(1), T(5)};
    return graze::solve(a, b);
}
template <class T>
static auto plane() {
    return graze::solve(graze::ball<3, T>{point<T>(0, 0, -9), point<T>(1, 0, 2), T(1)},
                        graze::plane<3, T>{point<T>(0, 0, 0), point<T>(0, 0.2, 1)});
}
template <class T>
static auto wall(double x) {
    return graze::solve(graze::ball<3, T>{point<T>(x, 0.3, 9), point<T>(0, 0.01, -2), T(1)},
                        graze::wall<3, T>{point<T>(0, 0, 0), {point<T>(2, 0.3, 0), point<T>(0, 2, 0)}});
}

TEST_CASE("functions of a user's namespace don't replace the library's") {
    using user::metres;
    const auto value = [](metres x) { return x.value; };
    {
        const auto x = balls<metres>();
        const auto y = balls<double>();
        REQUIRE(y.what == graze::encounter::hit);
        CHECK(x.what == y.what);
        CHECK(x.time.value == y.time);
        check_same(x.normal, y.normal, value);
        check_same(x.velocity_a, y.velocity_a, value);
    }
    {
        const auto x = plane<metres>();
        const auto y = plane<double>();
        REQUIRE(y.what == graze::encounter::hit);
        CHECK(x.what == y.what);
        CHECK(x.time.value == y.time);
        check_same(x.normal, y.normal, value);
        check_same(x.velocity, y.velocity, value);
    }
    for (const double at : {1.0, -0.5, 2.9, 3.5}) {
        const auto x = wall<metres>(at);
        const auto y = wall<double>(at);
        CHECK(x.what == y.what);
        CHECK(x.where == y.where);
        CHECK(x.index == y.index);
        CHECK(x.time.value == y.time);
        check_same(x.point, y.point, value);
        check_same(x.velocity, y.velocity, value);
    }
}
