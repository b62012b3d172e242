// Flights: predictions, the order of their times, and contacts, compared with the same formulas in plain doubles and
// with balls of one epoch.
#include "speed.hpp"

#include <graze/collide.hpp>
#include <graze/formula/impulse.hpp>

#include <algorithm>
#include <cmath>

namespace speed {

namespace {

using flight = graze::flight<3>;

struct flights {
    std::vector<flight> a, b;
};

// The generic pairs. In each, one ball started up to 8 units of time before the other, and at the later start it is
// where it should be, except for rounding.
const flights& generic_flights(bool hits_only) {
    const auto draw = [](bool only) {
        flights f;
        const pairs& p = generic_pairs();
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (only && graze::classify(p.a[i], p.b[i]) != graze::encounter::hit) {
                continue;
            }
            families::random r(20261126, i);
            const double epoch = 100 + std::ldexp(static_cast<double>(r.signed_bits(53)), -50);
            const double lead = std::fabs(std::ldexp(static_cast<double>(r.signed_bits(53)), -50));
            flight a{p.a[i], epoch}, b{p.b[i], epoch};
            flight& earlier = r.one_in(2) ? a : b;
            earlier.since -= lead;
            earlier.state.position = earlier.state.position - lead * earlier.state.velocity;
            a.state.mass = 1 + std::ldexp(static_cast<double>(r.in(1, 1 << 20)), -20);
            b.state.mass = 1 + std::ldexp(static_cast<double>(r.in(1, 1 << 20)), -20);
            f.a.push_back(a);
            f.b.push_back(b);
        }
        return f;
    };
    static const flights all = draw(false);
    static const flights hits = draw(true);
    return hits_only ? hits : all;
}

// The same formulas in doubles; infinity if they do not meet.
struct plain_prediction {
    graze::relative_motion<3, double, double, double> motion;
    double start, time;
};
plain_prediction plain(const flight& a, const flight& b) {
    const auto m = graze::relative_motion_of(a, b);
    const double start = std::max(a.since, b.since);
    const double h = graze::coefficient_h{}(m);
    if (h >= 0) {
        return {m, start, INFINITY};
    }
    const double c = graze::coefficient_c{}(m);
    if (c < 0) {
        return {m, start, 0};
    }
    const double d =
        graze::discriminant_halved{}(graze::quadratic<double, double, double>{graze::coefficient_a{}(m), h, c});
    return {m, start, d < 0 ? INFINITY : graze::root_stable{}(c, h, std::sqrt(d))};
}

bool plain_contact(graze::contact<3>& x, const flight& a, const flight& b) {
    const auto p = plain(a, b);
    if (std::isinf(p.time)) {
        return false;
    }
    x.time = p.start + p.time;
    x.position_a = graze::position_at(a.state.position, a.state.velocity, x.time - a.since);
    x.position_b = graze::position_at(b.state.position, b.state.velocity, x.time - b.since);
    x.normal = graze::contact_normal(graze::position_at(p.motion.dx, p.motion.du, p.time), p.motion.R);
    const double inverse_a = 1 / a.state.mass;
    const double inverse_b = 1 / b.state.mass;
    const double alpha = graze::impulse(graze::reduced_mass(inverse_a, inverse_b), x.normal, p.motion.du);
    x.velocity_a = graze::velocity_after(a.state.velocity, alpha, inverse_a, x.normal);
    x.velocity_b = graze::velocity_after(b.state.velocity, -alpha, inverse_b, x.normal);
    return true;
}

} // namespace

void register_flights() {
    const flights& f = generic_flights(false);
    const std::size_t count = f.a.size();
    const pairs& p = generic_pairs();
    compare("predict two flights", "plain double", count,
            [&f](std::size_t i) { return plain(f.a[i], f.b[i]).time < 1e3; });
    compare("predict two flights", "graze::classify", count,
            [&f](std::size_t i) { return graze::is_collision(graze::classify(f.a[i], f.b[i])); });
    compare("predict two flights", "graze::time_of_impact", count, [&f](std::size_t i) {
        const auto t = graze::time_of_impact(f.a[i], f.b[i]);
        return t && t->about() < 1e3;
    });
    compare("predict two flights", "graze::time_of_impact of balls", count, [&p](std::size_t i) {
        const auto t = graze::time_of_impact(p.a[i], p.b[i]);
        return t && *t < 1e3;
    });

    const flights& h = generic_flights(true);
    static const std::vector<graze::impact_time<3>> kept = [&h] {
        std::vector<graze::impact_time<3>> r;
        for (std::size_t i = 0; i < h.a.size(); ++i) {
            if (const auto t = graze::time_of_impact(h.a[i], h.b[i])) {
                r.push_back(*t);
            }
        }
        return r;
    }();
    compare("order two kept times of flights", "plain double", kept.size() - 1,
            [](std::size_t i) { return kept[i].about() < kept[i + 1].about(); });
    compare("order two kept times of flights", "graze, apart", kept.size() - 1,
            [](std::size_t i) { return kept[i] < kept[i + 1]; });
    compare("order two kept times of flights", "graze, a tie", kept.size(),
            [](std::size_t i) { return kept[i] == kept[i]; });

    compare("contact of two flights", "plain double", h.a.size(), [&h](std::size_t i) {
        graze::contact<3> x;
        const bool found = plain_contact(x, h.a[i], h.b[i]);
        benchmark::DoNotOptimize(x);
        return found;
    });
    compare("contact of two flights", "graze::collide", h.a.size(), [&h](std::size_t i) {
        auto x = graze::collide(h.a[i], h.b[i]);
        benchmark::DoNotOptimize(x);
        return x.has_value();
    });
    static const pairs together = [&p] {
        pairs hitting;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (graze::classify(p.a[i], p.b[i]) == graze::encounter::hit) {
                hitting.a.push_back(p.a[i]);
                hitting.b.push_back(p.b[i]);
            }
        }
        return hitting;
    }();
    compare("contact of two flights", "graze::collide of balls", together.size(), [](std::size_t i) {
        auto x = graze::collide(together.a[i], together.b[i]);
        benchmark::DoNotOptimize(x);
        return x.has_value();
    });
}

} // namespace speed
