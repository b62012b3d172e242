// Making and ordering the times of two collisions, compared with plain doubles; different times, and ties.
#include "speed.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace speed {

namespace {

// Infinity if there is no time.
double plain_or_never(const ball<3>& a, const ball<3>& b) { return plain_time(a, b).value_or(INFINITY); }

bool exact_order(const ball<3>& a, const ball<3>& b, const ball<3>& c, const ball<3>& d) {
    const auto s = graze::time_of_impact(a, b);
    const auto t = graze::time_of_impact(c, d);
    return s && (!t || *s < *t);
}

// Generic pairs that hit, each with its mirror image, which hits at exactly the same time.
const pairs& hits() {
    static const pairs result = [] {
        pairs p;
        const pairs& all = generic_pairs();
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (graze::classify(all.a[i], all.b[i]) == graze::encounter::hit) {
                p.a.push_back(all.a[i]);
                p.b.push_back(all.b[i]);
            }
        }
        return p;
    }();
    return result;
}

ball<3> mirrored(ball<3> b) {
    std::swap(b.position[0], b.position[1]);
    std::swap(b.velocity[0], b.velocity[1]);
    return b;
}

void compare_making(const std::string& group, const pairs& p) {
    compare(group, "plain double", p.size() / 2, [&p](std::size_t i) {
        return plain_or_never(p.a[2 * i], p.b[2 * i]) < plain_or_never(p.a[2 * i + 1], p.b[2 * i + 1]);
    });
    compare(group, "graze::time_of_impact", p.size() / 2,
            [&p](std::size_t i) { return exact_order(p.a[2 * i], p.b[2 * i], p.a[2 * i + 1], p.b[2 * i + 1]); });
}

} // namespace

void register_orders() {
    compare_making("make and order two times", generic_pairs());
    compare_making("make and order two times, too many to predict", many_pairs());

    static const std::vector<double> plain = [] {
        std::vector<double> r;
        for (std::size_t i = 0; i < hits().size(); ++i) {
            r.push_back(plain_or_never(hits().a[i], hits().b[i]));
        }
        return r;
    }();
    static const std::vector<graze::impact_time<3>> kept = [] {
        std::vector<graze::impact_time<3>> r;
        for (std::size_t i = 0; i < hits().size(); ++i) {
            r.push_back(*graze::time_of_impact(hits().a[i], hits().b[i]));
        }
        return r;
    }();
    compare("sort kept times (all)", "plain double", 1, [](std::size_t) {
        auto v = plain;
        std::sort(v.begin(), v.end());
        return v.front();
    });
    compare("sort kept times (all)", "graze::impact_time", 1, [](std::size_t) {
        auto v = kept;
        std::sort(v.begin(), v.end());
        return v.front() < v.back();
    });

    static const std::vector<graze::impact_time<3>> mirror = [] {
        std::vector<graze::impact_time<3>> r;
        for (std::size_t i = 0; i < hits().size(); ++i) {
            r.push_back(*graze::time_of_impact(mirrored(hits().a[i]), mirrored(hits().b[i])));
        }
        return r;
    }();
    compare("order two kept times", "graze, apart", kept.size() - 1,
            [](std::size_t i) { return kept[i] < kept[i + 1]; });
    compare("order two kept times", "graze, a tie", kept.size(), [](std::size_t i) { return kept[i] == mirror[i]; });
}

} // namespace speed
