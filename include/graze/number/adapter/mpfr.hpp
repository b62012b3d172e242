// MPFR numbers of a fixed precision, through Boost.Multiprecision:
// boost::multiprecision::number<mpfr_float_backend<Digits10>, et_off>, correctly rounded in every operation, with a
// fused multiply-add. Numbers of run-time precision (Digits10 = 0) are not supported: the precision of a sum would
// depend on a global setting.
#pragma once

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/mpfr.hpp>

namespace graze::inline v0_1 {

template <unsigned Digits10, boost::multiprecision::mpfr_allocation_type Allocation,
          boost::multiprecision::expression_template_option Templates>
struct number_traits<
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<Digits10, Allocation>, Templates>>
    : detail::boost_floating_traits<boost::multiprecision::mpfr_float_backend<Digits10, Allocation>, Templates> {
    using value =
        boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<Digits10, Allocation>, Templates>;
    static value fma(const value& x, const value& y, const value& z) {
        value sum;
        mpfr_fma(sum.backend().data(), x.backend().data(), y.backend().data(), z.backend().data(), MPFR_RNDN);
        return sum;
    }
};
template <boost::multiprecision::mpfr_allocation_type Allocation,
          boost::multiprecision::expression_template_option Templates>
struct number_traits<
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0, Allocation>, Templates>>;

} // namespace graze::inline v0_1
