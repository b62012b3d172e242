// A number type of one's own: 32.32 fixed point, as games and machines without a floating-point unit use it. Ten lines
// of number_traits make it a graze::number; the program shows what it loses.
#include <graze/graze.hpp>

#include <compare>
#include <cstdint>
#include <cstdio>
#include <stdexcept>

// Whole multiples of 2^-32 below 2^31. Sums are exact; products, quotients and roots are rounded down to the grid;
// what does not fit throws.
class fixed_point {
  public:
    fixed_point() = default;
    constexpr fixed_point(int x) : raw_(std::int64_t{x} * (std::int64_t{1} << 32)) {}
    constexpr explicit fixed_point(double x) : raw_(static_cast<std::int64_t>(x * 0x1p32)) {}

    constexpr explicit operator double() const { return static_cast<double>(raw_) * 0x1p-32; }

    friend constexpr fixed_point operator-(fixed_point x) { return narrow(-wide{x.raw_}); }
    friend constexpr fixed_point operator+(fixed_point x, fixed_point y) { return narrow(wide{x.raw_} + y.raw_); }
    friend constexpr fixed_point operator-(fixed_point x, fixed_point y) { return narrow(wide{x.raw_} - y.raw_); }
    friend constexpr fixed_point operator*(fixed_point x, fixed_point y) {
        return narrow((wide{x.raw_} * y.raw_) >> 32);
    }
    friend constexpr fixed_point operator/(fixed_point x, fixed_point y) {
        if (y.raw_ == 0) {
            throw std::overflow_error("division by zero");
        }
        const wide numerator = wide{x.raw_} * (wide{1} << 32);
        const wide quotient = numerator / y.raw_;
        return narrow(quotient - (quotient * y.raw_ != numerator && (numerator < 0) != (y.raw_ < 0) ? 1 : 0));
    }
    friend constexpr auto operator<=>(fixed_point, fixed_point) = default;

    // Bit by bit, of a value that is not negative.
    static constexpr fixed_point square_root(fixed_point x) {
        const wide square = wide{x.raw_} << 32;
        wide root = 0;
        for (wide bit = wide{1} << 47; bit != 0; bit >>= 1) {
            if ((root + bit) * (root + bit) <= square) {
                root += bit;
            }
        }
        return narrow(root);
    }

  private:
    __extension__ using wide = __int128;

    static constexpr fixed_point narrow(wide x) {
        if (x != static_cast<std::int64_t>(x)) {
            throw std::overflow_error("beyond 2^31");
        }
        fixed_point y;
        y.raw_ = static_cast<std::int64_t>(x);
        return y;
    }

    std::int64_t raw_ = 0;
};

template <>
struct graze::number_traits<fixed_point> {
    static constexpr const char* name = "fixed 32.32";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0; // the error is absolute, so there is no number of significant ones
    static constexpr fixed_point sqrt(fixed_point x) { return fixed_point::square_root(x); }
};
static_assert(graze::field_number<fixed_point> && graze::has_sqrt<fixed_point>);

// Two balls of a pool table, distance metres apart along x and offset along y, the first one at this speed.
template <class T>
static graze::ball_solution<2, T> shot(double distance, double offset, double speed) {
    const T zero(0), radius(0.028575), mass(1);
    return graze::solve(graze::ball<2, T>{{{zero, zero}}, {{T(speed), zero}}, radius, mass},
                        graze::ball<2, T>{{{T(distance), T(offset)}}, {{zero, zero}}, radius, mass});
}

template <class T>
static void print(double distance, double offset, double speed) {
    std::printf("  %-12s", graze::number_traits<T>::name);
    try {
        const auto s = shot<T>(distance, offset, speed);
        std::printf("%s", to_string(s.what));
        if (is_collision(s.what)) {
            std::printf(" at %.10f s", static_cast<double>(s.time));
        }
        std::printf("\n");
    } catch (const std::overflow_error& error) {
        std::printf("%s\n", error.what());
    }
}

static void compare(const char* what, double distance, double offset, double speed) {
    std::printf("%s\n", what);
    print<double>(distance, offset, speed);
    print<fixed_point>(distance, offset, speed);
}

int main() {
    compare("a shot over the table", 1.27, 0.02, 2.5);
    compare("a thin cut", 1.27, 0.0571499999, 2.5);
    compare("a ball that creeps", 1.27, 0.02, 0.00001);
    compare("an alley of fifty km", 50000, 0.02, 2.5);
}
