// What a user's own number type, 32.32 fixed point, loses on a pool table.
#include "fixed_point.hpp"

#include <graze/graze.hpp>

#include <cstdio>

// Two balls of a pool table, distance metres apart along x and offset along y, the first one at this speed.
template <class T>
static graze::ball_solution<2, T> shot(double distance, double offset, double speed) {
    const T zero(0), radius(0.028575), mass(1);
    return graze::solve(graze::ball<2, T>{{zero, zero}, {T(speed), zero}, radius, mass},
                        graze::ball<2, T>{{T(distance), T(offset)}, {zero, zero}, radius, mass});
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
