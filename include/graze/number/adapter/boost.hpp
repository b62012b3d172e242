// Numbers of Boost.Multiprecision, whatever their backend: cpp_bin_float, cpp_dec_float, cpp_int, cpp_rational, gmp_*.
// Include the backend's own Boost header as well; for MPFR include number/adapter/mpfr.hpp instead.
//
// They are numbers with expression templates off only: boost::multiprecision::number<Backend, et_off>. With et_on a sum
// is an expression that refers to its operands, so graze::number is not satisfied (sum_is_a_value says why).
#pragma once

#include <graze/number/traits.hpp>

#include <boost/multiprecision/number.hpp>

#include <array>
#include <limits>
#include <source_location>
#include <string_view>

namespace graze::inline v0_1 {

namespace detail {

template <class Backend>
consteval std::string_view signature() {
    return std::source_location::current().function_name();
}

// The backend's identifier without namespaces, template arguments and the suffix "_backend".
template <class Backend>
consteval std::string_view backend_identifier() {
    std::string_view s = signature<Backend>();
    s.remove_prefix(s.find("Backend = ") + std::string_view("Backend = ").size());
    s = s.substr(0, s.find_first_of("<];,"));
    if (const auto colon = s.rfind(':'); colon != s.npos) {
        s.remove_prefix(colon + 1);
    }
    constexpr std::string_view suffix = "_backend";
    if (s.ends_with(suffix)) {
        s.remove_suffix(suffix.size());
    }
    return s == "rational_adaptor" ? "cpp_rational"
           : s == "gmp_rational"   ? "mpq_rational"
           : s == "gmp_int"        ? "mpz_int"
                                   : s;
}

// The identifier, then "_" and the decimal digits if there are any: "cpp_bin_float_50".
template <class Backend, int Digits10>
consteval auto backend_name() {
    constexpr std::string_view base = backend_identifier<Backend>();
    std::array<char, base.size() + 12> name{};
    auto out = name.begin();
    for (const char letter : base) {
        *out++ = letter;
    }
    if (Digits10 > 0) {
        *out++ = '_';
        int power = 1;
        while (Digits10 / power >= 10) {
            power *= 10;
        }
        for (; power > 0; power /= 10) {
            *out++ = static_cast<char>('0' + Digits10 / power % 10);
        }
    }
    return name;
}

template <class Backend, int Digits10>
inline constexpr auto backend_name_storage = backend_name<Backend, Digits10>();

template <class Backend, int... Kinds>
concept backend_of_kind = ((boost::multiprecision::number_category<Backend>::value == Kinds) || ...);

template <class Backend>
concept floating_backend = backend_of_kind<Backend, boost::multiprecision::number_kind_floating_point>;

template <class Backend>
concept integer_backend = backend_of_kind<Backend, boost::multiprecision::number_kind_integer>;

template <class Backend>
concept ring_backend =
    integer_backend<Backend> || backend_of_kind<Backend, boost::multiprecision::number_kind_rational>;

// Bits of the significand. For d decimal digits, floor(1 + (d - 1) log2(10)): the type is everywhere at least as fine
// as a binary type of that many bits.
template <class Limits>
consteval int significand_bits() {
    return Limits::radix == 10 ? static_cast<int>(1 + static_cast<long long>(Limits::digits10 - 1) * 33219 / 10000)
                               : Limits::digits;
}

} // namespace detail

// A backend's name in tables: "cpp_bin_float_50", "cpp_rational", "mpfr_float_50". Specialise it to choose another
// name.
template <class Backend, int Digits10>
inline constexpr const char* boost_name = detail::backend_name_storage<Backend, Digits10>.data();

// Integers and rationals: exact, except those of a fixed width that wrap silently (checked ones throw instead).
template <detail::ring_backend Backend, boost::multiprecision::expression_template_option Templates>
struct number_traits<boost::multiprecision::number<Backend, Templates>> {
    using limits = std::numeric_limits<boost::multiprecision::number<Backend, boost::multiprecision::et_off>>;
    static constexpr const char* name = boost_name<Backend, 0>;
    static constexpr bool is_exact = limits::is_exact && !limits::is_modulo;
    static constexpr bool is_integer = detail::integer_backend<Backend>;
    static constexpr int digits = is_exact ? 0 : limits::digits;
    static int sign(const boost::multiprecision::number<Backend, Templates>& x) { return x.sign(); }
};

namespace detail {

template <class Backend, boost::multiprecision::expression_template_option Templates>
struct boost_floating_traits {
    using value = boost::multiprecision::number<Backend, Templates>;
    using limits = std::numeric_limits<boost::multiprecision::number<Backend, boost::multiprecision::et_off>>;
    static constexpr const char* name = boost_name<Backend, limits::digits10>;
    static constexpr bool is_exact = false;
    static constexpr int digits = significand_bits<limits>();
    static value sqrt(const value& x) { return boost::multiprecision::sqrt(x); }
};

} // namespace detail

// Floating-point numbers, with Boost's square root.
template <detail::floating_backend Backend, boost::multiprecision::expression_template_option Templates>
struct number_traits<boost::multiprecision::number<Backend, Templates>>
    : detail::boost_floating_traits<Backend, Templates> {};

} // namespace graze::inline v0_1
