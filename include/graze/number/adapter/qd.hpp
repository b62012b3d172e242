// The double-double and quad-double numbers of the QD library (link qd). They use error-free sums of doubles, so they
// need IEEE doubles that are rounded once: no -ffast-math, and on x87 (-mfpmath=387) QD's fpu_fix_start() around their
// use. Sums and products are not correctly rounded. The exponent range is that of double. qd_real's square root of a
// square is off in its last bits about every second time (454 of those of 1 to 1000). So a wall of which face and edge
// are touched in one instant may be missed: both find it just outside of themselves.
#pragma once

#include <graze/number/traits.hpp>

#include <qd/dd_real.h>
#include <qd/qd_real.h>

#include <limits>

namespace graze::inline v0_1 {

template <>
struct number_traits<dd_real> {
    static constexpr const char* name = "dd_real";
    static constexpr bool is_exact = false;
    static constexpr int digits = std::numeric_limits<dd_real>::digits;
    static dd_real sqrt(const dd_real& x) { return ::sqrt(x); }
};

template <>
struct number_traits<qd_real> {
    static constexpr const char* name = "qd_real";
    static constexpr bool is_exact = false;
    static constexpr int digits = std::numeric_limits<qd_real>::digits;
    static qd_real sqrt(const qd_real& x) { return ::sqrt(x); }
};

} // namespace graze::inline v0_1
