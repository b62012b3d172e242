#include "pairs.hpp"

#include "../families/random.hpp"
#include "input_error.hpp"
#include "integer_pairs.hpp"

#include <algorithm>
#include <array>

namespace compare {

namespace {

constexpr std::size_t encounters = 5;
constexpr std::size_t kinds = pair_kind_keys.size();

std::size_t stratum_index(pair_kind kind, graze::encounter what) {
    return static_cast<std::size_t>(kind) * encounters + static_cast<std::size_t>(what);
}

constexpr std::size_t drawn_at_first = 400'000;

template <int N>
std::size_t standing(const exact_scene<N>& scene) {
    return scene.planes.size() + scene.walls.size() + scene.triangles.size();
}

struct place_of_pair {
    pair_kind kind;
    std::size_t i, j; // ball i with ball, plane, wall or triangle j
};

// The pairs of a scene in a fixed order: each ball with the balls after it, then with the planes, walls and triangles.
// Either all of them or some drawn at random. Two infinite masses are not a pair.
template <int N>
class classified_pairs {
  public:
    classified_pairs(const exact_scene<N>& scene, families::random& random, std::uint64_t most) : scene_(scene) {
        std::uint64_t last = 0;
        for (std::size_t i = 0; i < scene.balls.size(); ++i) {
            last += scene.balls.size() - 1 - i + standing(scene);
            last_of_ball_.push_back(last);
        }
        if (last <= most) {
            return;
        }
        for (std::size_t n = 0; n < drawn_at_first; ++n) {
            drawn_.push_back(random.below(last));
        }
        std::sort(drawn_.begin(), drawn_.end());
        drawn_.erase(std::unique(drawn_.begin(), drawn_.end()), drawn_.end());
    }

    template <class F>
    void for_each(F f) const {
        const auto give = [&](const place_of_pair& p) {
            const auto infinite = [&](std::size_t k) { return scene_.balls[k].inverse_mass.is_zero(); };
            if (p.kind != pair_kind::ball_ball || !infinite(p.i) || !infinite(p.j)) {
                f(p);
            }
        };
        if (!drawn_.empty()) {
            std::for_each(drawn_.begin(), drawn_.end(), [&](std::uint64_t index) { give(at(index)); });
            return;
        }
        for (std::size_t i = 0; i < scene_.balls.size(); ++i) {
            const std::uint64_t others = last_of_ball_[i] - (i == 0 ? 0 : last_of_ball_[i - 1]);
            for (std::uint64_t j = 0; j < others; ++j) {
                give(of_ball(i, j));
            }
        }
    }

  private:
    const exact_scene<N>& scene_;
    std::vector<std::uint64_t> last_of_ball_, drawn_;

    [[nodiscard]] place_of_pair at(std::uint64_t index) const {
        const auto ball = std::upper_bound(last_of_ball_.begin(), last_of_ball_.end(), index);
        return of_ball(static_cast<std::size_t>(ball - last_of_ball_.begin()),
                       index - (ball == last_of_ball_.begin() ? 0 : *(ball - 1)));
    }
    [[nodiscard]] place_of_pair of_ball(std::size_t i, std::uint64_t other) const {
        const std::size_t later = scene_.balls.size() - 1 - i;
        auto j = static_cast<std::size_t>(other);
        if (j < later) {
            return {pair_kind::ball_ball, i, i + 1 + j};
        }
        j -= later;
        if (j < scene_.planes.size()) {
            return {pair_kind::ball_plane, i, j};
        }
        j -= scene_.planes.size();
        return j < scene_.walls.size() ? place_of_pair{pair_kind::ball_wall, i, j}
                                       : place_of_pair{pair_kind::ball_triangle, i, j - scene_.walls.size()};
    }
};

template <int N>
graze::encounter decide(const integer_scene<N>& scene, const place_of_pair& p) {
    const auto [kind, i, j] = p;
    switch (kind) {
    case pair_kind::ball_plane:
        return encounter_with_plane<N>(scene.balls[i], scene.planes[j]);
    case pair_kind::ball_wall:
        return encounter_with_wall<N>(scene.balls[i], scene.walls[j]);
    case pair_kind::ball_triangle:
        if constexpr (N == 3) {
            return encounter_with_triangle(scene.balls[i], scene.triangles[j]);
        }
        [[fallthrough]];
    default:
        return encounter_of_balls<N>(scene.balls[i], scene.balls[j]);
    }
}

template <int N>
problem<N> make_problem(const exact_scene<N>& scene, const place_of_pair& p, const std::string& group) {
    const auto [kind, i, j] = p;
    problem<N> result;
    result.kind = kind;
    result.group = group;
    const std::string other = std::string(key_of(kind)).substr(5); // after "ball_"
    result.name = "ball " + std::to_string(i) + " and " + other + " " + std::to_string(j);
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
    case pair_kind::ball_triangle:
        if constexpr (N == 3) {
            result.wall = {scene.triangles[j].corner, scene.triangles[j].edge};
        }
        break;
    }
    return result;
}

// Gives each stratum an equal share of `largest`, or all of its pairs if they are fewer. The smallest come first, so
// that the others share what these leave.
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
    constexpr std::array<const char*, kinds> names = {"ball-ball", "ball-plane", "ball-wall", "ball-triangle"};
    return names[static_cast<std::size_t>(kind)];
}

