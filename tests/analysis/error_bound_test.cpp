// The derived constants: by hand, and as bounds of the errors that a search for the worst inputs finds in doubles.
#include <graze/analysis/error_bound.hpp>
#include <graze/filter/static_filter.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/number/adapter/gmp.hpp>
#include <graze/number/floating.hpp>
#include <graze/pair/computed_motion.hpp>
#include <graze/pair/flat_signs.hpp>

#include "../../examples/families/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cfenv>
#include <cmath>
#include <string>
#include <type_traits>

namespace {

using graze::error_bound;
using exact = graze::gmp_rational;

template <class F>
concept constant = requires {
    typename std::bool_constant<(F{}().error >= 0)>;
};

constexpr error_bound length = error_bound::exact_input({1, 0, 0});
constexpr error_bound speed = error_bound::exact_input({0, 1, 0});
constexpr error_bound rounded_length = error_bound::rounded_input({1, 0, 0});
using same_degree = decltype([] { return length + length; });
using other_degree = decltype([] { return length + speed; });
using other_product = decltype([] { return length * length - length * speed; });
static_assert(constant<same_degree> && !constant<other_degree> && !constant<other_product>);

// Whether a formula's error is this multiple of u; what is left over are terms in u².
bool is_nearly(const error_bound& b, double units) { return b.error >= units && b.error < units * (1 + 0x1p-45); }

// A ball's motion in 3D from exact and from rounded differences.
template <int N>
constexpr auto motion(error_bound::degrees l, error_bound::degrees v, bool rounded) {
    const auto input = [rounded](error_bound::degrees d) {
        return rounded ? error_bound::rounded_input(d) : error_bound::exact_input(d);
    };
    return graze::relative_motion{graze::bounded_vector<N>(input(l)), graze::bounded_vector<N>(input(v)), input(l)};
}

struct halved {
    template <class M>
    constexpr auto operator()(const M& m) const {
        return graze::discriminant_halved{}(graze::quadratic_of(m));
    }
};

} // namespace

TEST_CASE("The calculus by hand, in units u") {
    CHECK(is_nearly(length + length, 2)); // one rounding of 2
    CHECK(is_nearly(rounded_length + rounded_length, 1 + 1 + 2));
    CHECK(is_nearly(length * speed, 1));
    CHECK(is_nearly(rounded_length * rounded_length, 1 + 1 + 1));
    CHECK((length * speed).degree == error_bound::degrees{1, 1, 0});
    CHECK((length * speed).magnitude >= 1);
    CHECK((length + length).magnitude >= 2);
    CHECK((length - length).error == (length + length).error);               // signs are not known
    CHECK(graze::twice(length * speed).error == 2 * (length * speed).error); // exact
    CHECK_THROWS_AS((void)(length + speed), std::logic_error);
    CHECK_THROWS_AS((void)(length * speed - length), std::logic_error);
}

TEST_CASE("The formulas of two balls by hand") {
    const auto sharp = motion<3>({1, 0, 0}, {0, 1, 0}, false);
    const auto rough = motion<3>({1, 0, 0}, {0, 1, 0}, true);
    // An inner product in space has three roundings of its own, and one from each factor.
    CHECK(is_nearly(graze::coefficient_h{}(sharp), 3));
    CHECK(is_nearly(graze::coefficient_h{}(rough), 3 + 1 + 1));
    CHECK(is_nearly(graze::coefficient_h{}(motion<2>({1, 0, 0}, {0, 1, 0}, true)), 2 + 1 + 1));
    // c: |Δx|² as h, R² 3, their difference rounds 2.
    CHECK(is_nearly(graze::coefficient_c{}(sharp), 3 + 1 + 2));
    CHECK(is_nearly(graze::coefficient_c{}(rough), 5 + 3 + 2));
    // D: h² twice h's and one more, ac twice a's (c may be 2) and c's and two more, and their difference rounds 3.
    CHECK(is_nearly(halved{}(sharp), (2 * 3 + 1) + (2 * 3 + 6 + 2) + 3));
    CHECK(is_nearly(halved{}(rough), (2 * 5 + 1) + (2 * 5 + 10 + 2) + 3));
    CHECK(halved{}(rough).degree == error_bound::degrees{2, 2, 0});
    CHECK(graze::discriminant_lagrange{}(rough).error < halved{}(rough).error);
}

