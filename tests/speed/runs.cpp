// graze-run-speed: what an event of a run costs, in graze's doubles beside plain ones, and from a hundred balls to a
// hundred thousand. Processor time, of a fluid that has been running for a while.
#include "runs/fluid_scene.hpp"

#include <graze/number/floating.hpp>
#include <graze/scene/exact_mechanics.hpp>
#include <graze/scene/plain_mechanics.hpp>
#include <graze/scene/run.hpp>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <memory>

namespace {

// A run that is advanced piece by piece.
template <class M>
class timed_run {
  public:
    timed_run(int balls, std::uint64_t warm_up) : run_(make_fluid<3>(balls, 1).scene()) {
        run_.advance({.events = warm_up});
    }
    // Microseconds an event, of so many.
    double advance(std::uint64_t events) {
        const std::clock_t start = std::clock();
        const auto done = run_.advance({.events = events});
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        return seconds * 1e6 / static_cast<double>(done.events);
    }

  private:
    graze::run<M> run_;
};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

} // namespace

// graze-run-speed [rounds]
int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 7;
    using plain = graze::plain_mechanics<3, double>;
    using exact = graze::exact_mechanics<3>;
    std::cout << std::fixed << std::setprecision(2);
    for (const int balls : {100, 500, 1000, 10000, 100000}) {
        const auto warm_up = static_cast<std::uint64_t>(balls);
        timed_run<plain> in_plain(balls, warm_up);
        timed_run<exact> in_exact(balls, warm_up);
        std::vector<double> costs_plain, costs_exact, ratios;
        for (int i = 0; i < rounds; ++i) { // interleaved
            costs_plain.push_back(in_plain.advance(5000));
            costs_exact.push_back(in_exact.advance(5000));
            ratios.push_back(costs_exact.back() / costs_plain.back());
        }
        std::cout << std::setw(6) << balls << " balls: plain " << median(costs_plain) << " us, exact "
                  << median(costs_exact) << " us an event, ratio " << median(ratios) << std::endl;
    }
}
