// p + q√d over an exact number type T: the type of τ, contact positions and velocities if T has no square root.
#pragma once

#include <graze/machine/failure.hpp>
#include <graze/number/traits.hpp>

#include <compare>
#include <utility>

namespace graze::inline v0_1 {

// The sign of p + q√d for d >= 0, exact if the ring operations are: no root is taken. p, q and d may be of three
// different types.
template <number P, number Q, number D>
[[nodiscard]] constexpr int sign_of_root_sum(const P& p, const Q& q, const D& d) {
    const int sign_p = graze::sign(p);
    const int sign_q = graze::sign(d) == 0 ? 0 : graze::sign(q);
    if (sign_p == sign_q || sign_q == 0) {
        return sign_p;
    }
    if (sign_p == 0) {
        return sign_q;
    }
    return sign_p * graze::sign(p * p - q * q * d); // opposite signs: the larger of p² and q²d decides
}

// p + q√d with d >= 0. Two of them combine if they have the same d or if one has q = 0; otherwise std::domain_error is
// thrown. Sums, products and comparisons are exact; so are quotients if T divides exactly.
template <number T>
class sqrt_extension {
    static_assert(number_traits<T>::is_exact, "sqrt_extension needs an exact number type");

  public:
    constexpr sqrt_extension() : p_(0), q_(0), d_(0) {}
    constexpr sqrt_extension(int p) : p_(p), q_(0), d_(0) {}
    constexpr sqrt_extension(T p) : p_(std::move(p)), q_(0), d_(0) {}
    constexpr sqrt_extension(T p, T q, T d) : p_(std::move(p)), q_(std::move(q)), d_(std::move(d)) {
        if (graze::sign(d_) < 0) {
            detail::fail<std::domain_error>("sqrt_extension: negative radicand");
        }
        if (graze::sign(d_) == 0) {
            q_ = T(0);
        }
    }

    [[nodiscard]] constexpr const T& p() const noexcept { return p_; }
    [[nodiscard]] constexpr const T& q() const noexcept { return q_; }
    [[nodiscard]] constexpr const T& d() const noexcept { return d_; }

    [[nodiscard]] constexpr int sign() const { return sign_of_root_sum(p_, q_, d_); }

    [[nodiscard]] constexpr sqrt_extension operator-() const { return {-p_, -q_, d_, trusted{}}; }

    [[nodiscard]] friend constexpr sqrt_extension operator+(const sqrt_extension& x, const sqrt_extension& y) {
        return {x.p_ + y.p_, x.q_ + y.q_, common_radicand(x, y), trusted{}};
    }
    [[nodiscard]] friend constexpr sqrt_extension operator-(const sqrt_extension& x, const sqrt_extension& y) {
        return {x.p_ - y.p_, x.q_ - y.q_, common_radicand(x, y), trusted{}};
    }
    [[nodiscard]] friend constexpr sqrt_extension operator*(const sqrt_extension& x, const sqrt_extension& y) {
        const T& d = common_radicand(x, y);
        return {x.p_ * y.p_ + x.q_ * y.q_ * d, x.p_ * y.q_ + x.q_ * y.p_, d, trusted{}};
    }
    [[nodiscard]] friend constexpr sqrt_extension operator/(const sqrt_extension& x,
                                                            const sqrt_extension& y) requires field_number<T> {
        const T& d = common_radicand(x, y);
        if (graze::sign(y.q_) == 0) {
            return {x.p_ / y.p_, x.q_ / y.p_, d, trusted{}};
        }
        const T norm = y.p_ * y.p_ - y.q_ * y.q_ * d;
        if (graze::sign(norm) == 0) { // √d is rational, since |p| = |q|√d
            const T root = graze::sign(y.p_) * graze::sign(y.q_) < 0 ? T(-(y.p_ / y.q_)) : T(y.p_ / y.q_);
            return sqrt_extension((x.p_ + x.q_ * root) / (y.p_ + y.q_ * root));
        }
        return {(x.p_ * y.p_ - x.q_ * y.q_ * d) / norm, (x.q_ * y.p_ - x.p_ * y.q_) / norm, d, trusted{}};
    }

    [[nodiscard]] friend constexpr bool operator==(const sqrt_extension& x, const sqrt_extension& y) {
        return (x - y).sign() == 0;
    }
    [[nodiscard]] friend constexpr std::strong_ordering operator<=>(const sqrt_extension& x, const sqrt_extension& y) {
        return (x - y).sign() <=> 0;
    }

  private:
    struct trusted {};
    constexpr sqrt_extension(T p, T q, T d, trusted) : p_(std::move(p)), q_(std::move(q)), d_(std::move(d)) {}

    static constexpr const T& common_radicand(const sqrt_extension& x, const sqrt_extension& y) {
        if (graze::sign(x.q_) == 0) {
            return y.d_;
        }
        if (graze::sign(y.q_) != 0 && graze::sign(x.d_ - y.d_) != 0) {
            detail::fail<std::domain_error>("sqrt_extension: operands over different roots");
        }
        return x.d_;
    }

    T p_, q_, d_;
};

template <number T>
struct number_traits<sqrt_extension<T>> {
    static constexpr const char* name = "sqrt_extension";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
    static constexpr int sign(const sqrt_extension<T>& x) { return x.sign(); }
};

namespace detail {
template <class T>
struct root_of {
    using type = sqrt_extension<T>;
};
template <has_sqrt T>
struct root_of<T> {
    using type = T;
};
} // namespace detail

// The type of a T's square root: T if it has square roots, its sqrt_extension otherwise.
template <number T>
using root_type = typename detail::root_of<T>::type;

// √x as a root_type.
template <number T>
[[nodiscard]] constexpr root_type<T> root(const T& x) {
    if constexpr (has_sqrt<T>) {
        return graze::square_root(x);
    } else {
        return root_type<T>(T(0), T(1), x);
    }
}

} // namespace graze::inline v0_1