template <int N>
scene_pairs<N> pairs_of(const exact_scene<N>& scene, const std::string& group, std::size_t largest,
                        std::uint64_t seed) {
    std::array<stratum, kinds * encounters> strata{};
    for (std::size_t i = 0; i < strata.size(); ++i) {
        strata[i] = {static_cast<pair_kind>(i / encounters), static_cast<graze::encounter>(i % encounters), 0, 0};
    }
    scene_pairs<N> result;
    const auto infinite = static_cast<std::uint64_t>(std::count_if(
        scene.balls.begin(), scene.balls.end(), [](const exact_ball<N>& b) { return b.inverse_mass.is_zero(); }));
    result.both_infinite = infinite * (infinite == 0 ? 0 : infinite - 1) / 2;
    const std::uint64_t balls = scene.balls.size();
    result.total = balls * (balls - 1) / 2 + balls * standing(scene) - result.both_infinite;
    if (largest == every_pair && result.total > most_measured) {
        throw input_error("--all: the scene has " + std::to_string(result.total) +
                          " pairs, more than the 1000000 that can be measured; without --all a sample is");
    }

    families::random random(seed);
    const classified_pairs<N> all(scene, random, most_classified);
    const integer_scene<N> integers = to_integers<N>(scene);
    std::vector<unsigned char> stratum_of;
    all.for_each([&](const place_of_pair& p) {
        const std::size_t index = stratum_index(p.kind, decide<N>(integers, p));
        ++strata[index].total;
        stratum_of.push_back(static_cast<unsigned char>(index));
    });
    result.classified = stratum_of.size();
    share_out(strata, std::min<std::uint64_t>(largest, result.classified));

    // Takes each pair with the probability that fills its stratum (selection sampling, Knuth's algorithm S).
    std::array<stratum, kinds* encounters> left = strata;
    std::size_t at = 0;
    all.for_each([&](const place_of_pair& p) {
        stratum& here = left[stratum_of[at++]];
        if (here.taken != 0 && random.below(here.total) < here.taken) {
            result.pairs.push_back(make_problem<N>(scene, p, group));
            --here.taken;
        }
        --here.total;
    });
    std::copy_if(strata.begin(), strata.end(), std::back_inserter(result.strata),
                 [](const stratum& s) { return s.total != 0; });
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
    case pair_kind::ball_triangle:
        if constexpr (N == 3) {
            scene.triangles.push_back({pair.wall.corner, pair.wall.edge});
        }
        break;
    }
    return decide<N>(to_integers<N>(scene), {pair.kind, 0, other});
}

template scene_pairs<2> pairs_of<2>(const exact_scene<2>&, const std::string&, std::size_t, std::uint64_t);
template scene_pairs<3> pairs_of<3>(const exact_scene<3>&, const std::string&, std::size_t, std::uint64_t);
template graze::encounter encounter_of_pair<2>(const problem<2>&);
template graze::encounter encounter_of_pair<3>(const problem<3>&);

} // namespace compare
