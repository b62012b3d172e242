// The sources of the quantities in each number type: inputs, and hypotheses about values.
#pragma once

#include <graze/analysis/error_bound.hpp>
#include <graze/analysis/gappa_term.hpp>
#include <graze/linear/vec.hpp>
#include <graze/number/adapter/gmp.hpp>
#include <graze/number/sqrt_extension.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bounds {

// The normaliser of all columns: the largest component of the lengths (with the radius), of the velocities and of the
// normal. A quantity of the given degrees is measured in units of their product.
enum class kind { length, velocity, normal };
using degrees = std::array<int, 3>;

[[nodiscard]] constexpr degrees degree_of(kind k) {
    return {k == kind::length, k == kind::velocity, k == kind::normal};
}

// A source gives
//   input(kind)         an exact component
//   difference(kind)    a component that was rounded once, as a difference or sum of two exact ones
//   require(f)          the hypothesis that f(), about values, is true
// and `number`, its type.

// For the compiler's bound, as in the filters: relative to norms, with the radius as one of the lengths.
template <int Digits>
struct compiled_source {
    using number = graze::basic_error_bound<Digits>;
    [[nodiscard]] constexpr number input(kind k) { return number::exact_input(degree_of(k)); }
    [[nodiscard]] constexpr number difference(kind k) { return number::rounded_input(degree_of(k)); }
};

// For Gappa's bound.
class gappa_source {
  public:
    using number = graze::gappa_term;
    explicit gappa_source(const std::string& unit) : script_(unit) {}

    [[nodiscard]] number input(kind k) { return script_.exact_input(next_name(k)); }
    [[nodiscard]] number difference(kind k) { return script_.rounded_input(next_name(k)); }
    [[nodiscard]] std::string script(const number& result) const { return script_.text(result); }

  private:
    [[nodiscard]] std::string next_name(kind k) {
        const auto index = static_cast<std::size_t>(k);
        return std::string(1, "xun"[index]) + std::to_string(count_[index]++);
    }

    graze::gappa_script script_;
    std::array<int, 3> count_{};
};

// For the search, on numbers: a difference takes two, an input one. In T, as a program computes it, with the scales of
// its inputs.
template <class T>
class rounded_source {
  public:
    using number = T;
    explicit rounded_source(std::span<const T> inputs) : inputs_(inputs) {}

    [[nodiscard]] number input(kind k) { return scaled(k, next()); }
    [[nodiscard]] number difference(kind k) {
        const T x = next();
        const T y = next();
        return scaled(k, x - y);
    }
    template <class F>
    void require(F) {}

    // The largest component of each kind.
    [[nodiscard]] std::array<double, 3> scales() const {
        return each_kind([](const std::vector<double>& x) { return *std::max_element(x.begin(), x.end()); });
    }
    // The norm of each kind's vector of N components; for the lengths, the radius if that is larger.
    [[nodiscard]] std::array<double, 3> norms(std::size_t dimensions) const {
        return each_kind([dimensions](const std::vector<double>& x) {
            double sum = 0;
            for (std::size_t i = 0; i < dimensions; ++i) {
                sum += x[i] * x[i];
            }
            return std::max(std::sqrt(sum), *std::max_element(x.begin() + static_cast<long>(dimensions) - 1, x.end()));
        });
    }
    // Whether all inputs of some kind are 0, so that they have no scale.
    [[nodiscard]] bool degenerate() const {
        const auto s = scales();
        return std::any_of(s.begin(), s.end(), [](double x) { return x == 0; });
    }

  private:
    [[nodiscard]] T next() { return inputs_[position_++]; }
    [[nodiscard]] T scaled(kind k, T x) {
        const auto value = static_cast<double>(x);
        magnitudes_[static_cast<std::size_t>(k)].push_back(value < 0 ? -value : value);
        return x;
    }
    template <class F>
    [[nodiscard]] std::array<double, 3> each_kind(F f) const { // 1 for a kind without inputs
        std::array<double, 3> r{};
        for (std::size_t i = 0; i < r.size(); ++i) {
            r[i] = magnitudes_[i].empty() ? 1 : f(magnitudes_[i]);
        }
        return r;
    }

    std::span<const T> inputs_;
    std::size_t position_ = 0;
    std::array<std::vector<double>, 3> magnitudes_;
};

// Exact values. Throws if a requirement does not hold.
struct outside_domain {};
template <class T>
class exact_source {
  public:
    using number = graze::gmp_rational;
    explicit exact_source(std::span<const T> inputs) : inputs_(inputs) {}

    [[nodiscard]] number input(kind) { return next(); }
    [[nodiscard]] number difference(kind) {
        const number x = next();
        const number y = next();
        return x - y;
    }
    template <class F>
    void require(F holds) {
        if (!holds()) {
            throw outside_domain();
        }
    }

  private:
    [[nodiscard]] number next() { return exactly(inputs_[position_++]); }
    [[nodiscard]] static number exactly(const graze::gmp_rational& x) { return x; }
    [[nodiscard]] static number exactly(double x) { return number(x); }

    std::span<const T> inputs_;
    std::size_t position_ = 0;
};

template <int N, class Source>
[[nodiscard]] constexpr auto inputs(Source& s, kind k) {
    using number = typename Source::number;
    if constexpr (N == 2) {
        number x = s.input(k);
        number y = s.input(k);
        return graze::vec<2, number>{{x, y}};
    } else {
        number x = s.input(k);
        number y = s.input(k);
        number z = s.input(k);
        return graze::vec<3, number>{{x, y, z}};
    }
}
template <int N, class Source>
[[nodiscard]] constexpr auto differences(Source& s, kind k) {
    using number = typename Source::number;
    if constexpr (N == 2) {
        number x = s.difference(k);
        number y = s.difference(k);
        return graze::vec<2, number>{{x, y}};
    } else {
        number x = s.difference(k);
        number y = s.difference(k);
        number z = s.difference(k);
        return graze::vec<3, number>{{x, y, z}};
    }
}

} // namespace bounds
