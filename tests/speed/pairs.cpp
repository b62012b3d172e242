#include "speed.hpp"

#include <cmath>

namespace speed {

namespace {

constexpr std::size_t count = 4096;
constexpr std::uint64_t seed = 20261122;

// Uniform in (-1, 1), using all 53 bits.
double unit(families::random& r) { return std::ldexp(static_cast<double>(r.signed_bits(53)), -53); }

graze::vec<3, double> vector(families::random& r, double size) {
    return graze::make_vec<3>([&](int) { return size * unit(r); });
}

double radius(families::random& r) { return 1 + unit(r) / 2; }

// ± [1, 2)
double like(families::random& r) {
    const double magnitude = 1 + std::fabs(unit(r));
    return r.one_in(2) ? magnitude : -magnitude;
}

double any_exponent(families::random& r) {
    const double significand = unit(r);
    return std::ldexp(significand, static_cast<int>(r.in(-1000, 1000)));
}

template <class F>
pairs draw(F f, std::size_t number = count) {
    pairs p;
    for (std::size_t i = 0; i < number; ++i) {
        families::random r(seed, i);
        p.a.push_back(f(r));
        p.b.push_back(f(r));
    }
    return p;
}

pairs draw_generic(std::size_t number) {
    pairs p = draw(
        [](families::random& r) {
            const auto position = vector(r, 10);
            const auto velocity = vector(r, 1);
            return ball<3>{position, velocity, radius(r)};
        },
        number);
    // a's velocity relative to b is roughly towards b or, in every second pair, away from it.
    for (std::size_t i = 0; i < number; ++i) {
        families::random r(seed + 1, i);
        const double approach = r.one_in(2) ? 0.1 : -0.1;
        const auto off = vector(r, 0.2);
        p.a[i].velocity = p.b[i].velocity - approach * (p.a[i].position - p.b[i].position) + off;
    }
    return p;
}

} // namespace

const pairs& generic_pairs() {
    static const pairs result = draw_generic(count);
    return result;
}

const pairs& many_pairs() {
    static const pairs result = draw_generic(16 * count);
    return result;
}

const pairs& like_exponents() {
    static const pairs result = draw([](families::random& r) {
        ball<3> b{};
        for (int i = 0; i < 3; ++i) {
            b.position[i] = like(r);
            b.velocity[i] = like(r);
        }
        b.radius = std::fabs(like(r));
        return b;
    });
    return result;
}

const pairs& full_range() {
    static const pairs result = draw([](families::random& r) {
        ball<3> b{};
        for (int i = 0; i < 3; ++i) {
            b.position[i] = any_exponent(r);
            b.velocity[i] = any_exponent(r);
        }
        b.radius = std::fabs(any_exponent(r));
        return b;
    });
    return result;
}

} // namespace speed
