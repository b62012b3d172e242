// Writes the scenes of this folder: generate DIRECTORY.
//
// Everything is computed in integers, so that the files are the same, byte for byte, wherever this is compiled and run.
#include "../families/random.hpp"
#include "billiards.hpp"
#include "scene_text.hpp"

#include <array>
#include <fstream>
#include <iostream>

namespace scenes {

namespace {

// The smallest root with root^power >= x.
std::int64_t root_above(std::int64_t x, int power) {
    std::int64_t low = 0, high = power == 2 ? 3'000'000'000 : 2'000'000; // high^power fits
    while (low < high) {
        const std::int64_t middle = low + (high - low) / 2;
        if ((power == 2 ? middle * middle : middle * middle * middle) < x) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

// The break on a 9-foot table in metres, metres per second and kilograms. The distance of the rack's rows is the balls'
// diameter times √3/2, rounded up to 10^-10 m, so that no two balls overlap: along a row they touch; between rows there
// is a gap of a tenth of a nanometre.
std::string pool_break() {
    constexpr std::int64_t unit = 10'000'000'000; // 10^-10 m
    constexpr std::int64_t diameter = 571'500'000, length = unit * 254 / 100, width = unit * 127 / 100;
    scene_text scene(
        2, "pool break",
        "The break of a 9-foot pool table: 2.54 m by 1.27 m between the cushions, balls of 57.15 mm and 0.17 kg, a "
        "tight rack on the foot spot, the cue ball at 10 m/s. Cushions are walls; pockets are left out.");
    const auto ball = [&](std::int64_t x, std::int64_t y, const std::string& velocity) {
        scene.ball(vector_text({x, y}, 10), velocity, decimal(diameter / 2, 10), "0.17");
    };
    ball(length / 4, unit * 551 / 1000, "[\"8990/901\", \"600/901\"]"); // 899² + 60² = 901²
    const std::int64_t row = root_above(diameter * diameter / 4 * 3, 2);
    for (std::int64_t i = 0; i < 5; ++i) {
        for (std::int64_t j = 0; j <= i; ++j) {
            ball(length / 4 * 3 + i * row, width / 2 + (2 * j - i) * (diameter / 2), "[0, 0]");
        }
    }
    const auto cushion = [&](const components& corner, const components& edge) {
        scene.wall(vector_text(corner, 10), {vector_text(edge, 10)});
    };
    cushion({0, 0}, {length, 0});
    cushion({length, 0}, {0, width});
    cushion({0, width}, {length, 0});
    cushion({0, 0}, {0, width});
    return scene.text();
}

// 5 · 5 · 5 face-centred cubic cells of balls of diameter 1 in a cubic box. In a Maxwell distribution components are
// normally distributed. Here each is a sum of 12 uniform numbers less its mean, of variance 1 (Irwin and Hall), which
// never exceeds 6.
std::string hard_sphere_fluid() {
    constexpr std::int64_t unit = 100'000;                   // 10^-5
    constexpr std::int64_t volume = 872'664'625'997'164'788; // 500 · (π/6) / 0.3, in 10^-15
    const std::int64_t side = root_above(volume, 3);         // of the box
    constexpr std::int64_t margin = unit * 55 / 100;         // of the outermost centres: a gap of 0.05
    const std::int64_t spacing = (side - 2 * margin) / 9;    // of the ten layers each way
    scene_text scene(3, "hard-sphere fluid",
                     "500 hard spheres of diameter 1 on a face-centred cubic lattice in a cubic box, with a packing "
                     "fraction of 0.3 and Maxwell velocities of variance 1 a component. Reduced units.");
    families::random random(500);
    const auto normal = [&] {
        std::int64_t sum = 0;
        for (int i = 0; i < 12; ++i) {
            sum += random.in(0, 999'999);
        }
        return sum - 5'999'994;
    };
    for (std::int64_t x = 0; x < 10; ++x) {
        for (std::int64_t y = 0; y < 10; ++y) {
            for (std::int64_t z = (x + y) % 2; z < 10; z += 2) {
                const components position{margin + x * spacing, margin + y * spacing, margin + z * spacing};
                const std::int64_t ux = normal(), uy = normal(), uz = normal();
                scene.ball(vector_text(position, 5), vector_text({ux, uy, uz}, 6), "0.5", "");
            }
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<components, 2> edges{components{0, 0, 0}, components{0, 0, 0}};
        edges[0][(axis + 1) % 3] = side;
        edges[1][(axis + 2) % 3] = side;
        components far{0, 0, 0};
        far[axis] = side;
        for (const components& corner : {components{0, 0, 0}, far}) {
            scene.wall(vector_text(corner, 5), {vector_text(edges[0], 5), vector_text(edges[1], 5)});
        }
    }
    return scene.text();
}

// Four beams of grains from each end of a corridor of 1 km. It is so narrow that any two grains that fly head-on pass
// each other within four radii. At a distance of about 10^8 radii, telling a hit from a miss takes 8 digits of the
// velocity.
std::string long_corridor() {
    constexpr std::int64_t micrometre = 1'000'000; // in 10^-12 m
    constexpr std::int64_t metre = 1'000'000 * micrometre;
    constexpr std::int64_t radius = 5 * micrometre;
    scene_text scene(3, "long corridor",
                     "Dust grains of 10 micrometres in vacuum, in beams from both ends of a corridor of 1 km by 2 m by "
                     "2 m: distances "
                     "of 10^8 radii. SI units, all masses 1.");
    families::random random(8);
    for (int beam = 0; beam < 4; ++beam) {
        // In 10^-12 of 10 m/s. The direction varies so little that a flight of 50 s stays inside the corridor.
        const components u{metre + random.signed_bits(29), random.signed_bits(29), random.signed_bits(29)};
        const components middle{500 * metre, random.in(metre * 3 / 5, metre * 7 / 5),
                                random.in(metre * 3 / 5, metre * 7 / 5)};
        for (int grain = 0; grain < 12; ++grain) {
            const std::int64_t sense = grain % 2 == 0 ? -1 : 1;
            const std::int64_t steps = sense * (490 + grain / 2); // of a tenth of a second, before the middle
            components position(3), velocity(3);
            for (std::size_t i = 0; i < 3; ++i) {
                position[i] = middle[i] + steps * u[i] + (i == 0 ? 0 : random.in(-radius, radius));
                velocity[i] = -sense * u[i];
            }
            scene.ball(vector_text(position, 12), vector_text(velocity, 11), decimal(radius, 12), "");
        }
    }
    scene.plane("[0, 0, 0]", "[0, 0, 1]");
    scene.plane("[0, 0, 2]", "[0, 0, 1]");
    scene.plane("[0, 0, 0]", "[0, 1, 0]");
    scene.plane("[0, 2, 0]", "[0, 1, 0]");
    scene.wall("[0, 0, 0]", {"[0, 2, 0]", "[0, 0, 2]"});
    scene.wall("[1000, 0, 0]", {"[0, 2, 0]", "[0, 0, 2]"});
    return scene.text();
}

// A shot past a feature of the pocket: the centre passes `point` at a distance of r(1 + ε), measured along `aside` (of
// length 25), in the direction `along` (of length 25, perpendicular to it).
struct shot {
    std::array<std::int64_t, 3> point, aside, along;
};

// A pool table's corner pocket: the cushions' ends, 37 mm high, leave a mouth of 4.5 inches, and facings lead into the
// pocket.
std::string corner_pocket() {
    constexpr std::int64_t millimetre = 1'000'000'000'000; // in 10^-15 m
    constexpr std::int64_t radius = 28'575 * (millimetre / 1000);
    constexpr std::int64_t jaw = 808 * (millimetre / 10), nose = 37 * millimetre, far = 1270 * millimetre;
    constexpr std::int64_t back_x = 414 * (millimetre / 10), back_y = -308 * (millimetre / 10);
    scene_text scene(3, "corner pocket",
                     "The corner pocket of a pool table, of cushions, facings, a back and the bed, and balls of 57.15 "
                     "mm and 0.17 kg "
                     "shot at 2.5 m/s past the cushions' upper edges, the jaws' vertical edges and their upper "
                     "corners, at distances from "
                     "0.9 to 1.1 radii, of which some are exactly one radius. Metres, seconds, kilograms.");
    const std::array<shot, 8> shots{{
        {{far / 2, 0, nose}, {0, 0, 25}, {7, -24, 0}},       // over the long cushion, level
        {{far / 3, 0, nose}, {0, -15, 20}, {0, -20, -15}},   // over it from above
        {{0, far / 2, nose}, {0, 0, 25}, {-24, -7, 0}},      // over the other
        {{0, far / 4, nose}, {-15, 0, 20}, {-16, -15, -12}}, // over it from above, aslant
        {{jaw, 0, nose / 2}, {-20, 15, 0}, {-15, -20, 0}},   // past a jaw
        {{0, jaw, nose / 2}, {7, -24, 0}, {-24, -7, 0}},     // past the other
        {{jaw, 0, nose}, {-12, 9, 20}, {-15, -20, 0}},       // past a jaw's upper corner
        {{0, jaw, nose}, {12, -16, 15}, {-16, -12, 0}},      // past the other's
    }};
    constexpr std::array<std::int64_t, 6> excess{-radius / 10, -2850,      0, 0,
                                                 2850,         radius / 10}; // of the distance; 2850 is 10^-10 r
    for (const shot& s : shots) {
        std::int64_t back = 150; // millimetres along the path, before the point
        for (const std::int64_t e : excess) {
            components position(3), velocity(3);
            for (std::size_t i = 0; i < 3; ++i) {
                position[i] = s.point[i] + s.aside[i] * ((radius + e) / 25) - s.along[i] * (back * millimetre / 25);
                velocity[i] = s.along[i];
            }
            back += 70;
            scene.ball(vector_text(position, 15), vector_text(velocity, 1), decimal(radius, 15), "0.17");
        }
    }
    scene.plane("[0, 0, 0]", "[0, 0, 1]");
    const auto wall = [&](const components& from, const components& edge) {
        scene.wall(vector_text(from, 15), {vector_text(edge, 15), vector_text({0, 0, nose}, 15)});
    };
    wall({jaw, 0, 0}, {far - jaw, 0, 0});
    wall({0, jaw, 0}, {0, far - jaw, 0});
    wall({jaw, 0, 0}, {back_x - jaw, back_y, 0});
    wall({0, jaw, 0}, {back_y, back_x - jaw, 0});
    wall({back_x, back_y, 0}, {back_y - back_x, back_x - back_y, 0});
    return scene.text();
}

} // namespace
} // namespace scenes

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: " << arguments[0] << " DIRECTORY\n";
        return 2;
    }
    const std::string directory = arguments[1];
    const std::array<std::pair<const char*, std::string>, 8> files{{{"pool_break", scenes::pool_break()},
                                                                    {"hard_sphere_fluid", scenes::hard_sphere_fluid()},
                                                                    {"long_corridor", scenes::long_corridor()},
                                                                    {"corner_pocket", scenes::corner_pocket()},
                                                                    {"photon", scenes::photon()},
                                                                    {"sinai", scenes::sinai()},
                                                                    {"newtons_cradle", scenes::newtons_cradle()},
                                                                    {"galperin", scenes::galperin()}}};
    for (const auto& [name, text] : files) {
        std::ofstream out(directory + "/" + name + ".json", std::ios::binary);
        out << text;
        if (!out.flush()) {
            std::cerr << arguments[0] << ": cannot write " << directory << "/" << name << ".json\n";
            return 1;
        }
    }
}
