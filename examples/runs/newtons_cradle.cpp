// Newton's cradle: five equal balls that touch. A ball that comes in on one side sends a ball out on the other, through
// one collision after another, all at the same instant.
#include "exact_runs.hpp"

#include <iostream>

int main() {
    std::vector<graze::ball<2>> balls;
    for (int i = 0; i < 5; ++i) {
        balls.push_back({{static_cast<double>(2 * i), 0}, {0, 0}, 1, 1});
    }
    balls[0].position[0] = -4; // a gap of 4 before the row
    balls[0].velocity[0] = 2;
    balls[4].position[0] = 12; // and another after it
    balls[4].velocity[0] = -2;
    const auto finished = run_exactly<2>({balls, {}, {}}, {}, [](const exact_event<2>& e) {
        std::cout << "t = " << static_cast<double>(e.when) << ": " << to_string(e.who)
                  << (e.chosen ? ", chosen among events of this time" : "") << '\n';
        return true;
    });
    std::cout << "then " << to_string(finished.outcome.why) << ", velocities";
    for (const auto& f : finished.flights) {
        std::cout << ' ' << f.state.velocity[0];
    }
    std::cout << '\n';
}