namespace {

constexpr std::array modes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

template <int N>
double norm(const graze::vec<N, double>& x) { // from above
    mpq_class sum;
    for (int i = 0; i < N; ++i) {
        sum += mpq_class(x[i]) * mpq_class(x[i]);
    }
    return std::sqrt(sum.get_d()) * (1 + 0x1p-50);
}

// The numbers that a motion is made of; the motion in T (in doubles with rounded differences, as the predicates take
// it) and as the formula takes it; and the scales, which bound the norm of each of its vectors.
template <int N>
struct ball_inputs {
    static constexpr std::size_t count = 4 * static_cast<std::size_t>(N) + 2;
    using bounds = graze::detail::ball_bounds<N, double>;

    template <class T, class I>
    static auto make(const I& x) {
        const auto vector = [&](std::size_t from) {
            return graze::make_vec<N>([&](int i) { return T(x[from + static_cast<std::size_t>(i)]); });
        };
        return graze::relative_motion_of(graze::ball<N, T>{vector(0), vector(N), T(x[4 * N])},
                                         graze::ball<N, T>{vector(2 * N), vector(3 * N), T(x[4 * N + 1])});
    }
    template <class M>
    static const M& seen(const M& m) {
        return m;
    }
    template <class M>
    static std::array<double, 3> scales(const M& m) {
        return {std::max(norm(m.dx), std::fabs(m.R)), norm(m.du), 1};
    }
};

// A ball and a plane, or a ball and a wall's way, place and border as flat_bounds makes them.
template <int N>
struct plane_inputs {
    static constexpr std::size_t n = N;
    static constexpr std::size_t count = 4 * n + 1;
    using bounds = graze::detail::plane_bounds<N, double>;

    template <class T, class I>
    static auto make(const I& x) {
        const auto vector = [&](std::size_t from) {
            return graze::make_vec<N>([&](int i) { return T(x[from + static_cast<std::size_t>(i)]); });
        };
        return graze::relative_motion_of(graze::ball<N, T>{vector(0), vector(n), T(x[count - 1])},
                                         graze::plane<N, T>{vector(2 * n), vector(3 * n)});
    }
    template <class M>
    static const M& seen(const M& m) {
        return m;
    }
    template <class M>
    static std::array<double, 3> scales(const M& m) {
        return {std::max(norm(m.w), m.r), norm(m.u), norm(m.n)};
    }
};

// How a formula's numbers and their bounds are made from a motion.
struct as_way {
    template <class M>
    static auto seen(const M& m) {
        return way_of(m);
    }
    template <class B>
    static consteval auto bounds() {
        return B::way();
    }
};
struct as_place {
    template <class M>
    static auto seen(const M& m) {
        return place_of(m, way_of(m));
    }
    template <class B>
    static consteval auto bounds() {
        return B::place();
    }
};
struct as_border { // of a triangle, the third
    template <int N, class T>
    static auto seen(const graze::flat_motion<N, T>& m) {
        const auto way = way_of(m);
        return edge_of(centre_from(m, 1), m.u, direction_of_border(m, 1), m.r,
                       graze::inside_border{1, m.is_triangle}(way), graze::inward_speed{1, m.is_triangle}(way),
                       way.speed);
    }
    template <class B>
    static consteval auto bounds() {
        return B::border();
    }
};
struct as_corner { // of a triangle, the second, along its third border
    template <int N, class T>
    static auto seen(const graze::flat_motion<N, T>& m) {
        return corner_of(centre_from(m, 1), m.u, direction_of_border(m, 1), m.r, way_of(m).speed);
    }
    template <class B>
    static consteval auto bounds() {
        return B::border();
    }
};
template <int N, class As>
struct flat_inputs {
    static constexpr std::size_t n = N;
    static constexpr std::size_t count = n * (n + 2) + 1;
    struct bounds {
        static consteval auto value() { return As::template bounds<graze::detail::flat_bounds<N, double>>(); }
    };

