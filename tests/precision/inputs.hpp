// Pairs to measure on: drawn from the families, or kept in files because a search found them.
#pragma once

#include <graze/precision/subject.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace precision {

using graze::precision::pair;

using any_pair = std::variant<pair<2>, pair<3>>;

// The pair's numbers in the order of the files: position, velocity, radius and mass of the ball, then of the other
// ball; or the plane's point and normal; or the corner and edges of the wall or triangle.
template <int N>
[[nodiscard]] std::vector<double> numbers_of(const pair<N>& p);
template <int N>
void set_numbers(pair<N>& p, const std::vector<double>& numbers);

// One line: what meets, the dimension, and the numbers as hexadecimal floats.
//   ball-ball 2 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1p-1 0x1p+0 0x1p+3 ...
[[nodiscard]] std::string to_line(const any_pair& p);
// Throws std::runtime_error, which says what is wrong with the line.
[[nodiscard]] any_pair from_line(const std::string& line);

// The pair as a scene that graze-compare reads. other: a second pair of balls, which are added to the scene.
[[nodiscard]] std::string to_scene(const any_pair& p, const std::string& name, const any_pair* other = nullptr);

// The pairs of one name, in order.
struct family {
    std::string name;
    std::vector<any_pair> pairs;
};

// `count` pairs of each family, the same on every machine: two in the plane, then two in space, and so on, since the
// pairs of some families come in twos.
[[nodiscard]] std::vector<family> drawn_families(std::size_t count, std::uint64_t seed);

// The family `triangles`: of each family's walls in space, the halves at their corners.
[[nodiscard]] family drawn_triangles(std::size_t count, std::uint64_t seed);

// Reads a file of kept inputs, whose name the family gets: lines as above. `#` begins a remark, and `# origin: ` the
// command that found the pairs after it; every pair must come after one. Throws std::runtime_error with file and line.
[[nodiscard]] family read_inputs(const std::filesystem::path& file);

} // namespace precision
