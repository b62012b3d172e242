// Compares random scenes with a simulator by brute force: scene_brute_force [scenes [first seed]].
#include "brute_force_scenes.hpp"

#include <cstdlib>
#include <iostream>

int main(int argc, char** argv) {
    const std::uint64_t scenes = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10000;
    const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1000;
    brute_force::comparison found;
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
