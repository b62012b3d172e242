// What time/flat_steps.hpp loses in sums and products. The same formulas in word_rounding, whose steps are its steps,
// lose less than the part that it allows: 2^-97 of the sizes of what is added up, for a face 2^-98.
#include <graze/analysis/word_rounding.hpp>
#include <graze/linear/vec.hpp>

namespace {

using namespace graze;
using word = detail::word_rounding;

constexpr double taken = 0x1p-97;

template <int N>
constexpr vec<N, word> vector(const word& x) {
    return make_vec<N>([&](int) { return x; });
}
// x - q for a corner q, which is up to two edges from the wall's corner, moved by u t.
template <int N>
constexpr vec<N, word> moved() {
    auto y = vector<N>(word::exact_input());
    for (int i = 0; i + 1 < N; ++i) {
        y = y - vector<N>(word::exact_double());
    }
    return y + vector<N>(word::exact_double() * word::exact_double());
}
// The product of the edges, and the edge that is a difference.
constexpr vec<3, word> normal() { return cross(vector<3>(word::exact_double()), vector<3>(word::exact_double())); }
constexpr vec<3, word> edge() { return vector<3>(word::exact_input()); }

// The height above a plane or a face, and n·n.
static_assert(dot(moved<3>(), normal()).bound() < taken &&
              dot(moved<2>(), vector<2>(word::exact_double())).bound() < taken);
static_assert(squared_norm(normal()).bound() < taken / 8);
// With r|n|, of which the root of n·n leaves its own part beside these: see below.
constexpr double of_rest = (dot(moved<3>(), normal()) - word::exact_double() * word::exact_input()).bound();

// |y|² - r² and |y × d|² - r² d·d.
constexpr word square_of_radius = word::exact_double() * word::exact_double();
static_assert((squared_norm(moved<3>()) - square_of_radius).bound() < taken);
static_assert((squared_norm(cross(moved<3>(), edge())) - square_of_radius * squared_norm(edge())).bound() < taken);

// The root. n·n = s + l, |l| <= low u N² and off by error u² N². With √s = ρ (1 + δ), |δ| <= u, and κ = N/|n| >= 1 the
// correction (s - ρ² + l)/2ρ leaves (s - ρ² + l)²/8ρ³, half the error of n·n over |n|, and the roundings of its
// numerator, three of at most (2 + low κ²) u |n|². Taken as (s - ρ² + l)/2 · (ρ · 1/s) it is off by three more
// roundings, each half as much, and by ρ²/s, a part 2u. All that is of u² N κ³ at most
constexpr double of_root(const word& square) {
    const double rest = 2 + square.low; // (s - ρ² + l)/u|n|², over κ²
    return rest * rest / 8 + square.error / 2 + 4 * rest;
}
static_assert(of_rest + 1.01 * 0x1p-106 * of_root(squared_norm(normal())) < taken / 2);

} // namespace
