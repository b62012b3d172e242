// Random scenes of a point among walls, compared with the oracle in rationals and with small balls: points_soak [scenes
// [first seed]]. Half are in space, and half have slanted walls. Exit code 1 if any is wrong, which it names.
#include "point_checks.hpp"

#include <cstdio>
#include <cstdlib>

namespace {

struct tally {
    std::size_t scenes = 0, wrong = 0, by_oracle = 0, beside_balls = 0;
};

template <int N>
void judge(std::uint64_t seed, bool slanted, tally& all) {
    const auto s = any_point_scene<N>(seed, slanted);
    ++all.scenes;
    const auto tell = [&](const char* by, const std::string& fault) {
        if (!fault.empty()) {
            ++all.wrong;
            std::printf("any_point_scene<%d>(%llu, %d), %s: %s\n", N, static_cast<unsigned long long>(seed), slanted,
                        by, fault.c_str());
        }
    };
    tell("by the oracle", fault_by_oracle<N>(s, 12, &all.by_oracle));
    tell("beside balls", fault_beside_balls<N>(s, 12, &all.beside_balls));
}

} // namespace

int main(int argc, char** argv) {
    const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100'000;
    const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    tally all;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const bool slanted = seed % 4 >= 2;
        seed % 2 == 0 ? judge<2>(seed, slanted, all) : judge<3>(seed, slanted, all);
    }
    std::printf("%zu scenes, %zu wrong; %zu bounces compared with the oracle's, %zu with those of balls\n", all.scenes,
                all.wrong, all.by_oracle, all.beside_balls);
    return all.wrong == 0 && all.by_oracle > all.scenes / 2 && all.beside_balls > all.scenes / 10 ? 0 : 1;
}
