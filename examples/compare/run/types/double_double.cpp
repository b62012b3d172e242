#include "../../types/double_double.hpp"

#include "../type_run.hpp"

#include <graze/run/plain_mechanics.hpp>

#include <compare>

namespace compare::run {

namespace {

// dd_real with what a run needs and QD lacks: a conversion to double, and 1/∞ = 0, which is NaN in QD.
struct double_double {
    dd_real value;
    double_double() = default;
    explicit double_double(int x) : value(x) {}
    explicit double_double(double x) : value(x) {}
    explicit double_double(const dd_real& x) : value(x) {}
    explicit operator double() const { return value.x[0]; }
    double_double operator-() const { return double_double(-value); }
    friend double_double operator+(const double_double& x, const double_double& y) {
        return double_double(x.value + y.value);
    }
    friend double_double operator-(const double_double& x, const double_double& y) {
        return double_double(x.value - y.value);
    }
    friend double_double operator*(const double_double& x, const double_double& y) {
        return double_double(x.value * y.value);
    }
    friend double_double operator/(const double_double& x, const double_double& y) {
        return std::isinf(y.value.x[0]) && std::isfinite(x.value.x[0]) ? double_double(0)
                                                                       : double_double(x.value / y.value);
    }
    friend bool operator==(const double_double& x, const double_double& y) { return x.value == y.value; }
    friend std::partial_ordering operator<=>(const double_double& x, const double_double& y) {
        return x.value < y.value    ? std::partial_ordering::less
               : y.value < x.value  ? std::partial_ordering::greater
               : x.value == y.value ? std::partial_ordering::equivalent
                                    : std::partial_ordering::unordered;
    }
};

} // namespace

} // namespace compare::run

template <>
struct graze::number_traits<compare::run::double_double> : graze::number_traits<dd_real> {
    static compare::run::double_double sqrt(const compare::run::double_double& x) {
        return compare::run::double_double(::sqrt(x.value));
    }
};

namespace compare {

template <>
struct converter<run::double_double> {
    [[nodiscard]] static run::double_double from(const exact_view& x) {
        return run::double_double(converter<dd_real>::from(x));
    }
};

template <>
struct reader<run::double_double> {
    static void read(const run::double_double& x, const request& asked) { reader<dd_real>::read(x.value, asked); }
};

namespace run::types {

runnable of_double_double() {
    return {"dd_real", "QD", run_type<graze::plain_mechanics<2, double_double>>,
            run_type<graze::plain_mechanics<3, double_double>>};
}

} // namespace run::types
} // namespace compare
