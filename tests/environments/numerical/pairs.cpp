// The sign of the discriminant of hard pairs, a line for each pair: in doubles by one form, which
// NumericalStabilitySanitizer watches, or, if EXACT is defined, in integers. NSan's reports appear between the lines.
//   pairs FAMILY FORM COUNT
#include "../../../examples/families/families.hpp"

#include <graze/formula/closest_approach.hpp>
#include <graze/formula/discriminant.hpp>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#ifdef EXACT
#include <graze/classify.hpp>
#endif

namespace {

using ball = graze::ball<2, double>;

#ifdef EXACT
// For pairs that come closer and do not overlap, hit, graze or miss tells the sign of D. Other pairs have no line.
int sign_of(std::string_view, const ball& a, const ball& b) {
    const auto what = graze::classify(a, b);
    return what == graze::encounter::hit     ? 1
           : what == graze::encounter::graze ? 0
           : what == graze::encounter::miss  ? -1
                                             : 2;
}
#else
[[gnu::noinline]] double discriminant(std::string_view form, const ball& a, const ball& b) {
    const auto m = graze::relative_motion_of(a, b);
    const graze::quadratic<double, double, double> q = graze::quadratic_of(m);
    return form == "textbook"   ? graze::discriminant_textbook{}(q)
           : form == "halved"   ? graze::discriminant_halved{}(q)
           : form == "kahan"    ? graze::discriminant_kahan{}(q)
           : form == "lagrange" ? graze::discriminant_lagrange{}(m)
           : form == "closest"  ? graze::discriminant_closest{}(m)
                                : graze::discriminant_factored{}(m);
}
[[gnu::noinline]] int sign_of(std::string_view form, const ball& a, const ball& b) {
    const double d = discriminant(form, a, b);
    return d > 0 ? 1 : d < 0 ? -1 : 0;
}
#endif

} // namespace

int main(int argc, char** argv) {
    const families::family* family = argc == 4 ? families::find_family(argv[1]) : nullptr;
    if (family == nullptr) {
        return 2;
    }
    const long count = std::strtol(argv[3], nullptr, 10);
    for (long i = 0; i < count; ++i) {
        const auto pair = family->draw<2>(1, static_cast<std::size_t>(i));
        if (pair.kind == families::pair_kind::ball_ball) {
            const int sign = sign_of(argv[2], pair.a, pair.b);
            std::fprintf(stderr, "pair %ld: %d\n", i, sign);
        }
    }
}
