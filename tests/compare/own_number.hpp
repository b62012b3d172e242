// A user's number type and formulas: doubles of which each operation keeps 30 bits, a solution whose times are twice as
// large as they should be, and a discriminant.
#pragma once

#include "../precision/own/careless_discriminant.hpp"

#include <graze/number/floating.hpp>
#include <graze/solve.hpp>

#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>

namespace own {

class thirty_bits {
  public:
    thirty_bits(int x = 0) : thirty_bits(static_cast<double>(x)) {}
    explicit thirty_bits(double x) : value_(kept(x)) {}
    explicit operator double() const { return value_; }

    friend thirty_bits operator+(thirty_bits x, thirty_bits y) { return thirty_bits(x.value_ + y.value_); }
    friend thirty_bits operator-(thirty_bits x, thirty_bits y) { return thirty_bits(x.value_ - y.value_); }
    friend thirty_bits operator*(thirty_bits x, thirty_bits y) { return thirty_bits(x.value_ * y.value_); }
    friend thirty_bits operator/(thirty_bits x, thirty_bits y) { return thirty_bits(x.value_ / y.value_); }
    thirty_bits operator-() const { return thirty_bits(-value_); }
    friend auto operator<=>(thirty_bits x, thirty_bits y) = default;

  private:
    static double kept(double x) {
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~((std::uint64_t{1} << 23U) - 1));
    }
    double value_;
};

struct late_solution {
    static constexpr const char* name = "late";
    static constexpr auto measures = graze::precision::quantity::time;

    template <int N, class T>
    graze::ball_solution<N, T> operator()(const graze::ball<N, T>& a, const graze::ball<N, T>& b) const {
        auto s = graze::solve(a, b);
        s.time = s.time + s.time;
        return s;
    }
};

} // namespace own

template <>
struct graze::number_traits<own::thirty_bits> {
    static constexpr const char* name = "thirty_bits";
    static constexpr bool is_exact = false;
    static constexpr int digits = 30;
    static own::thirty_bits sqrt(own::thirty_bits x) { return own::thirty_bits(std::sqrt(static_cast<double>(x))); }
};
