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

// The pair's numbers in the order of the files: the ball's position, velocity, radius and mass; then those of the other
// ball, or the plane's point and normal, or the wall's or triangle's corner and edges.
template <int N>
[[nodiscard]] std::vector<double> numbers_of(const pair<N>& p);
template <int N>
void set_numbers(pair<N>& p, const std::vector<double>& numbers);

// One line: what meets, the dimension, and the numbers as hexadecimal floats.
//   ball-ball 2 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1p-1 0x1p+0 0x1p+3 ...
[[nodiscard]] std::string to_line(const any_pair& p);
// std::runtime_error that says what is wrong with it.
[[nodiscard]] any_pair from_line(const std::string& line);

// As a scene that graze-compare reads. other: two balls, which are in it as well.
[[nodiscard]] std::string to_scene(const any_pair& p, const std::string& name, const any_pair* other = nullptr);

// The pairs of one name, in order.
struct family {
    std::string name;
    std::vector<any_pair> pairs;
};

// `count` pairs of each family, in the plane and in space by turns two by two, since some families come in twos; the
// same on every machine.
[[nodiscard]] std::vector<family> drawn_families(std::size_t count, std::uint64_t seed);

// The family `triangles`: the halves, at their corners, of the walls in space of the families about walls.
[[nodiscard]] family drawn_triangles(std::size_t count, std::uint64_t seed);

// A file of kept inputs: lines as above; `#` begins a remark, and `# origin: ` one that every pair must come after, the
// command that found it. Named by the file. std::runtime_error with file and line.
[[nodiscard]] family read_inputs(const std::filesystem::path& file);

} // namespace precision
