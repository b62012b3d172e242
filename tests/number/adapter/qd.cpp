#include "adapter.hpp"

#include <graze/number/adapter/qd.hpp>

static_assert(adapter::satisfies<dd_real, adapter::kind::inexact_field, true, false>());
static_assert(adapter::satisfies<qd_real, adapter::kind::inexact_field, true, false>());

TEST_CASE("libqd's numbers") {
    adapter::check<dd_real>("dd_real", 0x1p-102); // 16 u²
    adapter::check<qd_real>("qd_real", 0x1p-205);
    adapter::check_root<dd_real>(0x1p-102);
    adapter::check_root<qd_real>(0x1p-205);
    CHECK((dd_real(1) + std::ldexp(1.0, 1 - graze::number_traits<dd_real>::digits)) > dd_real(1));
    CHECK((qd_real(1) + std::ldexp(1.0, 1 - graze::number_traits<qd_real>::digits)) > qd_real(1));
}
