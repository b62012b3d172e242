#include "shrink.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace precision {

namespace {

constexpr std::uint64_t fraction_mask = (std::uint64_t{1} << 52U) - 1;

// How much there is to read in a number: nothing for 0, else a sign, an exponent and the bits of its significand.
long cost(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    if (bits << 1U == 0 || !std::isfinite(x)) {
        return 0;
    }
    const std::uint64_t fraction = bits & fraction_mask;
    const long length = fraction == 0 ? 0 : 52 - std::countr_zero(fraction);
    return 8 + (std::signbit(x) ? 1 : 0) + 4 * length + std::labs(std::ilogb(x));
}

// Its leading bits only.
double shortened(double x, int kept) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return std::bit_cast<double>(bits & ~(fraction_mask >> static_cast<unsigned>(kept)));
}

std::vector<double> simpler(double x) {
    if (cost(x) == 0) {
        return {};
    }
    std::vector<double> all{0.0, 1.0, std::fabs(x)};
    for (const int kept : {0, 1, 2, 4, 8, 16, 24, 32, 40, 46, 50, 51}) {
        all.push_back(shortened(x, kept));
    }
    all.push_back(std::ldexp(x, -std::ilogb(x)));
    return all;
}

// The ball relative to the other thing's place and, if that is a ball, its motion. Rounded; the caller tests the
// result.
template <int N>
pair<N> seen_from_other(pair<N> p, bool from_place, bool in_motion) {
    const auto take = [](graze::vec<N, double>& x, graze::vec<N, double>& origin) {
        for (int i = 0; i < N; ++i) {
            x[i] -= origin[i];
            origin[i] = 0;
        }
    };
    std::visit(
        [&](auto& other) {
            if constexpr (requires { other.radius; }) {
                if (from_place) {
                    take(p.a.position, other.position);
                }
                if (in_motion) {
                    take(p.a.velocity, other.velocity);
                }
            } else if constexpr (requires { other.normal; }) {
                take(p.a.position, other.point);
            } else {
                take(p.a.position, other.corner);
            }
        },
        p.other);
    return p;
}

template <int N>
pair<N> shrink(pair<N> p, const std::function<bool(const any_pair&)>& still_shows, std::size_t most) {
    std::vector<double> numbers = numbers_of(p);
    bool changed = true;
    const auto attempt = [&](const std::vector<double>& candidate) {
        if (most == 0) {
            return false;
        }
        --most;
        set_numbers(p, candidate);
        if (!still_shows(p)) {
            return false;
        }
        numbers = candidate;
        return true;
    };
    for (const bool in_motion : {true, false}) {
        if (pair<N> nearer = p; attempt(numbers_of(seen_from_other(nearer, true, in_motion)))) {
            break;
        }
        set_numbers(p, numbers);
    }
    if (pair<N> slower = p; !attempt(numbers_of(seen_from_other(slower, false, true)))) {
        set_numbers(p, numbers);
    }
    while (changed && most != 0) {
        changed = false;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            for (const double y : simpler(numbers[i])) {
                std::vector<double> candidate = numbers;
                candidate[i] = y;
                if (cost(y) < cost(numbers[i]) && attempt(candidate)) {
                    changed = true;
                    break;
                }
            }
        }
    }
    set_numbers(p, numbers);
    return p;
}

} // namespace

any_pair shrunk(const any_pair& p, const std::function<bool(const any_pair&)>& still_shows, std::size_t most) {
    return std::visit([&](const auto& q) -> any_pair { return shrink(q, still_shows, most); }, p);
}

} // namespace precision
