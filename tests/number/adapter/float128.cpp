#include "adapter.hpp"

#include <graze/number/adapter/float128.hpp>
#include <graze/number/floating.hpp>

using adapter::kind;

static_assert(adapter::satisfies<float, kind::inexact_field, true, true>());
static_assert(adapter::satisfies<double, kind::inexact_field, true, true>());
static_assert(adapter::satisfies<long double, kind::inexact_field, true, true>());

TEST_CASE("built-in types") {
    adapter::check<float>("float");
    adapter::check<double>("double");
    adapter::check<long double>("long double");
    adapter::check_fma<float>();
    adapter::check_fma<double>();
    adapter::check_fma<long double>();
}

#if GRAZE_HAS_FLOAT128
static_assert(adapter::satisfies<__float128, kind::inexact_field, true, true>());

TEST_CASE("libquadmath") {
    adapter::check<__float128>("__float128");
    adapter::check_digits<__float128>();
    adapter::check_root<__float128>(0x1p-113);
    adapter::check_fma<__float128>();
}
#endif
