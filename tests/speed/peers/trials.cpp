#include "trials.hpp"

#include "boxes.hpp"

#include "../../oracle/encounter.hpp"

#include <families/families.hpp>

#include <cmath>
#include <optional>

namespace peers {

namespace {

constexpr int grazing_bits = 46, far_bits = 27, near_bits = 40;

template <int N>
using real_vector = graze::vec<N, double>;

template <int N>
question::vector in_space(const real_vector<N>& x) {
    return {x[0], x[1], N == 3 ? x[N - 1] : 0.0};
}

template <int N>
real_vector<N> minus(const real_vector<N>& x, const real_vector<N>& y) {
    return graze::make_vec<N>([&](int i) { return x[i] - y[i]; });
}

double length(const question::vector& x) { return std::hypot(x[0], x[1], x[2]); }

// Sets a time at which the ball has passed the thing, whatever its way: a power of two, so that velocity times horizon
// is exact.
void set_horizon(question& q) {
    const double way = length(q.from) + length(q.half) + q.radius + q.other;
    q.horizon = std::exp2(std::ceil(std::log2(way / length(q.velocity))));
}

template <int N>
question question_of(const scene<N>& s) {
    question q;
    q.radius = s.a.radius;
    q.other = s.b.radius;
    q.velocity = in_space<N>(minus<N>(s.a.velocity, s.b.velocity));
    q.from = in_space<N>(minus<N>(s.a.position, s.b.position));
    set_horizon(q);
    return q;
}

// The 2N walls of a box.
template <int N>
scene<N> scene_of(const ball_and_box<N>& m) {
    scene<N> s;
    for (int i = 0; i < N; ++i) {
        const auto at = static_cast<std::size_t>(i);
        s.a.position[i] = families::make_double(m.middle[at] + m.from[at], -50);
        s.a.velocity[i] = families::make_double(m.velocity[at], -50);
        s.b.position[i] = families::make_double(m.middle[at], -50);
    }
    s.a.radius = families::make_double(m.radius, -50 - m.finer);
    const auto end = [&](int i, int sign) {
        const auto at = static_cast<std::size_t>(i);
        return families::make_double(m.middle[at] + sign * m.half[at], -50);
    };
    const auto side = [&](int i) { return families::make_double(2 * m.half[static_cast<std::size_t>(i)], -50); };
    for (int across = 0; across < N; ++across) {
        for (const int sign : {-1, 1}) {
            graze::wall<N> w{};
            std::size_t e = 0;
            for (int i = 0; i < N; ++i) {
                w.corner[i] = end(i, i == across ? sign : -1);
                if (i != across) {
                    w.edge[e++][i] = side(i);
                }
            }
            const bool degenerate = side(across == 0 ? 1 : 0) == 0; // for a segment: the two walls without length
            if (!degenerate && (side(across) != 0 || sign == 1)) {
                s.walls.push_back(w);
            }
        }
    }
    return s;
}

template <int N>
question question_of(thing what, const scene<N>& s, const ball_and_box<N>& m) {
    question q;
    q.what = what;
    q.radius = s.a.radius;
    q.velocity = in_space<N>(s.a.velocity);
    for (std::size_t i = 0; i < N; ++i) {
        q.half[i] = families::make_double(m.half[i], -50);
        q.from[i] = families::make_double(m.from[i], -50);
    }
    set_horizon(q);
    return q;
}

template <int N>
bool is_asked(const scene<N>& s, bool parting) {
    if (parting) {
        return true;
    }
    if (s.walls.empty()) {
        const auto met = oracle::meet(s.a, s.b);
        return !met.overlaps && met.pieces.front().a != 0;
    }
    bool moves = false;
    for (int i = 0; i < N; ++i) {
        moves = moves || s.a.velocity[i] != 0;
    }
    for (const auto& w : s.walls) {
        if (oracle::meet(s.a, w).overlaps) {
            return false;
        }
    }
    return moves;
}

// Whether a side of the box is touched first, and not an edge or a corner.
template <int N>
bool meets_a_side(const scene<N>& s) {
    std::optional<oracle::answer> first;
    for (const auto& w : s.walls) {
        const auto met = oracle::meet(s.a, w);
        if (met.time && (!first || oracle::compare(*met.time, *first->time) < 0)) {
            first = met;
        }
    }
    return first && first->face;
}

template <int N>
void add(trial& t, const scene<N>& s, const question& q) {
    std::get<scenes<N>>(t.exactly).all.push_back(s);
    t.questions.push_back(q);
}

// Two balls of a family of graze's, of one hardness (-1: of all).
template <int N>
trial from_family(const char* name, const char* family_name, int hardness, std::uint64_t seed, std::size_t count,
                  const char* description) {
    trial t{name, description, thing::ball, scenes<N>{}, {}, {}, {}};
    const families::family& f = *families::find_family(family_name);
    const bool parting = t.name == "parting";
    for (std::uint64_t index = 0; t.questions.size() < count; ++index) {
        const auto pair = f.draw<N>(seed, index);
        const scene<N> s{pair.a, pair.b, {}};
        if ((hardness < 0 || pair.hardness == hardness) && is_asked(s, parting)) {
            add(t, s, question_of<N>(s));
        }
    }
    return t;
}

template <int N>
trial from_boxes(const char* name, thing what, approach how, int k, std::uint64_t seed, std::size_t count,
                 const char* description, bool sides_only = false) {
    trial t{name, description, what, scenes<N>{}, {}, {}, {}};
    for (std::uint64_t index = 0; t.questions.size() < count; ++index) {
        const auto m = draw_box<N>(how, k, what == thing::edge, seed, index);
        const auto s = scene_of<N>(m);
        if (is_asked(s, how == approach::parting) && (!sides_only || meets_a_side(s))) {
            add(t, s, question_of<N>(what, s, m));
        }
    }
    return t;
}

constexpr const char* of_generic = "nothing is hard but the rounding";
constexpr const char* of_side = "the same, of what touches a side first and not an edge or a corner";
constexpr const char* of_grazing = "the least distance is that of contact but for 2^-46 of it";
constexpr const char* of_far = "about 2^27 radii apart";
constexpr const char* of_near = "the gap is 2^-40 of the radius";
constexpr const char* of_parting = "what a bounce leaves: touching but for the rounding, and parting";

template <int N>
void add_balls(std::vector<trial>& all, std::uint64_t seed, std::size_t count) {
    all.push_back(from_family<N>("generic", "generic", -1, seed, count, of_generic));
    all.push_back(from_family<N>("grazing", "grazing", grazing_bits, seed, count, of_grazing));
    all.push_back(from_family<N>("far", "far", far_bits, seed, count, of_far));
    all.push_back(from_family<N>("near contact", "near_contact", near_bits, seed, count, of_near));
    all.push_back(from_family<N>("parting", "after_bounce", -1, seed, count, of_parting));
}

template <int N>
void add_boxes(std::vector<trial>& all, thing what, std::uint64_t seed, std::size_t count) {
    all.push_back(from_boxes<N>("generic", what, approach::generic, 0, seed, count, of_generic));
    if (N == 3) {
        all.push_back(from_boxes<N>("generic side", what, approach::generic, 0, seed, count, of_side, true));
    }
    all.push_back(from_boxes<N>("grazing", what, approach::grazing, grazing_bits, seed, count, of_grazing));
    all.push_back(from_boxes<N>("far", what, approach::far, far_bits, seed, count, of_far));
    all.push_back(from_boxes<N>("near contact", what, approach::near_contact, near_bits, seed, count, of_near));
    all.push_back(from_boxes<N>("parting", what, approach::parting, 0, seed, count, of_parting));
}

// Balls in space of a family, of every hardness.
trial by_hardness(const char* name, const char* family_name, std::uint64_t seed, std::size_t count) {
    const families::family& f = *families::find_family(family_name);
    trial t{name, std::string(f.what_makes_it_hard), thing::ball, scenes<3>{}, {}, std::string(f.hardness), {}};
    for (std::uint64_t index = 0; t.questions.size() < count; ++index) {
        const auto pair = f.draw<3>(seed, index);
        const scene<3> s{pair.a, pair.b, {}};
        if (is_asked(s, false)) {
            add(t, s, question_of<3>(s));
            t.hardness.push_back(pair.hardness);
        }
    }
    return t;
}

} // namespace

std::vector<trial> trials_by_hardness(std::uint64_t seed, std::size_t count) {
    return {by_hardness("grazing", "grazing", seed, count), by_hardness("far", "far", seed, count),
            by_hardness("near contact", "near_contact", seed, count)};
}

std::vector<trial> all_trials(std::uint64_t seed, std::size_t count) {
    std::vector<trial> all;
    add_balls<2>(all, seed, count);
    add_balls<3>(all, seed, count);
    add_boxes<2>(all, thing::box, seed, count);
    add_boxes<3>(all, thing::box, seed, count);
    add_boxes<2>(all, thing::edge, seed, count);
    return all;
}

} // namespace peers
