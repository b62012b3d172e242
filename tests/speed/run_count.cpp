// graze-run-count, for a program that counts instructions: a fluid of 500 hard spheres melts for 10 events a ball, then
// runs for the given number of events [count_run.cmake]. Or the first event among 10,976 balls is found.
#include <graze/number/floating.hpp>
#include <graze/run/exact_mechanics.hpp>
#include <graze/run/plain_mechanics.hpp>
#include <graze/run/run.hpp>
#include <graze/scene/first_events.hpp>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <random>
#include <string_view>
#include <vector>

namespace {

struct fluid {
    std::vector<graze::ball<3>> balls;
    std::vector<graze::plane<3>> planes;
    graze::vec<3, double> period{};
};

// Balls of diameter 1 on a face-centred lattice of side^3 cells, between six planes or in a periodic cube. packing: the
// part of the volume that they fill.
fluid lattice(int side, double packing, bool periodic) {
    std::mt19937_64 random(1);
    fluid f;
    const int count = 4 * side * side * side;
    const double length = std::cbrt(count * std::numbers::pi / 6 / packing);
    const double spacing = periodic ? length / (2 * side) : (length - 1) / (2 * side - 1) * (1 - 0x1p-30);
    for (int i = 0; i < 8 * side * side * side; ++i) {
        const int site[3] = {i % (2 * side), i / (2 * side) % (2 * side), i / (4 * side * side)};
        if ((site[0] + site[1] + site[2]) % 2 == 0) {
            graze::ball<3> b{};
            for (int axis = 0; axis < 3; ++axis) {
                b.position[axis] = 0.5 + spacing * site[axis];
                b.velocity[axis] = static_cast<double>(static_cast<std::int64_t>(random() >> 43) - (1 << 20)) * 0x1p-20;
            }
            b.radius = 0.5;
            f.balls.push_back(b);
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (periodic) {
            f.period.component[axis] = length;
            continue;
        }
        graze::plane<3> p{};
        p.normal[axis] = 1;
        f.planes.push_back(p);
        p.point[axis] = length;
        f.planes.push_back(p);
    }
    return f;
}

template <class M>
void run(const fluid& f, std::uint64_t events) {
    graze::run<M> run(graze::scene<3>{.balls = f.balls, .planes = f.planes, .period = f.period});
    const auto done = run.advance({.events = 10 * f.balls.size() + events});
    std::cout << done.events << " events, then " << to_string(done.why) << '\n';
}

} // namespace

// graze-run-count packing events exact|plain planes|periodic, or graze-run-count packing first
int main(int argc, char** argv) {
    if (argc == 3 && std::string_view(argv[2]) == "first") {
        const fluid f = lattice(14, std::atof(argv[1]), false);
        const auto first = graze::first_events(graze::scene<3>{.balls = f.balls, .planes = f.planes});
        std::cout << first.events.size() << " events of " << f.balls.size() << " balls\n";
        return 0;
    }
    if (argc != 5) {
        std::cerr << "graze-run-count packing events exact|plain planes|periodic, or graze-run-count packing first\n";
        return 2;
    }
    const fluid f = lattice(5, std::atof(argv[1]), std::string_view(argv[4]) == "periodic");
    const std::uint64_t events = std::strtoull(argv[2], nullptr, 10);
    if (std::string_view(argv[3]) == "plain") {
        run<graze::plain_mechanics<3, double>>(f, events);
    } else {
        run<graze::exact_mechanics<3>>(f, events);
    }
}
