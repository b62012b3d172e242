#include "families.hpp"

#include "rounding.hpp"

#include <cmath>

namespace compare {

namespace {

template <int N>
graze::vec<N, exact> exact_vector(const graze::vec<N, double>& x) {
    return graze::make_vec<N>([&](int i) { return exact_of(x[i]); });
}

template <int N>
exact_ball<N> to_exact(const graze::ball<N, double>& b) {
    exact_ball<N> result;
    result.shape.position = exact_vector<N>(b.position);
    result.shape.velocity = exact_vector<N>(b.velocity);
    result.shape.radius = exact_of(b.radius);
    result.shape.mass = std::isinf(b.mass) ? exact(1) : exact_of(b.mass);
    result.inverse_mass = std::isinf(b.mass) ? exact(0) : exact(1 / result.shape.mass);
    return result;
}

} // namespace

std::vector<family_description> family_list() {
    std::vector<family_description> list;
    for (const families::family& f : families::all_families) {
        list.push_back(
            {std::string(f.name), std::string(f.what_makes_it_hard), !f.hardness.empty(), std::string(f.hardness)});
    }
    return list;
}

template <int N>
problem<N> to_problem(const families::pair_of_doubles<N>& pair, const std::string& group) {
    problem<N> result;
    result.group = group;
    result.hardness = pair.hardness;
    result.a = to_exact<N>(pair.a);
    switch (pair.kind) {
    case families::pair_kind::ball_ball:
        result.kind = pair_kind::ball_ball;
        result.b = to_exact<N>(pair.b);
        break;
    case families::pair_kind::ball_plane:
        result.kind = pair_kind::ball_plane;
        result.plane = {exact_vector<N>(pair.plane.point), exact_vector<N>(pair.plane.normal)};
        break;
    case families::pair_kind::ball_wall:
        result.kind = pair_kind::ball_wall;
        result.wall.corner = exact_vector<N>(pair.wall.corner);
        for (std::size_t i = 0; i < pair.wall.edge.size(); ++i) {
            result.wall.edge[i] = exact_vector<N>(pair.wall.edge[i]);
        }
        break;
    }
    return result;
}

template <int N>
std::vector<problem<N>> draw_family(const std::string& name, std::size_t count, std::uint64_t seed) {
    const families::family* found = families::find_family(name);
    if (found == nullptr) {
        std::string known;
        for (const families::family& f : families::all_families) {
            known += (known.empty() ? "" : ", ") + std::string(f.name);
        }
        throw input_error("--family: \"" + printable(name) + "\" is not a family; known are " + known);
    }
    std::vector<problem<N>> problems;
    problems.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        problems.push_back(to_problem<N>(found->draw<N>(seed, i), name));
        problems.back().name = "pair " + std::to_string(i + 1);
    }
    return problems;
}

template problem<2> to_problem<2>(const families::pair_of_doubles<2>&, const std::string&);
template problem<3> to_problem<3>(const families::pair_of_doubles<3>&, const std::string&);
template std::vector<problem<2>> draw_family<2>(const std::string&, std::size_t, std::uint64_t);
template std::vector<problem<3>> draw_family<3>(const std::string&, std::size_t, std::uint64_t);

} // namespace compare
