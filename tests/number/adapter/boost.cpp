#include "adapter.hpp"

#include <graze/number/adapter/boost.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

namespace mp = boost::multiprecision;
using adapter::kind;

template <class Backend>
using value = mp::number<Backend, mp::et_off>;

template <mp::cpp_int_check_type Checked>
using fixed_integer = value<mp::cpp_int_backend<256, 256, mp::signed_magnitude, Checked, void>>;

static_assert(adapter::satisfies<value<mp::cpp_bin_float<50>>, kind::inexact_field, true, false>());
static_assert(adapter::satisfies<value<mp::cpp_bin_float<100>>, kind::inexact_field, true, false>());
static_assert(adapter::satisfies<value<mp::cpp_dec_float<50>>, kind::inexact_field, true, false>());
static_assert(adapter::satisfies<value<mp::cpp_rational_backend>, kind::exact_field, false, false>());
static_assert(adapter::satisfies<value<mp::cpp_int_backend<>>, kind::exact_ring, false, false>());
static_assert(adapter::satisfies<fixed_integer<mp::checked>, kind::exact_ring, false, false>());

// A type that wraps silently is not exact.
static_assert(graze::number<fixed_integer<mp::unchecked>> && !graze::exact_number<fixed_integer<mp::unchecked>>);

// With expression templates they are no numbers, because their sums are not.
static_assert(graze::number_value<mp::cpp_rational> && !graze::sum_is_a_value<mp::cpp_rational>);
static_assert(!graze::number<mp::cpp_rational> && !graze::number<mp::cpp_int>);
static_assert(!graze::number<mp::number<mp::cpp_bin_float<50>, mp::et_on>>);
static_assert(!graze::number<mp::number<mp::cpp_dec_float<50>, mp::et_on>>);

TEST_CASE("Boost's floating-point numbers") {
    adapter::check<value<mp::cpp_bin_float<50>>>("cpp_bin_float_50");
    adapter::check<value<mp::cpp_bin_float<100>>>("cpp_bin_float_100");
    adapter::check<value<mp::cpp_dec_float<50>>>("cpp_dec_float_50", 1e-49);
    adapter::check_digits<value<mp::cpp_bin_float<50>>>();
    adapter::check_digits<value<mp::cpp_bin_float<100>>>();
    adapter::check_digits<value<mp::cpp_dec_float<50>>>(150); // it keeps more digits than it promises
    adapter::check_root<value<mp::cpp_bin_float<50>>>(0x1p-168);
    adapter::check_root<value<mp::cpp_bin_float<100>>>(0x1p-334);
    adapter::check_root<value<mp::cpp_dec_float<50>>>(1e-49);
}

TEST_CASE("Boost's rationals and integers") {
    adapter::check<value<mp::cpp_rational_backend>>("cpp_rational");
    adapter::check<value<mp::cpp_int_backend<>>>("cpp_int");
    adapter::check<fixed_integer<mp::checked>>("cpp_int");
}
