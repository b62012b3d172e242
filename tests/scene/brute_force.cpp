// Compares random scenes with a simulator by brute force: scene_brute_force [scenes [first seed]].
#include "brute_force_scenes.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace {

// Three clusters that fly into one another from far away, each nearly at rest in itself. Enclosures of their times are
// wide, so that a ball's next event may cease to be certain when another ball is hit.
const std::vector<graze::ball<2>> distant_clusters = {
    {{-142032610.125, -127955567.76757812}, {0.012872574468929088, 0.011596757277430925}, 2.3642578125, 1},
    {{-3505188.25, -141498508}, {0.00031768070766702294, 0.012824170000385493}, 2, 1},
    {{-155624448, -104846141.5}, {0.014104419387876987, 0.0095023228714126162}, 1.125, 1},
    {{-155624451, -104846136}, {0.014104419387876987, 0.0095023228786885738}, 1.5, 1},
    {{-3505196, -141498504.25}, {0.00031768064945936203, 0.012824169988107315}, 1.5390625, 1},
    {{-155624450.6640625, -104846146.95117188}, {0.014104419456998585, 0.0095023228714126162}, 0.9375, 1},
    {{-155624441, -104846118}, {0.014104419446084648, 0.0095023224130272865}, 1.25, 1},
    {{-3407872, -134217728}, {0.0003185272216796875, 0.0126953125}, 2.5, 1},
    {{-142032622.95898438, -127955550.24731445}, {0.012872574467252207, 0.011596757277430925}, 1.8046875, 1},
    {{-3505226.796875, -141498519.640625}, {0.00031768070766702294, 0.012824169988107315}, 2.03125, 1},
    {{-3505228.640625, -141498495.25}, {0.00031768070766702294, 0.012824169989471557}, 1.875, 1},
    {{-3505203.46875, -141498527.26953125}, {0.00031768070766702294, 0.012824169988107315}, 2.203125, 1},
    {{-155624451.1628418, -104846155.90039062}, {0.014104419456685946, 0.0095023228702757478}, 1.25, 1},
    {{-142032585.73046875, -127955548.9375}, {0.012872574468929088, 0.011596757278311998}, 1.875, 1},
    {{-155624463, -104846128}, {0.014104419446084648, 0.0095023228786885738}, 1.625, 1},
    {{-150994944, -100663296}, {0.01409912109375, 0.009765625}, 1, 1},
    {{-3505198.5, -141498520.3125}, {0.00031768070766702294, 0.012824170000385493}, 1.625, 1},
    {{-142032608, -127955577}, {0.012872574443463236, 0.011596757278311998}, 2.25, 1},
    {{-142032616.87973022, -127955556.06491089}, {0.012872574467252207, 0.01159675727743642}, 1.052703857421875, 1},
    {{-155624473.875, -104846125.8125}, {0.014104419456998585, 0.0095023228702757478}, 0.83203125, 1},
    {{-155624475.47265625, -104846121.5}, {0.014104419456998585, 0.0095023228786885738}, 1.421875, 1},
    {{-3505196, -141498503}, {0.00031768064945936203, 0.012824170000385493}, 0.75, 1},
    {{-142032596, -127955560}, {0.012872574443463236, 0.011596757278311998}, 0.75, 1},
    {{-3505217.005859375, -141498514.18066406}, {0.00031768070977022944, 0.012824169988107315}, 0.49609375, 1},
    {{-155624454.75, -104846123.40625}, {0.014104419456998585, 0.0095023228786885738}, 1.375, 1},
    {{-142032618.16674805, -127955554.62475586}, {0.012872574467256648, 0.011596757277436254}, 1.40625, 1},
    {{-3505213.34375, -141498526.10546875}, {0.00031768070766702294, 0.012824169988107315}, 2.265625, 1},
};

void compare_distant_clusters(brute_force::comparison& found) {
    const graze::scene<2> scene{.balls = distant_clusters};
    brute_force::simulator<2> expected(scene);
    int events = 0;
    const auto is_next = [&](const exact_event<2>& e) {
        bool is_clear = true;
        const auto next = expected.next(0x1p60, is_clear);
        const graze::scene_pair who{e.who.with, std::min(e.who.a, e.who.b), std::max(e.who.a, e.who.b)};
        ++events;
        if (!next || !is_clear || next->who != who) {
            found.problem = "distant clusters: " + to_string(who) + " is not next, event " + std::to_string(events);
        }
        return found.problem.empty();
    };
    (void)run_exactly<2>(scene, {.events = 60}, is_next);
    bool is_clear = true;
    if (found.problem.empty() && expected.next(0x1p60, is_clear)) {
        found.problem = "distant clusters: an event is missed after " + std::to_string(events);
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::uint64_t scenes = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10000;
    const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1000;
    brute_force::comparison found;
    compare_distant_clusters(found);
    if (!found.problem.empty()) {
        std::cout << found.problem << '\n';
        return 1;
    }
    for (std::uint64_t i = 0; i < scenes; ++i) {
        i % 2 == 0 ? brute_force::compare<2>(first + i, 15, found) : brute_force::compare<3>(first + i, 15, found);
        if (!found.problem.empty()) {
            std::cout << found.problem << '\n';
            return 1;
        }
        if ((i + 1) % 1000 == 0) {
            std::cout << i + 1 << " scenes, " << found.events << " events" << std::endl;
        }
    }
    std::cout << scenes << " scenes, " << found.events << " events, all alike; " << found.ties
              << " ended at events of all but one time; clocks were set back " << found.clocks << " times\n";
    if (found.clocks < static_cast<int>(scenes / 10)) {
        std::cout << "too seldom\n";
        return 1;
    }
}
