// Pressure and collision rate of hard-sphere fluids in a periodic cube, beside the known values. The virial gives the
// pressure, and the count of collisions gives the rate. The known values come from no formula of the library.
#include "fluid_picture.hpp"

#include <graze/run.hpp>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace {

struct fluid {
    std::vector<graze::ball<3>> balls;
    double length;
};

// 4 side³ balls of diameter and mass 1 on a face-centred lattice in a periodic cube. The total momentum is 0.
fluid lattice(int side, double packing) {
    std::mt19937_64 random(1);
    fluid f;
    const int count = 4 * side * side * side;
    f.length = std::cbrt(count * std::numbers::pi / 6 / packing);
    graze::vec<3, double> mean{};
    for (int i = 0; i < 8 * side * side * side; ++i) {
        const int site[3] = {i % (2 * side), i / (2 * side) % (2 * side), i / (4 * side * side)};
        if ((site[0] + site[1] + site[2]) % 2 == 0) {
            graze::ball<3> b{};
            for (int axis = 0; axis < 3; ++axis) {
                b.position[axis] = f.length * (site[axis] + 0.5) / (2 * side);
                b.velocity[axis] = static_cast<double>(static_cast<std::int64_t>(random() >> 43) - (1 << 20)) * 0x1p-20;
            }
            b.radius = 0.5;
            mean = mean + (1.0 / count) * b.velocity;
            f.balls.push_back(b);
        }
    }
    for (auto& b : f.balls) {
        b.velocity = b.velocity - mean;
    }
    return f;
}

// The mean of the blocks and its standard error.
with_error mean_of(const std::vector<double>& blocks) {
    const auto count = static_cast<double>(blocks.size());
    double sum = 0, squares = 0;
    for (const double x : blocks) {
        sum += x;
    }
    for (const double x : blocks) {
        squares += (x - sum / count) * (x - sum / count);
    }
    return {sum / count, std::sqrt(squares / (count * (count - 1)))};
}

// Measures after 100 events a ball. The virial gives Z - 1 = Σ σ |Δp| / (3 N kT t). The total momentum is 0, which
// takes three degrees of freedom: Σ m u² = 3 (N - 1) kT, hence the factor (N - 1)/N.
measured_fluid measure(double packing, int side, std::uint64_t events, int blocks) {
    const fluid f = lattice(side, packing);
    const auto count = static_cast<double>(f.balls.size());
    graze::run run(graze::scene<3>{.balls = f.balls, .period = {{f.length, f.length, f.length}}});
    double now = 0, energy2 = 0, virial = 0; // Σ u², Σ σ |Δu|
    for (const auto& b : f.balls) {
        energy2 += graze::squared_norm(b.velocity);
    }
    const auto note = [&](const auto& e) {
        now = e.after_a.since;
        virial += std::sqrt(graze::squared_norm(e.after_a.state.velocity - e.before_a.state.velocity));
    };
    run.advance({.events = 100 * f.balls.size()}, note);
    const double thermal = std::sqrt(energy2 / (3 * (count - 1))); // √(kT/m)
    std::vector<double> excess, rate;
    for (int i = 0; i < blocks; ++i) {
        const double start = now;
        virial = 0;
        const auto done = run.advance({.events = events / static_cast<std::uint64_t>(blocks)}, note);
        excess.push_back((count - 1) / count * virial / (energy2 * (now - start)));
        rate.push_back(2 * static_cast<double>(done.events) / (count * (now - start) * thermal));
    }
    return {packing, mean_of(excess), mean_of(rate)};
}

} // namespace

// fluid_physics [events [side [picture]]]: with 4 side³ balls.
int main(int argc, char** argv) {
    const std::uint64_t events = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
    const int side = argc > 2 ? std::atoi(argv[2]) : 10;
    std::cout << 4 * side * side * side << " balls, " << events << " events after 100 a ball\n"
              << "packing  Z - 1 (Carnahan, Starling)  off by %      collisions of a ball (Enskog)  off by %\n";
    std::vector<measured_fluid> all;
    bool agrees = true;
    for (const double packing : {0.10, 0.20, 0.30, 0.40, 0.45}) {
        const measured_fluid m = measure(packing, side, events, 20);
        const with_error excess = m.excess.relative_to(carnahan_starling(packing));
        const with_error rate = m.rate.relative_to(enskog(packing));
        std::cout << std::fixed << std::setprecision(2) << packing << std::setprecision(4) << "     " << m.excess.value
                  << " (" << carnahan_starling(packing) << ")" << std::setprecision(2) << "  " << excess.value << " ± "
                  << excess.error << std::setprecision(4) << "   " << m.rate.value << " (" << enskog(packing) << ")"
                  << std::setprecision(2) << "  " << rate.value << " ± " << rate.error << std::endl;
        agrees = agrees && std::fabs(excess.value) < 1;
        all.push_back(m);
    }
    if (argc > 3) {
        std::ofstream(argv[3]) << picture_of(all);
    }
    std::cout << (agrees ? "the pressure is within 1% everywhere\n" : "the pressure is off by more than 1%\n");
    return agrees ? 0 : 1;
}
