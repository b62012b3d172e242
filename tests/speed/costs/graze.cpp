#include "costs.hpp"

#include <graze/graze.hpp>

namespace costs {

contestant in_graze(const pairs& all) {
    const auto number = [](const auto& a, const auto& b) { return static_cast<int>(graze::classify(a, b)); };
    contestant c;
    c.decide = [&all, number] { return sum_of(all.generic, number); };
    c.decide_grazing = [&all, number] { return sum_of(all.grazing, number); };
    c.encounters = [&all] {
        return encounters_of(all.grazing, [](const auto& a, const auto& b) { return graze::classify(a, b); });
    };
    c.collide = [&all] {
        return sum_of(all.meeting, [](const auto& a, const auto& b) {
            const auto s = graze::collide(a, b);
            return s->time + s->position_a[0] + s->position_b[1] + s->normal[2] + s->velocity_a[0] + s->velocity_b[1];
        });
    };
    c.collide_wall = [&all] {
        return sum_of(all.aimed, [](const auto& a, const auto& w) {
            const auto s = graze::collide(a, w);
            return s->time + s->position[0] + s->point[1] + s->normal[2] + s->velocity[0];
        });
    };
    return c;
}

} // namespace costs
