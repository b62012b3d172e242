// Proves Galperin's billiard with a mass of 10^8: 31,415 collisions.
#include "run/certified_run.hpp"
#include "scene_reader.hpp"

#include <iostream>
#include <variant>

int main() {
    using namespace compare;
    const auto scene = read_scene(GRAZE_TEST_SCENES "/galperin_100000000.json", number_input::exactly);
    const auto found =
        run::certified_run<2>(std::get<exact_scene<2>>(scene.scene), {{}, 100'000}, {}, progress_line(false));
    std::cout << found.events.size() << " collisions, " << found.problem << "\n";
    return found.problem.empty() && found.events.size() == 31'415 && found.why == graze::ending::exhausted ? 0 : 1;
}