    template <class T, class I>
    static auto make(const I& x) {
        const auto vector = [&](std::size_t from) {
            return graze::make_vec<N>([&](int i) { return T(x[from + static_cast<std::size_t>(i)]); });
        };
        graze::flat_motion<N, T> m{vector(0) - vector(2 * n), vector(n), {}, T(x[count - 1]), N == 3};
        for (std::size_t e = 0; e + 1 < n; ++e) {
            m.e[e] = vector((3 + e) * n);
        }
        return m;
    }
    template <class M>
    static auto seen(const M& m) {
        return As::seen(m);
    }
    template <class M>
    static std::array<double, 3> scales(const M& m) {
        double sum = 0;
        for (const auto& e : m.e) {
            sum += norm(e);
        }
        return {norm(m.w) + m.r + sum, norm(m.u), sum};
    }
};

double power(double x, int n) { return n == 0 ? 1.0 : x * power(x, n - 1); }

// The error |computed - exact| of F as a share of its bound, on these inputs and in this rounding mode.
template <class Inputs, class F, class I>
double share_of_bound(const I& x, int mode) {
    constexpr double k = graze::filter_constant(F{}, Inputs::bounds::value());
    constexpr error_bound::degrees d = graze::filter_degrees(F{}, Inputs::bounds::value());
    std::fesetround(mode);
    const auto rounded = Inputs::template make<double>(x);
    const double computed = F{}(Inputs::seen(rounded));
    std::fesetround(FE_TONEAREST);
    const mpq_class truth = F{}(Inputs::seen(Inputs::template make<exact>(x))).value();
    const auto scale = Inputs::scales(rounded);
    const double bound = k * power(scale[0], d[0]) * power(scale[1], d[1]) * power(scale[2], d[2]);
    return mpq_class(abs(mpq_class(computed) - truth)).get_d() / bound;
}

// Of magnitude in [1, 2), with 53 random bits. One in four is next to a power of two, where roundings are extreme.
double random_double(families::random& r) {
    const std::uint64_t fraction = r.one_in(4) ? r.below(4) : r.next() >> 12U;
    const double x = std::bit_cast<double>(std::uint64_t{1023} << 52U | fraction);
    return r.one_in(2) ? x : -x;
}

// The largest share that a search finds: it starts at random and keeps changes of one number that raise the share.
template <class Inputs, class F>
double worst_share(int mode) {
    families::random r(static_cast<std::uint64_t>(mode) + 17);
    double worst = 0;
    for (int start = 0; start < 12; ++start) {
        std::array<double, Inputs::count> x{};
        for (double& component : x) {
            component = random_double(r);
        }
        x.back() = std::fabs(x.back());
        double share = share_of_bound<Inputs, F>(x, mode);
        for (int step = 0; step < 60; ++step) {
            auto y = x;
            double& changed = y[r.below(y.size())];
            changed = r.one_in(3) ? changed * (r.one_in(2) ? 0.5 : 2.0) : random_double(r);
            y.back() = std::fabs(y.back());
            if (const double other = share_of_bound<Inputs, F>(y, mode); other > share) {
                share = other;
                x = y;
            }
        }
        worst = std::max(worst, share);
    }
    return worst;
}

// No share exceeds 1, and the largest exceeds `least`: so the bound is at most 1/least times as large as necessary. If
// least is a half or more, half of the constant would fail.
template <class Inputs, class F>
void check_bound(const std::string& name, double least) {
    double worst = 0;
    for (const int mode : modes) {
        const double share = worst_share<Inputs, F>(mode);
        worst = std::max(worst, share);
        CHECK_MESSAGE(share <= 1, name);
    }
    CHECK_MESSAGE(worst > least, name);
    MESSAGE(name << ": of its bound, the worst error found is " << worst);
}

// (r_a + r_b)² is off by 3u of it.
struct square_of_radii {
    template <class M>
    constexpr auto operator()(const M& m) const {
        return m.R * m.R;
    }
};

} // namespace

