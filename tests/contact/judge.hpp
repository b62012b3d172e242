// Judges a contact by the oracle, component by component.
#pragma once

#include "../oracle/contact.hpp"
#include "../oracle/rounding.hpp"

#include <graze/contact/contact.hpp>
#include <graze/time/impact_time.hpp>

#include <optional>
#include <string>
#include <type_traits>

namespace judge {

// What is wrong with an answer: the names of components; empty if all are right.
struct verdict {
    oracle::encounter what = oracle::encounter::recede;
    unsigned components = 0;
    std::string wrong;
    std::string tied; // the components exactly in the middle between two numbers
};

template <class T>
void component(verdict& v, const char* name, const oracle::surd& x, T y) {
    ++v.components;
    const oracle::verdict found = oracle::judged(x, y);
    v.tied += found == oracle::verdict::tied ? std::string(name) + " " : "";
    if (found == oracle::verdict::wrong) {
        v.wrong += std::string(v.wrong.empty() ? "" : ", ") + name;
    }
}
template <int N, class T>
void component(verdict& v, const char* name, const oracle::surd_vector<N>& x, const graze::vec<N, T>& y) {
    for (int i = 0; i < N; ++i) {
        component(v, name, x[i], y[i]);
    }
}

// The same bits, or both NaN.
template <class T>
bool same(T x, T y) {
    return std::signbit(x) == std::signbit(y) && (x == y || (std::isnan(x) && std::isnan(y)));
}
template <int N, class T>
void unchanged(verdict& v, const char* name, const graze::vec<N, T>& before, const graze::vec<N, T>& after) {
    for (int i = 0; i < N; ++i) {
        ++v.components;
        if (!same(before[i], after[i])) {
            v.wrong += std::string(v.wrong.empty() ? "" : ", ") + name + " changed";
        }
    }
}

// time_of_impact's answer, rounded in each direction.
template <int N, class T>
void time(verdict& v, const oracle::answer& met, const std::optional<graze::impact_time<N, T>>& found) {
    if (found.has_value() != met.time.has_value()) {
        v.wrong = "time_of_impact";
    } else if (found) {
        v.components += 3;
        const bool right = oracle::is_rounded(*met.time, static_cast<T>(*found)) &&
                           oracle::is_rounded(*met.time, found->lower(), oracle::direction::downward) &&
                           oracle::is_rounded(*met.time, found->upper(), oracle::direction::upward);
        v.wrong += right ? "" : std::string(v.wrong.empty() ? "" : ", ") + "impact_time";
    }
}

template <class T>
mpq_class inverse(T mass) {
    return std::isinf(mass) ? mpq_class(0) : mpq_class(1 / mpq_class(static_cast<double>(mass)));
}

template <int N, class T>
verdict of(const graze::ball<N, T>& a, const graze::ball<N, T>& b, const std::optional<graze::contact<N, T>>& found,
           const std::optional<graze::impact_time<N, T>>& at) {
    const oracle::answer met = oracle::meet(a, b);
    verdict v{met.what, 0, {}, {}};
    if (found.has_value() != oracle::is_collision(met.what)) {
        v.wrong = "the encounter";
    }
    time(v, met, at);
    if (!found || !v.wrong.empty()) {
        return v;
    }
    const auto c = oracle::contact(a, b, inverse(a.mass), inverse(b.mass), met);
    component(v, "time", c.time, found->time);
    component(v, "position_a", c.position_a, found->position_a);
    component(v, "position_b", c.position_b, found->position_b);
    component(v, "normal", c.normal, found->normal);
    const bool graze = met.what == oracle::encounter::graze;
    if (graze || std::isinf(a.mass)) {
        unchanged(v, "velocity_a", a.velocity, found->velocity_a);
    } else {
        component(v, "velocity_a", c.velocity_a, found->velocity_a);
    }
    if (graze || std::isinf(b.mass)) {
        unchanged(v, "velocity_b", b.velocity, found->velocity_b);
    } else {
        component(v, "velocity_b", c.velocity_b, found->velocity_b);
    }
    return v;
}

template <int N, class T>
void compare(verdict& v, const graze::ball<N, T>& b, const oracle::wall_contact<N>& c,
             const graze::wall_contact<N, T>& found) {
    component(v, "time", c.time, found.time);
    component(v, "position", c.position, found.position);
    component(v, "point", c.point, found.point);
    component(v, "normal", c.normal, found.normal);
    if (v.what == oracle::encounter::graze) {
        unchanged(v, "velocity", b.velocity, found.velocity);
    } else {
        component(v, "velocity", c.velocity, found.velocity);
    }
}

template <int N, class T>
verdict of(const graze::ball<N, T>& b, const graze::plane<N, T>& p,
           const std::optional<graze::wall_contact<N, T>>& found, const std::optional<graze::impact_time<N, T>>& at) {
    const oracle::answer met = oracle::meet(b, p);
    verdict v{met.what, 0, {}, {}};
    if (found.has_value() != oracle::is_collision(met.what) || (found && found->feature != graze::feature::face)) {
        v.wrong = "the encounter";
    }
    time(v, met, at);
    if (found && v.wrong.empty()) {
        compare(v, b, oracle::contact(b, p, met), *found);
    }
    return v;
}

// A wall or a triangle.
template <int N, class T, class Wall>
verdict of(const graze::ball<N, T>& b, const Wall& w, const std::optional<graze::wall_contact<N, T>>& found,
           const std::optional<graze::impact_time<N, T>>& at) {
    const oracle::answer met = oracle::meet(b, w);
    verdict v{met.what, 0, {}, {}};
    if (found.has_value() != oracle::is_collision(met.what) ||
        (found && static_cast<int>(found->feature) != static_cast<int>(met.where()))) {
        v.wrong = "the encounter";
    }
    const unsigned which = met.face ? 1U : met.edges != 0 ? met.edges : met.corners;
    if (found && !met.has(static_cast<oracle::feature>(found->feature), found->index)) {
        v.wrong = "the feature's index";
    }
    time(v, met, at);
    if (found && v.wrong.empty()) {
        compare(v, b, oracle::contact(b, w, met, met.where(), std::countr_zero(which)), *found);
    }
    return v;
}

} // namespace judge
