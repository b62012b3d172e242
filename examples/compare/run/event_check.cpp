#include "event_check.hpp"

#include "check_words.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace compare::run {

namespace {

constexpr long few_bits = 96;

template <int N>
graze::flight<N, certified> coarsened(const graze::flight<N, certified>& a) {
    const auto vector = [](const vector_of<N>& x) {
        return graze::make_vec<N>([&](int i) { return x[i].rounded(few_bits); });
    };
    return {{vector(a.state.position), vector(a.state.velocity), a.state.radius.rounded(few_bits), a.state.mass},
            a.since.rounded(few_bits)};
}

} // namespace

template <int N>
event_check<N>::event_check(const owned_scene<N, certified>& scene) : scene_(scene), space_(scene.period) {
    const auto reach = [&](const vector_of<N>& x) {
        for (int i = 0; i < N; ++i) {
            size_ = std::max(size_, std::abs(near_double(x[i])));
        }
    };
    for (const auto& b : scene.balls) {
        const flight f{b, certified(0)};
        movers_.push_back({f, coarsened<N>(f), {}, {}, {}, b.mass.is_infinite(), is_zero<N>(b.velocity)});
        reach(b.position);
        size_ = std::max(size_, near_double(b.radius));
    }
    const auto reach_of_flat = [&](const auto& w) {
        reach(w.corner);
        reach(w.edge[0]);
    };
    std::for_each(scene.walls.begin(), scene.walls.end(), reach_of_flat);
    if constexpr (N == 3) {
        std::for_each(scene.triangles.begin(), scene.triangles.end(), reach_of_flat);
    }
}

template <int N>
graze::scene_pair event_check<N>::named(int a, std::size_t standing) const {
    if (standing < scene_.planes.size()) {
        return {graze::partner::plane, a, static_cast<int>(standing)};
    }
    return standing < first_triangle()
               ? graze::scene_pair{graze::partner::wall, a, static_cast<int>(standing - scene_.planes.size())}
               : graze::scene_pair{graze::partner::triangle, a, static_cast<int>(standing - first_triangle())};
}

template <int N>
std::size_t event_check<N>::standing_of(const graze::scene_pair& who) const {
    return static_cast<std::size_t>(who.b) + (who.with == graze::partner::plane  ? 0
                                              : who.with == graze::partner::wall ? scene_.planes.size()
                                                                                 : first_triangle());
}

template <int N>
void event_check<N>::event(const graze::scene_pair& who, const certified& t, const flight& a, const flight* b) {
    const image periods = image_at(who, t);
    check_place(who, periods, t);
    check_laws(who, periods, t, a, b);
    check_way(who.a, t, &who, periods);
    if (b != nullptr) {
        image back{};
        std::transform(periods.begin(), periods.end(), back.begin(), std::negate<>());
        check_way(who.b, t, &who, back);
    }
    start(who.a, a, t, who);
    if (b != nullptr) {
        start(who.b, *b, t, who);
    }
}

template <int N>
void event_check<N>::start(int a, const flight& f, const certified& t, const graze::scene_pair& who) {
    mover& x = movers_[static_cast<std::size_t>(a)];
    if (x.immovable) {
        return;
    }
    if (is_point(x)) {
        note_sides(a, t, who);
    }
    x.before = std::exchange(x.now, f);
    x.coarse = coarsened<N>(f);
    x.last = who;
    if (who.with == graze::partner::ball && who.b < who.a) {
        std::swap(x.last->a, x.last->b);
    }
    x.at_rest = is_zero<N>(f.state.velocity);
    check_overtaken(a, t, who);
}

template <int N>
void event_check<N>::end(const certified& t) {
    for (int a = 0; a < static_cast<int>(movers_.size()); ++a) {
        check_way(a, t, nullptr);
    }
}

template <int N>
void event_check<N>::end_of_all() {
    for (int a = 0; a < static_cast<int>(movers_.size()); ++a) {
        for (int b = 0; b < a; ++b) {
            check_pair(a, b, nullptr, nullptr);
        }
        for (std::size_t b = 0; b < standing(); ++b) {
            check_standing(a, b, nullptr, nullptr);
        }
    }
}

template class event_check<2>;
template class event_check<3>;

} // namespace compare::run
