// Correctly rounded times and contacts: compared with plain doubles, MPFR and the integers alone; and how often each
// family needs integers.
#include "speed.hpp"

#include <families/families.hpp>

#include <graze/collide.hpp>

#ifdef GRAZE_SPEED_MPFR
#include <graze/number/adapter/mpfr.hpp>

#include <boost/multiprecision/mpfr.hpp>
#endif

#include <cmath>
#include <cstdio>
#include <optional>

namespace speed {

namespace {

// The whole contact by the same formulas, unchanged.
template <class T>
bool plain_contact(graze::contact<3, T>& x, const ball<3, T>& a, const ball<3, T>& b) {
    const auto time = plain_time(a, b);
    if (!time) {
        return false;
    }
    const auto m = graze::relative_motion_of(a, b);
    const T one(1);
    const T inverse_a = one / a.mass;
    const T inverse_b = one / b.mass;
    x.time = *time;
    x.position_a = graze::position_at(a.position, a.velocity, x.time);
    x.position_b = graze::position_at(b.position, b.velocity, x.time);
    x.normal = graze::contact_normal(graze::position_at(m.dx, m.du, x.time), m.R);
    const T alpha = graze::impulse(T(graze::reduced_mass(inverse_a, inverse_b)), x.normal, m.du);
    x.velocity_a = graze::velocity_after(a.velocity, alpha, inverse_a, x.normal);
    x.velocity_b = graze::velocity_after(b.velocity, T(-alpha), inverse_b, x.normal);
    return true;
}

double graze_time(const ball<3>& a, const ball<3>& b) {
    const auto time = graze::time_of_impact(a, b);
    return time ? static_cast<double>(*time) : INFINITY;
}

bool graze_contact(graze::contact<3>& x, const ball<3>& a, const ball<3>& b) {
    const auto found = graze::collide(a, b);
    if (found) {
        x = *found;
    }
    return found.has_value();
}

// The generic pairs with random masses from 1 to 2; with hits_only, only those that hit.
pairs with_masses(const pairs& all, bool hits_only) {
    pairs p;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (hits_only && graze::classify(all.a[i], all.b[i]) != graze::encounter::hit) {
            continue;
        }
        families::random r(20261123, i);
        p.a.push_back(all.a[i]);
        p.b.push_back(all.b[i]);
        p.a.back().mass = 1 + std::ldexp(static_cast<double>(r.next() >> 12U), -52);
        p.b.back().mass = 1 + std::ldexp(static_cast<double>(r.next() >> 12U), -52);
    }
    return p;
}

// Times f(x, i), which says whether it filled in x. x counts as used, so that nothing is optimised away.
template <class C, class F>
void compare_contact(const std::string& group, const std::string& name, std::size_t count, F f) {
    compare(group, name, count, [f](std::size_t i) {
        static C x;
        const bool met = f(x, i);
        benchmark::DoNotOptimize(x);
        return met;
    });
}

void compare_rounding(const std::string& pairs_name, const pairs& p) {
    const std::string time = "a time, rounded, " + pairs_name;
    compare(time, "plain double", p.size(), [&p](std::size_t i) { return plain_time(p.a[i], p.b[i]).value_or(9) < 1; });
    compare(time, "graze::impact_time", p.size(), [&p](std::size_t i) { return graze_time(p.a[i], p.b[i]) < 1; });
    const std::string whole = "a contact, rounded, " + pairs_name;
    compare_contact<graze::contact<3>>(whole, "plain double", p.size(),
                                       [&p](auto& x, std::size_t i) { return plain_contact(x, p.a[i], p.b[i]); });
    compare_contact<graze::contact<3>>(whole, "graze::collide", p.size(),
                                       [&p](auto& x, std::size_t i) { return graze_contact(x, p.a[i], p.b[i]); });
#ifdef GRAZE_SPEED_MPFR
    using mpfr = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>,
                                               boost::multiprecision::et_off>; // 334 bits
    const auto wide = std::make_shared<converted<mpfr>>(p);
    for (std::size_t i = 0; i < p.size(); ++i) {
        wide->a[i].mass = p.a[i].mass;
        wide->b[i].mass = p.b[i].mass;
    }
    compare(time, "MPFR, 334 bits", p.size(), [wide](std::size_t i) {
        const auto t = plain_time(wide->a[i], wide->b[i]);
        return t ? static_cast<double>(*t) < 1 : false;
    });
    compare_contact<graze::contact<3, mpfr>>(whole, "MPFR, 334 bits", p.size(), [wide](auto& x, std::size_t i) {
        return plain_contact(x, wide->a[i], wide->b[i]);
    });
#endif
}

// By integers alone: the cost of one component that doubles leave open, and of all components.
void compare_exact(const std::string& pairs_name, const pairs& p) {
    using part = graze::detail::contact_component;
    using graze::detail::component_set;
    const auto one = [](part first) { return component_set{1} << static_cast<int>(first); };
    const struct {
        const char* name;
        component_set wanted;
    } kinds[] = {{"graze, time", 1},
                 {"graze, one of a position", one(part::position_a)},
                 {"graze, one of a velocity", one(part::velocity_a)},
                 {"graze, everything", graze::detail::all_components}};
    for (const auto& kind : kinds) {
        const component_set wanted = kind.wanted;
        compare_contact<graze::contact<3>>(
            "a contact by integers, " + pairs_name, kind.name, p.size(), [&p, wanted](auto& x, std::size_t i) {
                graze::detail::complete(x, wanted, graze::encounter::hit, p.a[i], p.b[i]);
                return true;
            });
    }
}

} // namespace

void register_contacts() {
    static const pairs all = with_masses(generic_pairs(), false);
    static const pairs hits = with_masses(generic_pairs(), true);
    static const pairs like = with_masses(like_exponents(), true);
    compare_rounding("generic", all);
    compare_rounding("hits alone", hits);
    compare_exact("generic", hits);
    compare_exact("like exponents", like);
}

void print_contact_stages() {
    std::printf(
        "\nshare of contacts that integers are needed for, by the decision alone and by it or any number, by family "
        "(of 4096 pairs each in the plane and in space)\n");
    for (const families::family& f : families::all_families) {
        const auto share = [&]<int N>() {
            double contacts = 0;
            double decided_exactly = 0;
            double exact = 0;
            const auto count = [&](const auto& x, const auto& y) {
                bool by_integers = false;
                if (graze::collide(x, y, [&](graze::stage s) { by_integers = s == graze::stage::exact; })) {
                    ++contacts;
                    exact += by_integers ? 1 : 0;
                    (void)graze::classify(x, y,
                                          [&](graze::stage s) { decided_exactly += s == graze::stage::exact ? 1 : 0; });
                }
            };
            for (std::uint64_t i = 0; i < 4096; ++i) {
                const auto pair = f.draw<N>(1, i);
                switch (pair.kind) {
                case families::pair_kind::ball_ball:
                    count(pair.a, pair.b);
                    break;
                case families::pair_kind::ball_plane:
                    count(pair.a, pair.plane);
                    break;
                case families::pair_kind::ball_wall:
                    count(pair.a, pair.wall);
                    break;
                }
            }
            const auto percent = [&](double some) { return contacts > 0 ? 100 * some / contacts : 0.0; };
            std::printf(" %6.0f contacts %6.2f %% %6.2f %%", contacts, percent(decided_exactly), percent(exact));
        };
        std::printf("  %-26.*s", static_cast<int>(f.name.size()), f.name.data());
        share.operator()<2>();
        share.operator()<3>();
        std::printf("\n");
    }
}

} // namespace speed
