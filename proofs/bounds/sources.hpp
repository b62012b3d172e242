// What the quantities are computed from, in each of the number types: inputs, and what is supposed of values.
#pragma once

#include <graze/analysis/gappa_term.hpp>
#include <graze/analysis/range_bound.hpp>
#include <graze/linear/vec.hpp>
#include <graze/number/gmp.hpp>
#include <graze/number/sqrt_extension.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <utility>

namespace bounds {

// The one normaliser of all columns: the largest component of the lengths (with the radius), of the velocities and of
// the normal. A quantity of the given degrees is measured in their product.
enum class kind { length, velocity, normal };
using degrees = std::array<int, 3>;

// A source gives
//   input(kind)         a component that is exact
//   difference(kind)    one that was rounded once, as a difference or sum of two exact ones
//   known(x, low, high, degrees)   x, of which low <= x <= high times the scales is a hypothesis
// and `number`, its type.

// By the compiler.
template <int Digits>
struct compiled_source {
    using number = graze::range_bound<Digits>;
    [[nodiscard]] constexpr number input(kind) { return number::exact_input(); }
    [[nodiscard]] constexpr number difference(kind) { return number::rounded_input(); }
    [[nodiscard]] constexpr number known(const number& x, double low, double high, degrees) {
        return x.within(low, high);
    }
};

// By Gappa.
class gappa_source {
  public:
    using number = graze::gappa_term;
    explicit gappa_source(const std::string& unit) : script_(unit) {}

    [[nodiscard]] number input(kind k) { return script_.exact_input(next_name(k)); }
    [[nodiscard]] number difference(kind k) { return script_.rounded_input(next_name(k)); }
    [[nodiscard]] number known(const number& x, double low, double high, degrees) {
        script_.suppose(x.exact() + " in [" + text(low) + "," + text(high) + "]");
        return x;
    }
    [[nodiscard]] std::string script(const number& result) const { return script_.text(result); }

  private:
    static std::string text(double x) {
        std::array<char, 40> buffer{};
        std::snprintf(buffer.data(), buffer.size(), "%a", x);
        return buffer.data();
    }
    [[nodiscard]] std::string next_name(kind k) {
        const auto index = static_cast<std::size_t>(k);
        return std::string(1, "xun"[index]) + std::to_string(count_[index]++);
    }

    graze::gappa_script script_;
    std::array<int, 3> count_{};
};

// On numbers: two a difference, one an input. In T, as a program computes it, with the scales of its inputs.
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
    [[nodiscard]] number known(const number& x, double, double, degrees) { return x; }
    [[nodiscard]] const std::array<double, 3>& scales() const { return scales_; }
    // Whether all inputs of a kind are 0: they have no scale.
    [[nodiscard]] bool degenerate() const {
        bool found = false;
        for (std::size_t i = 0; i < scales_.size(); ++i) {
            found = found || (is_used_[i] && scales_[i] == 0);
        }
        return found;
    }

  private:
    [[nodiscard]] T next() { return inputs_[position_++]; }
    [[nodiscard]] T scaled(kind k, T x) {
        is_used_[static_cast<std::size_t>(k)] = true;
        double& scale = scales_[static_cast<std::size_t>(k)];
        scale = std::max(scale, std::fabs(static_cast<double>(x)));
        return x;
    }

    std::span<const T> inputs_;
    std::size_t position_ = 0;
    std::array<double, 3> scales_{};
    std::array<bool, 3> is_used_{};
};

// Exactly; throws where what is supposed is not so.
struct outside_domain {};
template <class T>
class exact_source {
  public:
    using number = graze::gmp_rational;
    exact_source(std::span<const T> inputs, const std::array<double, 3>& scales) : inputs_(inputs), scales_(scales) {}

    [[nodiscard]] number input(kind) { return next(); }
    [[nodiscard]] number difference(kind) {
        const number x = next();
        const number y = next();
        return x - y;
    }
    template <class Number>
    [[nodiscard]] Number known(const Number& x, double low, double high, degrees d) {
        number scale(1);
        for (std::size_t i = 0; i < d.size(); ++i) {
            for (int n = 0; n < std::abs(d[i]); ++n) {
                scale = d[i] > 0 ? scale * number(scales_[i]) : scale / number(scales_[i]);
            }
        }
        if (x < Number(number(low) * scale) || x > Number(number(high) * scale)) {
            throw outside_domain();
        }
        return x;
    }

  private:
    [[nodiscard]] number next() { return number(static_cast<double>(inputs_[position_++])); }

    std::span<const T> inputs_;
    std::size_t position_ = 0;
    std::array<double, 3> scales_;
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
