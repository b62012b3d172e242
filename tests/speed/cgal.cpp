// The same decisions and orders in CGAL's number types.
#include "speed.hpp"

#include <graze/number/adapter/cgal.hpp>

#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Sqrt_extension.h>

namespace speed {

namespace {

// CGAL::Exact_rational is a Boost type with expression templates here; formulas that say auto cannot take it.
using rational = CGAL::Gmpq;

// The usual filtered kernel, by hand: an interval first, and an exact rational if that leaves the sign open.
struct interval_then_exact {
    converted<CGAL::Interval_nt<false>> fast;
    converted<rational> exact;

    [[nodiscard]] graze::encounter operator()(std::size_t i) const {
        try {
            const CGAL::Protect_FPU_rounding<true> upward;
            return decide(fast.a[i], fast.b[i]);
        } catch (const CGAL::Uncertain_conversion_exception&) {
            return decide(exact.a[i], exact.b[i]);
        }
    }
};

using root_number = CGAL::Sqrt_extension<rational, rational, CGAL::Tag_true>;

// τ = (-h - √D)/a as a Sqrt_extension, for pairs that hit.
root_number root_time(const ball<3, rational>& a, const ball<3, rational>& b) {
    const auto q = graze::quadratic_of(graze::relative_motion_of(a, b));
    const rational d = graze::discriminant_halved{}(q);
    return root_number(-q.h / q.a, rational(-1) / q.a, d);
}

CORE::Expr expression_time(const ball<3, CORE::Expr>& a, const ball<3, CORE::Expr>& b) {
    const auto q = graze::quadratic_of(graze::relative_motion_of(a, b));
    return graze::root_stable{}(q.c, q.h, graze::square_root(graze::discriminant_halved{}(q)));
}

pairs some_hits(bool mirrored) {
    pairs p;
    const pairs& all = generic_pairs();
    for (std::size_t i = 0; i < all.size() && p.size() < 256; ++i) {
        if (graze::classify(all.a[i], all.b[i]) == graze::encounter::hit) {
            ball<3> a = all.a[i];
            ball<3> b = all.b[i];
            if (mirrored) {
                for (ball<3>* x : {&a, &b}) {
                    std::swap(x->position[0], x->position[1]);
                    std::swap(x->velocity[0], x->velocity[1]);
                }
            }
            p.a.push_back(a);
            p.b.push_back(b);
        }
    }
    return p;
}

template <class T, class F>
void compare_order(const std::string& name, F time) {
    const auto x = std::make_shared<const converted<T>>(some_hits(false));
    const auto y = std::make_shared<const converted<T>>(some_hits(true));
    compare("build and order two times, generic", name, x->a.size() - 1,
            [x, time](std::size_t i) { return time(x->a[i], x->b[i]) < time(x->a[i + 1], x->b[i + 1]); });
    compare("build and order two times, a tie", name, x->a.size(),
            [x, y, time](std::size_t i) { return time(x->a[i], x->b[i]) < time(y->a[i], y->b[i]); });
}

} // namespace

void register_cgal() {
    const pairs& p = generic_pairs();
    compare_type<CGAL::Lazy_exact_nt<rational>>("decide", "CGAL Lazy_exact_nt", p);
    compare_type<rational>("decide", "CGAL Gmpq", p);
    const auto filtered = std::make_shared<const interval_then_exact>(
        interval_then_exact{converted<CGAL::Interval_nt<false>>(p), converted<rational>(p)});
    compare("decide", "CGAL Interval_nt, then exact", p.size(), [filtered](std::size_t i) { return (*filtered)(i); });

    compare_order<double>("graze", [](const ball<3>& a, const ball<3>& b) { return *graze::time_of_impact(a, b); });
    compare_order<rational>("CGAL Sqrt_extension", root_time);
    compare_order<CORE::Expr>("CORE::Expr", expression_time);
}

} // namespace speed
