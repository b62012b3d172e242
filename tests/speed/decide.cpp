// The cost of an encounter: compared with plain number types and with the exact stage alone; and how often each family
// needs that stage.
#include "speed.hpp"

#include <families/families.hpp>

#include <graze/number/adapter/boost.hpp>
#include <graze/number/adapter/gmp.hpp>

#include <boost/multiprecision/cpp_int.hpp>

#ifdef GRAZE_SPEED_FLOAT128
#include <graze/number/adapter/float128.hpp>
#endif

#include <cstdio>

namespace speed {

namespace {

using cpp_rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

void compare_exact(const std::string& group, const pairs& p) {
    compare(group, "graze's exact tier", p.size(),
            [&p](std::size_t i) { return graze::detail::classify_exactly(p.a[i], p.b[i], {}); });
    compare_type<graze::gmp_rational>(group, "GMP mpq_class", p);
    compare_type<cpp_rational>(group, "Boost cpp_rational", p);
}

} // namespace

void register_decisions() {
    const pairs& p = generic_pairs();
    const auto decide_all = [](const std::string& group, const pairs& q) {
        compare(group, "plain double", q.size(), [&q](std::size_t i) { return decide(q.a[i], q.b[i]); });
        compare(group, "graze::classify", q.size(), [&q](std::size_t i) { return graze::classify(q.a[i], q.b[i]); });
    };
    decide_all("decide", p);
    decide_all("decide, too many pairs to predict", many_pairs());
    compare_type<long double>("decide", "long double", p);
#ifdef GRAZE_SPEED_FLOAT128
    compare_type<__float128>("decide", "__float128", p);
#endif
    compare_exact("exact, generic", p);
    compare_exact("exact, like exponents", like_exponents());
    compare_exact("exact, full range", full_range());
}

void print_stages() {
    std::printf("\nshare of decisions that the filter takes, by family (4096 pairs each in the plane and in space)\n");
    for (const families::family& f : families::all_families) {
        const auto share = [&]<int N>() {
            std::size_t filtered = 0;
            const auto observer = [&](graze::stage s) { filtered += s == graze::stage::filter ? 1U : 0U; };
            for (std::uint64_t i = 0; i < 4096; ++i) {
                const auto pair = f.draw<N>(1, i);
                switch (pair.kind) {
                case families::pair_kind::ball_ball:
                    (void)graze::classify(pair.a, pair.b, observer);
                    break;
                case families::pair_kind::ball_plane:
                    (void)graze::classify(pair.a, pair.plane, observer);
                    break;
                case families::pair_kind::ball_wall:
                    (void)graze::classify(pair.a, pair.wall, observer);
                    break;
                }
            }
            return static_cast<double>(filtered) / 40.96;
        };
        std::printf("  %-26.*s %6.1f %% %6.1f %%\n", static_cast<int>(f.name.size()), f.name.data(),
                    share.operator()<2>(), share.operator()<3>());
    }
}

} // namespace speed
