// What a formula costs, by operation, counted from the formula itself.
#pragma once

#include <graze/number/traits.hpp>

namespace graze::inline v0_1 {

struct operation_count {
    int sums = 0; // differences too; a doubling is one
    int products = 0;
    int fused = 0; // x*y + z, rounded once
    int quotients = 0;
    int roots = 0;
    int signs = 0; // comparisons with 0; negations are free

    [[nodiscard]] friend constexpr bool operator==(const operation_count&, const operation_count&) = default;
};

// A number without a value. Its operations are counted where `counter` points. Constants point nowhere; operations with
// them count where the other operand points.
class counted_number {
  public:
    constexpr explicit counted_number(operation_count* counter) : counter_(counter) {}
    constexpr explicit counted_number(int) {}

    [[nodiscard]] constexpr operation_count* counter() const noexcept { return counter_; }

  private:
    operation_count* counter_ = nullptr;
};

namespace detail {

// The result of one operation of this kind.
[[nodiscard]] constexpr counted_number counted(int operation_count::*kind, const counted_number& x,
                                               const counted_number& y) {
    operation_count* const counter = x.counter() != nullptr ? x.counter() : y.counter();
    if (counter != nullptr) {
        ++(counter->*kind);
    }
    return counted_number(counter);
}

} // namespace detail

[[nodiscard]] constexpr counted_number operator-(const counted_number& x) { return x; }
[[nodiscard]] constexpr counted_number operator+(const counted_number& x, const counted_number& y) {
    return detail::counted(&operation_count::sums, x, y);
}
[[nodiscard]] constexpr counted_number operator-(const counted_number& x, const counted_number& y) {
    return detail::counted(&operation_count::sums, x, y);
}
[[nodiscard]] constexpr counted_number operator*(const counted_number& x, const counted_number& y) {
    return detail::counted(&operation_count::products, x, y);
}
[[nodiscard]] constexpr counted_number operator/(const counted_number& x, const counted_number& y) {
    return detail::counted(&operation_count::quotients, x, y);
}

template <>
struct number_traits<counted_number> {
    static constexpr const char* name = "counted_number";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0;

    // In a case distinction, the case of positive numbers is counted.
    static constexpr int sign(const counted_number& x) {
        (void)detail::counted(&operation_count::signs, x, x);
        return 1;
    }
    static constexpr counted_number sqrt(const counted_number& x) {
        return detail::counted(&operation_count::roots, x, x);
    }
    static constexpr counted_number fma(const counted_number& x, const counted_number& y, const counted_number& z) {
        return detail::counted(&operation_count::fused, x.counter() != nullptr ? x : y, z);
    }
};

// The operations of f(x), x any input: a formula called with inputs that are all copies of x.
template <class F>
[[nodiscard]] constexpr operation_count operations_of(F f) {
    operation_count total;
    (void)f(counted_number(&total));
    return total;
}

} // namespace graze::inline v0_1
