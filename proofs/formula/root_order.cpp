// The order of smaller roots, for all pairs of small quadratics, against an order by squaring.
#include <graze/formula/root_order.hpp>

#include "../whole.hpp"

#include <cstdint>

namespace {

using namespace graze;
using proof::whole;
using equation = quadratic<whole, whole, whole>;

constexpr int sign_of(std::int64_t x) { return (x > 0) - (x < 0); }
// The sign of p + √q.
constexpr int sign_of_sum(std::int64_t p, std::int64_t q) { return p >= 0 ? sign_of(p + q) : sign_of(q - p * p); }
// The sign of t₁ - t₂ = (-h₁ - √D₁)/a₁ - (-h₂ - √D₂)/a₂, times a₁a₂: of p + √c - √b.
constexpr int by_squaring(const equation& x, const equation& y) {
    const auto a1 = x.a.value, h1 = x.h.value, c1 = x.c.value;
    const auto a2 = y.a.value, h2 = y.h.value, c2 = y.c.value;
    const std::int64_t p = a1 * h2 - a2 * h1;
    const std::int64_t b = a2 * a2 * (h1 * h1 - a1 * c1);
    const std::int64_t c = a1 * a1 * (h2 * h2 - a2 * c2);
    if (sign_of_sum(p, c) < 0) {
        return -1;
    }
    // (p + √c)² - b = p² + c - b + 2p√c, of which the square root's part has the sign of p.
    const std::int64_t rest = p * p + c - b;
    const std::int64_t square = 4 * p * p * c;
    return p >= 0 ? sign_of_sum(rest, square) : -sign_of_sum(-rest, square);
}

template <class F>
constexpr bool of_all_small(int a_to, int h_to, int c_to, F f) {
    for (int a = 1; a <= a_to; ++a) {
        for (int h = -h_to; h < 0; ++h) {
            for (int c = 0; c <= c_to && h * h - a * c >= 0; ++c) {
                if (!f(equation{a, h, c})) {
                    return false;
                }
            }
        }
    }
    return true;
}

static_assert(of_all_small(3, 4, 6, [](const equation& x) {
    return of_all_small(3, 4, 6, [&](const equation& y) { return root_order{}(x, y) == by_squaring(x, y); });
}));

// Against a time n/4: the quadratic's value there and its slope tell.
static_assert(of_all_small(3, 4, 6, [](const equation& q) {
    for (int n = -4; n <= 24; ++n) {
        // a τ = -h - √D against a n/4, times 4.
        const std::int64_t p = -4 * q.h.value - q.a.value * n;
        const std::int64_t D = q.h.value * q.h.value - q.a.value * q.c.value;
        const int expected = -sign_of_sum(-p, 16 * D);
        const int value = sign(value_at{}(q, whole(n), whole(4)));
        const int slope = sign(slope_at{}(q, whole(n), whole(4)));
        if (root_against(value, slope) != expected) {
            return false;
        }
    }
    return true;
}));

} // namespace
