// The fast path of a contact, compared with the oracle: no component is farther from the exact one than its bound, and
// none that is certain is rounded wrongly, for pairs of every family and however bad the first time was.
#include "../oracle/rounding.hpp"
#include "bounds.hpp"

#include <graze/contact/contact_in_doubles.hpp>

#include <families/families.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace contact_in_doubles_test {

using graze::detail::component_set;

namespace {

using namespace bounds;

struct seen {
    int pairs = 0, answered = 0, certain = 0, wrong_bounds = 0, wrong_values = 0;
};

template <int N, class T>
void look(seen& s, families::random& r, const graze::ball<N, T>& a, const graze::ball<N, T>& b) {
    if (!is_finite(a) || !is_finite(b) || (std::isinf(a.mass) && std::isinf(b.mass))) {
        return;
    }
    const auto met = oracle::meet(a, b);
    const bool overlap = met.what == oracle::encounter::overlap;
    if (met.what != oracle::encounter::hit && !overlap) {
        return;
    }
    ++s.pairs;
    const auto inverse = [](T mass) { return std::isinf(mass) ? mpq_class(0) : mpq_class(1) / mpq_class(mass); };
    const auto truth = listed(oracle::contact(a, b, inverse(a.mass), inverse(b.mass), met));
    const bool heavy_a = std::isinf(a.mass), heavy_b = std::isinf(b.mass);
    const double mass_a = heavy_a ? 1 : heavy_b ? 0 : static_cast<double>(a.mass);
    const double mass_b = heavy_b ? 1 : heavy_a ? 0 : static_cast<double>(b.mass);
    const double time = rough_time(r, truth[0]);
    auto take = [&]<class V>(const graze::detail::bounded<V>& x, auto... numbers) {
        int i = 0;
        for (const int number : {numbers...}) {
            s.wrong_bounds += holds(x, i++, truth[static_cast<std::size_t>(number)]) ? 0 : 1;
        }
    };
    // With fused products and without, whatever the machine has.
    const bool fused = overlap ? graze::detail::bound_overlap<true>(a, b, mass_a, mass_b, take)
                               : graze::detail::bound_hit<true>(a, b, mass_a, mass_b, time, take);
    const bool dekker = overlap ? graze::detail::bound_overlap<false>(a, b, mass_a, mass_b, take)
                                : graze::detail::bound_hit<false>(a, b, mass_a, mass_b, time, take);
    s.answered += fused && dekker ? 1 : 0;
    graze::contact<N, T> x;
    graze::detail::rounded_components<N, T> rounded{x};
    using taker = graze::detail::rounded_components<N, T>;
    const graze::detail::hit_by_doubles<taker, graze::ball<N, T>> hit{rounded, a, b, mass_a, mass_b, time};
    const graze::detail::overlap_by_doubles<taker, graze::ball<N, T>> both_inside{rounded, a, b, mass_a, mass_b};
    const auto judge = [&](component_set open_components) {
        for (int number = 0; number < static_cast<int>(components); ++number) {
            if ((open_components >> number & 1U) == 0 && (number == 0 || (number - 1) % 3 < N)) {
                const T y = graze::detail::component(x, number);
                s.wrong_values += oracle::is_rounded(truth[static_cast<std::size_t>(number)], y) ? 0 : 1;
            }
        }
    };
    if (!heavy_a && !heavy_b) {
        const auto open = [&](auto fused_products) {
            rounded.certain = 0;
            return (overlap ? both_inside(fused_products) : hit(fused_products)) ? ~rounded.certain : ~component_set{0};
        };
        judge(open(std::false_type{}));
        judge(open(std::true_type{}));
    }
    const component_set open_components = graze::detail::contact_in_doubles(
        x, overlap ? graze::encounter::overlap : graze::encounter::hit, a, b, mass_a, mass_b, time);
    judge(open_components);
    s.certain += open_components == 0 ? 1 : 0;
}

template <class T>
void try_families(std::uint64_t count) {
    for (const families::family& f : families::all_families) {
        CAPTURE(f.name);
        seen s;
        for (std::uint64_t i = 0; i < count; ++i) {
            families::random r(7, i);
            const auto flat = f.draw<2>(11, i);
            const auto solid = f.draw<3>(11, i);
            if (flat.kind == families::pair_kind::ball_ball) {
                look(s, r, to<T>(flat.a), to<T>(flat.b));
            }
            if (solid.kind == families::pair_kind::ball_ball) {
                look(s, r, to<T>(solid.a), to<T>(solid.b));
            }
        }
        CHECK(s.wrong_bounds == 0);
        CHECK(s.wrong_values == 0);
        if (f.name == "generic" || f.name == "masses") {
            CHECK(s.pairs > 10);
            CHECK(s.answered > s.pairs / 3); // for the others the time was too rough
        }
        MESSAGE(f.name << ": " << s.pairs << " hits, " << s.answered << " bounded, " << s.certain << " certain");
    }
}

} // namespace

TEST_CASE("bounds hold and certain components are right: doubles") { try_families<double>(300); }
TEST_CASE("bounds hold and certain components are right: floats") { try_families<float>(100); }

} // namespace contact_in_doubles_test
