#include "reference.hpp"

#include <graze/precision/formulas.hpp>

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <stdexcept>

namespace precision {

namespace {

thread_local int digits_of_reference = 53;

// floor(log2|x|) for x != 0.
long exponent(const mpq_class& x) {
    const long e = static_cast<long>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) -
                   static_cast<long>(mpz_sizeinbase(x.get_den_mpz_t(), 2));
    mpq_class power = 1;
    if (e >= 0) {
        mpq_mul_2exp(power.get_mpq_t(), power.get_mpq_t(), static_cast<mp_bitcnt_t>(e));
    } else {
        mpq_div_2exp(power.get_mpq_t(), power.get_mpq_t(), static_cast<mp_bitcnt_t>(-e));
    }
    return abs(x) < power ? e - 1 : e;
}

mpq_class shifted(mpq_class x, long by) {
    if (by >= 0) {
        mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(by));
    } else {
        mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-by));
    }
    return x;
}

// The nearest number with this many digits, ties to even.
mpq_class rounded(const mpq_class& x) {
    if (x == 0) {
        return x;
    }
    const long unit = exponent(x) - digits_of_reference + 1;
    const mpq_class scaled = shifted(x, -unit);
    mpz_class whole, rest;
    mpz_fdiv_qr(whole.get_mpz_t(), rest.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    const int beyond_half = cmp(mpz_class(2 * rest), scaled.get_den());
    if (beyond_half > 0 || (beyond_half == 0 && mpz_odd_p(whole.get_mpz_t()) != 0)) {
        ++whole;
    }
    return shifted(mpq_class(whole), unit);
}

class rounded_number {
  public:
    rounded_number(int x = 0) : value_(rounded(mpq_class(x))) {}
    [[nodiscard]] static rounded_number of(const mpq_class& x) {
        rounded_number y(0);
        y.value_ = rounded(x);
        return y;
    }
    [[nodiscard]] static rounded_number infinity() { // for a mass
        rounded_number y(0);
        y.is_infinite_ = true;
        return y;
    }
    [[nodiscard]] const mpq_class& value() const { return value_; }
    [[nodiscard]] bool is_infinite() const { return is_infinite_; }

    friend rounded_number operator+(const rounded_number& x, const rounded_number& y) {
        return of(x.value_ + y.value_);
    }
    friend rounded_number operator-(const rounded_number& x, const rounded_number& y) {
        return of(x.value_ - y.value_);
    }
    friend rounded_number operator*(const rounded_number& x, const rounded_number& y) {
        return of(x.value_ * y.value_);
    }
    friend rounded_number operator/(const rounded_number& x, const rounded_number& y) {
        if (y.value_ == 0) {
            throw std::domain_error("a division by 0");
        }
        return of(x.value_ / y.value_);
    }
    rounded_number operator-() const { return of(-value_); }
    friend bool operator==(const rounded_number& x, const rounded_number& y) { return x.value_ == y.value_; }
    friend std::strong_ordering operator<=>(const rounded_number& x, const rounded_number& y) {
        return cmp(x.value_, y.value_) <=> 0;
    }

  private:
    mpq_class value_;
    bool is_infinite_ = false;
};

} // namespace

} // namespace precision

template <>
struct graze::number_traits<::precision::rounded_number> {
    static constexpr const char* name = "rounded";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0;
    static ::precision::rounded_number sqrt(const ::precision::rounded_number& x) {
        if (x.value() < 0) {
            throw std::domain_error("the root of a negative number");
        }
        if (x.value() == 0) {
            return 0;
        }
        // The root's whole part, with two bits more than are kept, and a last bit that tells whether anything is left.
        const long unit = ::precision::exponent(x.value()) / 2 - ::precision::digits_of_reference - 3;
        const mpq_class scaled = ::precision::shifted(x.value(), -2 * unit);
        mpz_class whole = scaled.get_num() / scaled.get_den(), root = ::sqrt(whole);
        const bool is_whole = mpq_class(root * root) == scaled;
        return ::precision::rounded_number::of(
            ::precision::shifted(mpq_class(2 * root + (is_whole ? 0 : 1)), unit - 1));
    }
    static ::precision::rounded_number fma(const ::precision::rounded_number& x, const ::precision::rounded_number& y,
                                           const ::precision::rounded_number& z) {
        return ::precision::rounded_number::of(x.value() * y.value() + z.value());
    }
};

template <>
struct graze::precision::number_access<::precision::rounded_number> {
    static ::precision::rounded_number from(double x) {
        return std::isinf(x) ? ::precision::rounded_number::infinity() : ::precision::rounded_number::of(mpq_class(x));
    }
    static reading read(const ::precision::rounded_number& x) {
        if (x.is_infinite()) {
            return {{std::numeric_limits<double>::infinity()}};
        }
        if (x.value() == 0) {
            return {{0.0}};
        }
        const long e = ::precision::exponent(x.value());
        mpq_class rest = ::precision::shifted(x.value(), -e);
        reading r;
        r.exponent = static_cast<int>(e);
        while (rest != 0) {
            r.parts.push_back(rest.get_d()); // its leading bits
            rest -= r.parts.back();
        }
        return r;
    }
};

namespace precision {

namespace {

// Sets the number of digits during a call.
class with_digits final : public subject {
  public:
    with_digits(std::unique_ptr<subject> of, const graze::precision::number_type& as) : of_(std::move(of)) {
        variant = of_->variant;
        measures = of_->measures;
        type = as;
    }
    [[nodiscard]] std::optional<graze::precision::answer> operator()(const pair<2>& p) const override {
        return asked([&] { return (*of_)(p); });
    }
    [[nodiscard]] std::optional<graze::precision::answer> operator()(const pair<3>& p) const override {
        return asked([&] { return (*of_)(p); });
    }
    [[nodiscard]] std::optional<graze::precision::answer> operator()(const pair<2>& p,
                                                                     const pair<2>& q) const override {
        return asked([&] { return (*of_)(p, q); });
    }
    [[nodiscard]] std::optional<graze::precision::answer> operator()(const pair<3>& p,
                                                                     const pair<3>& q) const override {
        return asked([&] { return (*of_)(p, q); });
    }

  private:
    std::unique_ptr<subject> of_;

    template <class F>
    std::optional<graze::precision::answer> asked(F call) const {
        constexpr double bits_of_a_digit = 3.33;
        digits_of_reference =
            type.decimal_digits > 0 ? static_cast<int>(type.decimal_digits * bits_of_a_digit) + 1 : type.digits;
        return call();
    }
};

bool computes(const subject& s, quantity of) {
    const bool is_coefficient = of <= quantity::coefficient_c;
    const bool is_of_solution = of >= quantity::encounter && of <= quantity::velocity;
    return is_coefficient   ? s.measures == quantity::coefficient_h
           : is_of_solution ? s.measures == quantity::encounter
                            : s.measures == of;
}

} // namespace

reference::reference(const subject& formula, quantity of, const std::string& variant) {
    graze::precision::subjects all;
    graze::precision::add_formulas<rounded_number>(all);
    std::erase_if(all, [&](const auto& s) { return !computes(*s, of); });
    const std::string name = variant.empty() ? formula.variant : variant;
    const auto same = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s->variant == name; });
    if (!all.empty()) { // the last one has Lagrange's form, which loses least
        const auto chosen = same != all.end() ? same : std::find_if(all.begin(), all.end(), [](const auto& s) {
            return s->variant.starts_with("lagrange");
        });
        formulas_.push_back(
            std::make_unique<with_digits>(std::move(chosen != all.end() ? *chosen : all.front()), formula.type));
    }
}

} // namespace precision
