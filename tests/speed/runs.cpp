// graze-run-speed: the cost of an event of a run, in graze's doubles beside plain ones, for a hundred to a hundred
// thousand balls. Processor time, in a fluid of the same density that has melted: each ball has collided twenty times
// before timing starts. Predicting all pairs at the start does not count. Also the cost until balls without planes have
// flown apart, so that nothing more will ever happen.
#include "runs/fluid_scene.hpp"

#include <graze/number/floating.hpp>
#include <graze/run/exact_mechanics.hpp>
#include <graze/run/plain_mechanics.hpp>
#include <graze/run/run.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <string_view>

namespace {

// A run that advances piece by piece.
template <class M>
class timed_run {
  public:
    explicit timed_run(int balls) : run_(make_fluid<3>(balls, 1).scene()) {
        run_.advance({.events = 10 * static_cast<std::uint64_t>(balls)});
    }
    // Microseconds for each event, over as many events as balls but at least 20000, so that periodic work is included.
    double advance() {
        const std::clock_t start = std::clock();
        const auto done = run_.advance({.events = std::max<std::uint64_t>(20000, static_cast<unsigned>(run_.balls()))});
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        return seconds * 1e6 / static_cast<double>(done.events);
    }
    // 1 on the lattice on which the fluid starts, about 0 if nothing of it is left.
    [[nodiscard]] double order() const {
        double sum = 0;
        for (int i = 0; i < run_.balls(); ++i) {
            sum -= std::cos(2 * std::numbers::pi / 1.25 * run_.in_flight(i).state.position[0]);
        }
        return sum / run_.balls();
    }

  private:
    graze::run<M> run_;
};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

struct size_of_fluid {
    explicit size_of_fluid(int count) : balls(count), in_plain(count), in_exact(count) {}

    void measure() {
        plain.push_back(in_plain.advance());
        exact.push_back(in_exact.advance());
        ratios.push_back(exact.back() / plain.back());
    }

    int balls;
    timed_run<graze::plain_mechanics<3, double>> in_plain;
    timed_run<graze::exact_mechanics<3>> in_exact;
    std::vector<double> plain, exact, ratios;
    std::vector<double> growth_plain, growth_exact; // relative to the cost at a thousand balls in the same round
};

void measure_flying_apart() {
    std::cout << std::fixed << std::setprecision(2);
    for (const int balls : {500, 1000, 2000, 4000, 8000}) {
        const std::clock_t start = std::clock();
        graze::run<graze::exact_mechanics<3>> run(graze::scene<3>{.balls = make_fluid<3>(balls, 1).balls});
        const auto done = run.advance({});
        std::cout << std::setw(6) << balls << " balls: " << done.events << " events, then " << to_string(done.why)
                  << ", in " << static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC << " s\n";
    }
}

} // namespace

// graze-run-speed [rounds | apart]
int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "apart") {
        measure_flying_apart();
        return 0;
    }
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 7;
    std::deque<size_of_fluid> sizes;
    for (const int balls : {100, 500, 1000, 10000, 100000}) {
        sizes.emplace_back(balls);
    }
    const size_of_fluid& thousand = sizes[2];
    for (int i = 0; i < rounds; ++i) { // interleaved
        for (size_of_fluid& s : sizes) {
            s.measure();
        }
        for (size_of_fluid& s : sizes) {
            s.growth_plain.push_back(s.plain.back() / thousand.plain.back());
            s.growth_exact.push_back(s.exact.back() / thousand.exact.back());
        }
    }
    std::cout << std::fixed << std::setprecision(2);
    for (const size_of_fluid& s : sizes) {
        std::cout << std::setw(6) << s.balls << " balls: plain " << median(s.plain) << " us, exact " << median(s.exact)
                  << " us an event, ratio " << median(s.ratios) << "; " << median(s.growth_plain) << " and "
                  << median(s.growth_exact) << " times that of 1000 balls; lattice order " << s.in_exact.order()
                  << std::endl;
    }
}
