// What graze promises, as the precision regression measures it: no wrong decision and no misrounded number.
#pragma once

#include <graze/contact/collide_balls.hpp>
#include <graze/contact/collide_walls.hpp>
#include <graze/precision/subject.hpp>
#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_walls.hpp>

namespace graze::inline v0_1::precision {

struct exact_decision_of_balls {
    static constexpr const char* name = "classify";
    static constexpr quantity measures = quantity::encounter;
    static constexpr bool correctly_rounded = true;
    template <int N, class T>
    [[nodiscard]] answer operator()(const ball<N, T>& a, const ball<N, T>& b) const {
        return answered(classify(a, b));
    }
};

struct exact_decision_of_walls {
    static constexpr const char* name = "classify";
    static constexpr quantity measures = quantity::encounter;
    static constexpr bool correctly_rounded = true;
    template <int N, class T>
    [[nodiscard]] answer operator()(const ball<N, T>& b, const plane<N, T>& p) const {
        return answered(classify(b, p));
    }
    template <int N, class T>
    [[nodiscard]] answer operator()(const ball<N, T>& b, const wall<N, T>& w) const {
        return answered(classify(b, w));
    }
    template <class T>
    [[nodiscard]] answer operator()(const ball<3, T>& b, const triangle<T>& t) const {
        return answered(classify(b, t));
    }
};

struct rounded_contact {
    static constexpr const char* name = "collide";
    static constexpr quantity measures = quantity::time;
    static constexpr bool correctly_rounded = true;
    template <int N, class T>
    [[nodiscard]] answer operator()(const ball<N, T>& a, const ball<N, T>& b) const {
        const auto c = collide(a, b);
        if (!c) {
            return {};
        }
        return answered(quantity::time, c->time)
            .and_(quantity::position, c->position_a)
            .and_(quantity::position, c->position_b)
            .and_(quantity::normal, c->normal)
            .and_(quantity::velocity, c->velocity_a)
            .and_(quantity::velocity, c->velocity_b);
    }
    template <int N, class T>
    [[nodiscard]] answer operator()(const ball<N, T>& b, const plane<N, T>& p) const {
        return of_wall(collide(b, p));
    }
    template <int N, class T>
    [[nodiscard]] answer operator()(const ball<N, T>& b, const wall<N, T>& w) const {
        return of_wall(collide(b, w));
    }
    template <class T>
    [[nodiscard]] answer operator()(const ball<3, T>& b, const triangle<T>& t) const {
        return of_wall(collide(b, t));
    }

  private:
    template <int N, class T>
    [[nodiscard]] static answer of_wall(const std::optional<wall_contact<N, T>>& c) {
        if (!c) {
            return {};
        }
        answer a = answered(quantity::time, c->time)
                       .and_(quantity::position, c->position)
                       .and_(quantity::position, c->point)
                       .and_(quantity::normal, c->normal)
                       .and_(quantity::velocity, c->velocity);
        a.where = c->feature;
        a.index = index_unknown;
        return a;
    }
};

// T is float or double.
template <number T>
void add_decisions(subjects& list) {
    add<exact_decision_of_balls, T>(list);
    add<exact_decision_of_walls, T>(list);
    add<rounded_contact, T>(list);
}

} // namespace graze::inline v0_1::precision
