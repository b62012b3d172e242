// The discriminant by way of the closest approach, as identities: what holds for these polynomials holds for all
// inputs.
#include <graze/formula/closest_approach.hpp>
#include <graze/formula/discriminant.hpp>

#include "../variables.hpp"

namespace {

using namespace graze;
using proof::letter;
using proof::letters;

using fraction = rational_function<256>;

template <int N>
constexpr relative_motion<N, fraction, fraction, fraction> general() {
    relative_motion<N, fraction, fraction, fraction> m{};
    for (int k = 0; k < N; ++k) {
        m.dx[k] = fraction(letter(k));
        m.du[k] = fraction(letter(N + k));
    }
    m.R = fraction(letter(2 * N));
    return m;
}

template <int N>
constexpr bool proved() {
    // a (R² - |m|²) is Lagrange's form of D.
    static_assert(discriminant_closest{}(general<N>()) == discriminant_lagrange{}(general<N>()));
    // m is at right angles to Δu: no point of the line is closer.
    static_assert(graze::dot(closest_approach{}(general<N>()), general<N>().du) == fraction(0));
    return true;
}
static_assert(proved<2>() && proved<3>());

// A number whose root is a letter: l stands for √(l²).
struct rooted {
    letters value;
    constexpr rooted(int x = 0) : value(x) {}
    constexpr rooted(letters x) : value(std::move(x)) {}
    friend constexpr rooted operator+(const rooted& x, const rooted& y) { return x.value + y.value; }
    friend constexpr rooted operator-(const rooted& x, const rooted& y) { return x.value - y.value; }
    friend constexpr rooted operator*(const rooted& x, const rooted& y) { return x.value * y.value; }
    // Along the first axis Δu is 1 and h is 0 where the proof divides: 0/1.
    friend constexpr rooted operator/(const rooted& x, const rooted&) { return x; }
    constexpr rooted operator-() const { return -value; }
    friend constexpr bool operator==(const rooted&, const rooted&) = default;
};

} // namespace

template <>
struct graze::number_traits<rooted> {
    static constexpr const char* name = "rooted";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static constexpr int sign(const rooted& x) { return x.value.sign(); }
    static constexpr rooted sqrt(const rooted& x) {
        return x.value == letter(0) * letter(0) ? rooted(letter(0)) : rooted(-1);
    }
};

namespace {

// (R + l)(R - l) = R² - l², in the frame in which Δu = (1, 0) and Δx = (0, l): there m = Δx and a = 1. A rotation,
// another speed and an earlier time lead to every other case.
static_assert([] {
    const relative_motion<2, rooted, rooted, rooted> m{
        {{rooted(0), rooted(letter(0))}}, {{rooted(1), rooted(0)}}, rooted(letter(1))};
    return discriminant_factored{}(m) == discriminant_closest{}(m) &&
           discriminant_factored{}(m) == rooted(letter(1) * letter(1) - letter(0) * letter(0));
}());

} // namespace
