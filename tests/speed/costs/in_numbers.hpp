// The formulas in a number type, unchanged.
#pragma once

#include "../plain.hpp"
#include "costs.hpp"

#include <graze/formula/solve_balls.hpp>
#include <graze/formula/solve_flat.hpp>

#include <memory>

namespace costs {

using speed::as;
using speed::decide;

template <class T>
[[nodiscard]] graze::wall<3, T> as(const graze::wall<3>& x) {
    return {as<T>(x.corner), {as<T>(x.edge[0]), as<T>(x.edge[1])}};
}

// The pairs, converted once and shared by all questions.
template <class T, class S>
[[nodiscard]] auto converted(const pairs_of<double, S>& p) {
    using shape = decltype(as<T>(p.b.front()));
    auto r = std::make_shared<pairs_of<T, shape>>();
    for (std::size_t i = 0; i < p.a.size(); ++i) {
        r->a.push_back(as<T>(p.a[i]));
        r->b.push_back(as<T>(p.b[i]));
    }
    return r;
}

template <class T>
[[nodiscard]] contestant decisions_in(const pairs& all) {
    const auto number = [](const auto& a, const auto& b) { return static_cast<int>(decide(a, b)); };
    const auto generic = converted<T>(all.generic);
    const auto grazing = converted<T>(all.grazing);
    contestant c;
    c.decide = [=] { return sum_of(*generic, number); };
    c.decide_grazing = [=] { return sum_of(*grazing, number); };
    c.encounters = [=] { return encounters_of(*grazing, [](const auto& a, const auto& b) { return decide(a, b); }); };
    return c;
}

template <class T>
[[nodiscard]] contestant all_in(const pairs& all) {
    contestant c = decisions_in<T>(all);
    c.collide = [meeting = converted<T>(all.meeting)] {
        return sum_of(*meeting, [](const auto& a, const auto& b) {
            const auto s = graze::solve<graze::variant::halved>(a, b);
            return static_cast<double>(s.time + s.position_a[0] + s.position_b[1] + s.normal[2] + s.velocity_a[0] +
                                       s.velocity_b[1]);
        });
    };
    c.collide_wall = [aimed = converted<T>(all.aimed)] {
        return sum_of(*aimed, [](const auto& a, const auto& w) {
            const auto s = graze::solve<graze::variant::halved>(a, w);
            return static_cast<double>(s.time + s.position[0] + s.point[1] + s.normal[2] + s.velocity[0]);
        });
    };
    return c;
}

} // namespace costs
