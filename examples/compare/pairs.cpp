#include "pairs.hpp"

#include "../families/random.hpp"
#include "integer_pairs.hpp"

#include <algorithm>
#include <array>

namespace compare {

namespace {

constexpr std::size_t encounters = 5;
constexpr std::size_t kinds = 3;

std::size_t stratum_index(pair_kind kind, graze::encounter what) {
    return static_cast<std::size_t>(kind) * encounters + static_cast<std::size_t>(what);
}

// Calls f(kind, i, j) for each pair in a fixed order: ball i with ball, plane or wall j.
template <int N, class F>
void for_each_pair(const exact_scene<N>& scene, F f) {
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        for (std::size_t j = i + 1; j < scene.balls.size(); ++j) {
            if (scene.balls[i].inverse_mass.is_zero() && scene.balls[j].inverse_mass.is_zero()) {
                continue;
            }
            f(pair_kind::ball_ball, i, j);
        }
        for (std::size_t j = 0; j < scene.planes.size(); ++j) {
            f(pair_kind::ball_plane, i, j);
        }
        for (std::size_t j = 0; j < scene.walls.size(); ++j) {
            f(pair_kind::ball_wall, i, j);
        }
    }
}

template <int N>
graze::encounter decide(const integer_scene<N>& scene, pair_kind kind, std::size_t i, std::size_t j) {
    switch (kind) {
    case pair_kind::ball_plane:
        return encounter_with_plane<N>(scene.balls[i], scene.planes[j]);
    case pair_kind::ball_wall:
        return encounter_with_wall<N>(scene.balls[i], scene.walls[j]);
    default:
        return encounter_of_balls<N>(scene.balls[i], scene.balls[j]);
    }
}

template <int N>
problem<N> make_problem(const exact_scene<N>& scene, pair_kind kind, std::size_t i, std::size_t j,
                        const std::string& group) {
    problem<N> result;
    result.kind = kind;
    result.group = group;
    result.a = scene.balls[i];
    switch (kind) {
    case pair_kind::ball_ball:
        result.b = scene.balls[j];
        break;
    case pair_kind::ball_plane:
        result.plane = scene.planes[j];
        break;
    case pair_kind::ball_wall:
        result.wall = scene.walls[j];
        break;
    }
    return result;
}

// An equal share of `largest` to each, or all that it has; the smaller ones first, so that what they leave is shared by
// the others.
void share_out(std::array<stratum, kinds * encounters>& strata, std::uint64_t largest) {
    std::array<stratum*, kinds * encounters> by_size{};
    std::transform(strata.begin(), strata.end(), by_size.begin(), [](stratum& s) { return &s; });
    std::sort(by_size.begin(), by_size.end(),
              [](const stratum* x, const stratum* y) { return x->total != y->total ? x->total < y->total : x < y; });
    std::uint64_t left = by_size.size();
    for (stratum* s : by_size) {
        s->taken = std::min(s->total, largest / left);
        largest -= s->taken;
        --left;
    }
}

} // namespace

const char* to_string(pair_kind kind) noexcept {
    return kind == pair_kind::ball_ball ? "ball-ball" : kind == pair_kind::ball_plane ? "ball-plane" : "ball-wall";
}

template <int N>
scene_pairs<N> pairs_of(const exact_scene<N>& scene, const std::string& group, std::size_t largest,
                        std::uint64_t seed) {
    std::array<stratum, kinds * encounters> strata{};
    for (std::size_t i = 0; i < strata.size(); ++i) {
        strata[i] = {static_cast<pair_kind>(i / encounters), static_cast<graze::encounter>(i % encounters), 0, 0};
    }
    scene_pairs<N> result;
    const integer_scene<N> integers = to_integers<N>(scene);
    std::vector<unsigned char> stratum_of;
    for_each_pair<N>(scene, [&](pair_kind kind, std::size_t i, std::size_t j) {
        const std::size_t index = stratum_index(kind, decide<N>(integers, kind, i, j));
        ++strata[index].total;
        stratum_of.push_back(static_cast<unsigned char>(index));
    });
    result.total = stratum_of.size();
    share_out(strata, std::min<std::uint64_t>(largest, result.total));

    // Each pair is taken with the chance that fills its stratum (selection sampling, Knuth's algorithm S).
    families::random random(seed);
    std::array<stratum, kinds* encounters> left = strata;
    std::size_t at = 0;
    for_each_pair<N>(scene, [&](pair_kind kind, std::size_t i, std::size_t j) {
        stratum& here = left[stratum_of[at++]];
        if (here.taken != 0 && random.below(here.total) < here.taken) {
            result.pairs.push_back(make_problem<N>(scene, kind, i, j, group));
            --here.taken;
        }
        --here.total;
    });
    std::copy_if(strata.begin(), strata.end(), std::back_inserter(result.strata),
                 [](const stratum& s) { return s.total != 0; });

    const auto infinite = static_cast<std::uint64_t>(std::count_if(
        scene.balls.begin(), scene.balls.end(), [](const exact_ball<N>& b) { return b.inverse_mass.is_zero(); }));
    result.both_infinite = infinite * (infinite == 0 ? 0 : infinite - 1) / 2;
    return result;
}

template <int N>
graze::encounter encounter_of_pair(const problem<N>& pair) {
    exact_scene<N> scene;
    scene.balls.push_back(pair.a);
    std::size_t other = 0;
    switch (pair.kind) {
    case pair_kind::ball_ball:
        scene.balls.push_back(pair.b);
        other = 1;
        break;
    case pair_kind::ball_plane:
        scene.planes.push_back(pair.plane);
        break;
    case pair_kind::ball_wall:
        scene.walls.push_back(pair.wall);
        break;
    }
    return decide<N>(to_integers<N>(scene), pair.kind, 0, other);
}

template scene_pairs<2> pairs_of<2>(const exact_scene<2>&, const std::string&, std::size_t, std::uint64_t);
template scene_pairs<3> pairs_of<3>(const exact_scene<3>&, const std::string&, std::size_t, std::uint64_t);
template graze::encounter encounter_of_pair<2>(const problem<2>&);
template graze::encounter encounter_of_pair<3>(const problem<3>&);

} // namespace compare
