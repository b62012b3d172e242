// graze-stages FILE: which stage settles graze's answers about 4000 pairs of each family, in the plane and in space.
// Writes the picture to FILE and prints the table.
#include "fallback.hpp"

#include <report.hpp>

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: graze-stages FILE.svg\n", stderr);
        return 2;
    }
    try {
        const auto rates = peers::fallback_rates(1, 4000);
        std::fputs(peers::table_of(rates).c_str(), stdout);
        compare::write_picture_file(peers::picture_of(rates), "cmake --build --preset release --target draw-stages",
                                    argv[1]);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "graze-stages: %s\n", e.what());
        return 1;
    }
    return 0;
}