TEST_CASE("No error found in doubles is larger than its bound, in any rounding mode") {
    using ball2 = ball_inputs<2>;
    using ball3 = ball_inputs<3>;
    check_bound<ball2, graze::coefficient_h>("h, 2D", 0.5);
    check_bound<ball3, graze::coefficient_h>("h, 3D", 0.5);
    check_bound<ball3, graze::coefficient_c>("c, 3D", 0.2);
    check_bound<ball2, halved>("D halved, 2D", 0.1);
    check_bound<ball3, halved>("D halved, 3D", 0.1);
    check_bound<ball2, graze::discriminant_lagrange>("D by Lagrange, 2D", 0.12);
    check_bound<ball3, graze::discriminant_lagrange>("D by Lagrange, 3D", 0.12);

    check_bound<plane_inputs<2>, graze::plane_height>("a plane's height, 2D", 0.35);
    check_bound<plane_inputs<3>, graze::plane_height>("a plane's height, 3D", 0.3);
    check_bound<plane_inputs<3>, graze::plane_clearance>("a plane's clearance", 0.15);

    using way2 = flat_inputs<2, as_way>;
    using way3 = flat_inputs<3, as_way>;
    using border = flat_inputs<3, as_border>;
    using corner = flat_inputs<3, as_corner>;
    check_bound<way2, graze::way_height>("a segment's height", 0.1);
    check_bound<way2, graze::inside_border>("a segment's side", 0.09);
    check_bound<way2, graze::touch_inside_norm>("a segment's foot", 0.03);
    check_bound<way3, graze::way_height>("a wall's height", 0.015);
    check_bound<way3, graze::way_clearance>("a wall's clearance", 0.0015);
    check_bound<way3, graze::inside_border>("a triangle's side", 0.02);
    check_bound<way3, graze::touch_inside_norm>("a triangle's foot", 0.00009);
    check_bound<flat_inputs<3, as_place>, graze::inside_border>("a triangle's side now", 0.003);
    check_bound<border, graze::border_h>("an edge's h", 0.04);
    check_bound<border, graze::border_c>("an edge's c", 0.035);
    check_bound<border, graze::border_discriminant>("an edge's D", 0.003);
    check_bound<corner, graze::corner_discriminant>("a corner's D", 0.04);
    check_bound<border, graze::nearest_from_start>("a foot along an edge", 0.06);
    check_bound<border, graze::touch_along_norm<graze::nearest_from_end>>("a touch along an edge", 0.003);
    check_bound<border, graze::touch_outside_norm>("a touch beside an edge", 0.000006);
    check_bound<corner, graze::touch_behind_norm>("a touch behind a corner", 0.014);
}

TEST_CASE("A constant of half the size would be found out") {
    // Both roundings may be nearly u each, and the first one counts twice.
    using ball2 = ball_inputs<2>;
    double worst = 0;
    families::random r(1);
    for (int i = 0; i < 20000; ++i) {
        std::array<double, ball2::count> x{};
        x[8] = 1 + static_cast<double>(r.below(1U << 10U)) * 0x1p-52;
        x[9] = static_cast<double>(r.below(1U << 10U) + 1) * 0x1p-62;
        for (const int mode : modes) {
            worst = std::max(worst, share_of_bound<ball2, square_of_radii>(x, mode));
        }
    }
    CHECK(worst <= 1);
    CHECK(worst > 0.5);
    MESSAGE("of its bound, the worst error of R² found is " << worst);
}
