// The common parts of the benchmarks: the pairs, and the registration of a comparison.
#pragma once

#include "plain.hpp"

#include <families/random.hpp>

#include <graze/graze.hpp>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace speed {

using graze::ball;

struct pairs {
    std::vector<ball<3>> a, b;

    [[nodiscard]] std::size_t size() const { return a.size(); }
};

// 4096 pairs in space, in random order: half recede, and more than a quarter hit. The inputs are doubles with all their
// bits.
[[nodiscard]] const pairs& generic_pairs();
// 65536 of them: too many for a branch predictor to remember the answers, as it does when 4096 are repeated.
[[nodiscard]] const pairs& many_pairs();
// Pairs in which all lengths have the same exponent, and all velocities have.
[[nodiscard]] const pairs& like_exponents();
// Pairs in which every coordinate has its own exponent, over the range of doubles.
[[nodiscard]] const pairs& full_range();

// Registers `group`/`name`: f(i) for each i below count, each an item. The others of a group are divided by its first.
template <class F>
void compare(const std::string& group, const std::string& name, std::size_t count, F f) {
    benchmark::RegisterBenchmark((group + '/' + name).c_str(), [count, f](benchmark::State& state) {
        for (auto _ : state) {
            long sum = 0; // throughput: the results are used, but no iteration waits for the one before
            for (std::size_t i = 0; i < count; ++i) {
                sum += static_cast<long>(f(i));
            }
            benchmark::DoNotOptimize(sum);
        }
        state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
    });
}

// τ by the halved discriminant and the stable root in T, for pairs that are apart and meet.
template <class T>
[[nodiscard]] inline std::optional<T> plain_time(const ball<3, T>& a, const ball<3, T>& b) {
    const auto m = graze::relative_motion_of(a, b);
    const T h = graze::coefficient_h{}(m);
    if (graze::sign(h) >= 0) {
        return std::nullopt;
    }
    const T c = graze::coefficient_c{}(m);
    if (graze::sign(c) < 0) {
        return T(0);
    }
    const T d = graze::discriminant_halved{}(graze::quadratic<T, T, T>{graze::coefficient_a{}(m), h, c});
    if (graze::sign(d) < 0) {
        return std::nullopt;
    }
    return T(graze::root_stable{}(c, h, graze::square_root(d)));
}

template <class T>
struct converted {
    std::vector<ball<3, T>> a, b;
    explicit converted(const pairs& p) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            a.push_back(as<T>(p.a[i]));
            b.push_back(as<T>(p.b[i]));
        }
    }
};

// Registers the decision in T on the given pairs, converted outside the timed loop.
template <class T>
void compare_type(const std::string& group, const std::string& name, const pairs& p) {
    auto inputs = std::make_shared<const converted<T>>(p);
    compare(group, name, p.size(), [inputs](std::size_t i) { return decide(inputs->a[i], inputs->b[i]); });
}

void register_decisions();
void register_orders();
void register_contacts();
void register_flights();
void register_flat();
void register_cgal(); // if CGAL is installed

} // namespace speed
