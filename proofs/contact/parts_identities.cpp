// What the steps of the contacts' fast path omit, apart from roundings. They run in polynomials, in which an error-free
// transform may round its value in any way. There each step is its equation, less a product of two low parts.
#include <graze/analysis/polynomial.hpp>
#include <graze/contact/lane_steps.hpp>

namespace identity {

using namespace graze;
using terms = polynomial<256>;

// A double that stands for a polynomial. Transforms give value = (a ∘ b)(1 + δ), δ a variable, and error = a ∘ b -
// value.
struct symbol {
    terms p;
    constexpr symbol(int x = 0) : p(x) {}
    constexpr symbol(const terms& x) : p(x) {}
    [[nodiscard]] friend constexpr bool operator==(const symbol&, const symbol&) = default;
    [[nodiscard]] friend constexpr symbol operator-(const symbol& x) { return -x.p; }
    [[nodiscard]] friend constexpr symbol operator+(const symbol& x, const symbol& y) { return x.p + y.p; }
    [[nodiscard]] friend constexpr symbol operator-(const symbol& x, const symbol& y) { return x.p - y.p; }
    [[nodiscard]] friend constexpr symbol operator*(const symbol& x, const symbol& y) { return x.p * y.p; }
    // A rounded quotient may be anything, so it is a variable of its own.
    [[nodiscard]] friend constexpr symbol operator/(int, const symbol&) { return terms::variable(14); }
};
struct symbols {
    symbol lane[2];
    [[nodiscard]] constexpr const symbol& operator[](int i) const { return lane[i]; }
    [[nodiscard]] friend constexpr symbols operator-(const symbols& x) { return {{-x[0], -x[1]}}; }
    [[nodiscard]] friend constexpr symbols operator+(const symbols& x, const symbols& y) {
        return {{x[0] + y[0], x[1] + y[1]}};
    }
    [[nodiscard]] friend constexpr symbols operator*(const symbols& x, const symbols& y) {
        return {{x[0] * y[0], x[1] * y[1]}};
    }
};

constexpr symbol settled(const symbol& x) { return x; }
constexpr symbols settled(const symbols& x) { return x; }
constexpr detail::halves<symbol> veltkamp_split(const symbol& x) { return {x, x}; }
constexpr detail::halves<symbols> veltkamp_split(const symbols& x) { return {x, x}; }

constexpr exact_pair<symbol> transformed(const symbol& exact) {
    const symbol value = exact * (symbol(1) + symbol(terms::variable(15)));
    return {value, exact - value};
}
constexpr exact_pair<symbols> side_by_side(const exact_pair<symbol>& x, const exact_pair<symbol>& y) {
    return {{{x.value, y.value}}, {{x.error, y.error}}};
}
constexpr exact_pair<symbol> two_sum(const symbol& x, const symbol& y) { return transformed(x + y); }
constexpr exact_pair<symbol> fast_two_sum(const symbol& x, const symbol& y) { return transformed(x + y); }
constexpr exact_pair<symbols> two_sum(const symbols& x, const symbols& y) {
    return side_by_side(transformed(x[0] + y[0]), transformed(x[1] + y[1]));
}
template <bool Fused>
constexpr exact_pair<symbol> two_product(const detail::factor<symbol, Fused>& x,
                                         const detail::factor<symbol, Fused>& y) {
    return transformed(x.value * y.value);
}
template <bool Fused>
constexpr exact_pair<symbols> two_product(const detail::factor<symbols, Fused>& x,
                                          const detail::factor<symbols, Fused>& y) {
    return side_by_side(transformed(x.value[0] * y.value[0]), transformed(x.value[1] * y.value[1]));
}
template <bool Fused>
constexpr exact_pair<symbols> two_square(const detail::factor<symbols, Fused>& x) {
    return two_product(x, x);
}

template <int I>
inline constexpr symbol v = terms::variable(I);
template <class V>
constexpr auto factor_of(const V& x) {
    return detail::as_factor<true>(x);
}

// y = Δx + Δu t0, each with its error: nothing is omitted.
static_assert([] {
    const auto y =
        detail::displacement<true>(exact_pair<symbol>{v<0>, v<1>}, exact_pair<symbol>{v<2>, v<3>}, factor_of(v<4>));
    return y.high.value + y.low == (v<0> + v<1>)+(v<2> + v<3>)*v<4>;
}());

// x + u (t0 + t1).
static_assert([] {
    const auto x = detail::position_in_parts(v<0>, v<1>, factor_of(v<2>), v<3>);
    return x.value + x.error == v<0> + v<1> * (v<2> + v<3>);
}());

// |y|² - R², except for the squares of low parts.
constexpr detail::lane_displacement<true, symbols> y01{factor_of(symbols{{v<0>, v<1>}}), {{v<2>, v<3>}}, {}};
constexpr detail::lane_displacement<true, symbols> y2{factor_of(symbols{{v<4>, v<5>}}), {{v<6>, v<7>}}, {}};
constexpr symbol square(const symbol& x) { return x * x; }
static_assert([] {
    const auto f = detail::distance_residual(y01, y2);
    return f.value[0] + f.value[1] + (f.error[0] + f.error[1]) ==
           square(v<0> + v<2>) + square(v<1> + v<3>) + square(v<5> + v<7>) - square(v<4> + v<6>) -
               (square(v<2>) + square(v<3>) + square(v<7>) - square(v<6>));
}());

// ih + il, ih anything near 1/x: (1 - r²)/x, r = 1 - ih x.
static_assert([] {
    const auto inverse = detail::inverse_of<true>(exact_pair<symbol>{v<0>, v<1>});
    const symbol x = v<0> + v<1>;
    const symbol r = symbol(1) - inverse.high.value * x;
    return (inverse.high.value + inverse.low) * x == symbol(1) - r * r;
}());

// (yh + low)(ih + il), except for low il.
static_assert([] {
    const detail::lane_displacement<true, symbol> y{factor_of(v<0>), v<4>, factor_of(symbol())};
    const auto n = detail::normal_of(y, v<1>, factor_of(v<2>), v<3>);
    return n.high.value + n.low == (v<0> + v<1>)*(v<2> + v<3>)-v<1> * v<3>;
}());

// u + (φ + φl)(nh + nl), except for φl nl.
static_assert([] {
    const detail::lane_normal<true, symbol> n{factor_of(v<3>), v<4>};
    const auto u = detail::velocity_in_parts(v<0>, factor_of(v<1>), v<2>, n);
    return u.value + u.error == v<0> + (v<1> + v<2>)*(v<3> + v<4>)-v<2> * v<4>;
}());

// A product, except for that of the low parts.
static_assert([] {
    const auto x = detail::times(exact_pair<symbol>{v<0>, v<1>}, factor_of(v<2>), v<3>);
    return x.value + x.error == (v<0> + v<1>)*(v<2> + v<3>)-v<1> * v<3>;
}());

// -y·Δu, except for the products of y's low parts and Δu's errors.
static_assert([] {
    const struct {
        exact_pair<symbols> u01, u_2;
    } m{{{{v<8>, v<9>}}, {{v<11>, v<12>}}}, {{{symbol(), v<10>}}, {{symbol(), v<13>}}}};
    const detail::lane_displacement<true, symbols> first{y01.high, {}, factor_of(m.u01.value)};
    const detail::lane_displacement<true, symbols> last{y2.high, {}, factor_of(m.u_2.value)};
    const auto s = detail::closing_speed(first, symbols{{v<2>, v<3>}}, last, symbols{{v<6>, v<7>}}, m);
    return s.value + s.error ==
           v<2> * v<11> + v<3> * v<12> + v<7> * v<13> -
               (v<0> + v<2>)*(v<8> + v<11>)-(v<1> + v<3>)*(v<9> + v<12>)-(v<5> + v<7>)*(v<10> + v<13>);
}());

} // namespace identity
