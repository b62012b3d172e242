#include "judge.hpp"

#include "../oracle/rounding.hpp"

#include <algorithm>
#include <exception>

namespace precision {

namespace {

using graze::precision::answer;
using graze::precision::number_type;

mpq_class power_of_two(long exponent) {
    const mpz_class power = mpz_class(1) << static_cast<unsigned long>(std::abs(exponent));
    return exponent < 0 ? mpq_class(1, power) : mpq_class(power);
}

// floor(log2|x|) for x != 0.
long exponent_of(const mpq_class& x) {
    const long e = static_cast<long>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) -
                   static_cast<long>(mpz_sizeinbase(x.get_den_mpz_t(), 2));
    return abs(x) < power_of_two(e) ? e - 1 : e;
}

mpq_class power_of_ten(long exponent) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
    return exponent < 0 ? mpq_class(1, power) : mpq_class(power);
}

// floor(log10|x|) for x != 0. If 2^e <= |x| < 2^(e+1), it is floor(e log10 2) or one more.
long decimal_exponent_of(const mpq_class& x) {
    const long e = static_cast<long>(std::floor(static_cast<double>(exponent_of(x)) * std::log10(2.0)));
    return abs(x) < power_of_ten(e + 1) ? e : e + 1;
}

// The unit in the last place of x in the type.
mpq_class unit_of(const mpq_class& x, const number_type& type) {
    if (type.decimal_digits != 0) {
        return power_of_ten(decimal_exponent_of(x) - type.decimal_digits + 1);
    }
    return power_of_two(std::max(exponent_of(x) - type.digits + 1, static_cast<long>(type.lowest)));
}

bool is_rounded(const oracle::surd& x, const reading& y, const number_type& type) {
    const double number = y.parts.front();
    return type.digits == 24 ? oracle::is_rounded(x, static_cast<float>(number)) : oracle::is_rounded(x, number);
}

void judge_vector(const subject& formula, const std::vector<reading>& given, const exact_vector& right, verdict& v) {
    const int bits = formula.type.digits + 64;
    const mpq_class* size = nullptr;
    for (const exact_number& x : right) {
        if (size == nullptr || abs(x.to(bits)) > abs(*size)) {
            size = &x.to(bits);
        }
    }
    for (std::size_t i = 0; i < right.size(); ++i) {
        ++v.values;
        const std::optional<mpq_class> y = exactly(given[i]);
        if (!y) {
            v.misrounded += formula.correctly_rounded && is_rounded(right[i].exactly(), given[i], formula.type) ? 0 : 1;
            v.errors.push_back(std::numeric_limits<double>::infinity());
            continue;
        }
        const mpq_class& x = right[i].to(bits);
        const mpq_class error = abs(*y - x);
        bool rounded = error == 0;
        if (formula.correctly_rounded) {
            rounded = is_rounded(right[i].exactly(), given[i], formula.type);
        } else if (x != 0) {
            rounded = 2 * error <= unit_of(x, formula.type);
        }
        v.misrounded += rounded ? 0 : 1;
        if (*size != 0) {
            v.errors.push_back(mpq_class(error / unit_of(*size, formula.type)).get_d());
        } else if (error == 0) {
            v.errors.push_back(0);
        }
    }
}

// Compares the k-th value that the answer gives for its quantity with the k-th true one.
template <int N>
void judge_values(const subject& formula, const answer& given, const truth<N>& right, verdicts& found) {
    const auto where = given.where ? static_cast<oracle::feature>(*given.where) : right.met().where();
    int index = given.index;
    if (!given.where || index == graze::precision::index_unknown) {
        const unsigned set = where == oracle::feature::edge ? right.met().edges : right.met().corners;
        index = where == oracle::feature::face ? 0 : std::countr_zero(set);
    }
    if (given.where && right.met().pieces.size() > 1 && !right.met().has(where, index)) {
        found[formula.measures].wrong = true;
        return;
    }
    std::map<quantity, std::size_t> count;
    for (const auto& value : given.values) {
        const auto& all = right.of(value.of, where, index);
        const std::size_t k = count[value.of]++;
        verdict& v = found[value.of];
        if (k >= all.size()) { // there is no such true value
            v.wrong = true;
            continue;
        }
        judge_vector(formula, value.components, all[k], v);
        const bool has_sign = value.of <= quantity::discriminant;
        if (has_sign) {
            const auto y = exactly(value.components.front());
            v.wrong = !y || sgn(*y) != oracle::sign_of(all[k].front().exactly());
        }
    }
}

bool same_encounter(const answer& given, const oracle::answer& right) {
    if (static_cast<int>(*given.what) != static_cast<int>(right.what)) {
        return false;
    }
    return !given.where || right.pieces.size() < 2 || !oracle::is_collision(right.what) ||
           right.has(static_cast<oracle::feature>(*given.where), given.index);
}

} // namespace

double verdict::largest() const { return errors.empty() ? 0 : *std::max_element(errors.begin(), errors.end()); }

std::optional<mpq_class> exactly(const reading& x) {
    mpq_class sum = 0;
    for (const double part : x.parts) {
        if (!std::isfinite(part)) {
            return std::nullopt;
        }
        sum += mpq_class(part);
    }
    sum *= power_of_two(x.exponent);
    return x.decimal_exponent == 0 ? sum : mpq_class(sum * power_of_ten(x.decimal_exponent));
}

template <int N>
verdicts judge(const subject& formula, const pair<N>& p, const truth<N>& right) {
    verdicts found;
    std::optional<answer> given;
    try {
        given = formula(p);
    } catch (const std::exception&) {
        found[formula.measures].wrong = true;
        return found;
    }
    if (!given) {
        return found;
    }
    const bool collides = oracle::is_collision(right.met().what);
    if (given->what) {
        verdict& v = found[quantity::encounter];
        v.wrong = !same_encounter(*given, right.met());
        if (v.wrong || !collides) {
            return found;
        }
    } else if (given->values.empty()) { // no value is right if there is none
        found[formula.measures].wrong = collides;
        return found;
    }
    judge_values(formula, *given, right, found);
    return found;
}

template <int N>
bool is_ordered(const truth<N>& p) {
    return p.met().pieces.size() == 1 &&
           (p.met().what == oracle::encounter::hit || p.met().what == oracle::encounter::graze);
}

template <int N>
verdicts judge(const subject& formula, const pair<N>& p, const pair<N>& q, const truth<N>& right_p,
               const truth<N>& right_q) {
    verdicts found;
    try {
        const std::optional<answer> given = formula(p, q);
        if (given && given->order) {
            found[quantity::order].wrong = *given->order != oracle::compare(*right_p.met().time, *right_q.met().time);
        }
    } catch (const std::exception&) {
        found[formula.measures].wrong = true;
    }
    return found;
}

template verdicts judge(const subject&, const pair<2>&, const truth<2>&);
template verdicts judge(const subject&, const pair<3>&, const truth<3>&);
template bool is_ordered(const truth<2>&);
template bool is_ordered(const truth<3>&);
template verdicts judge(const subject&, const pair<2>&, const pair<2>&, const truth<2>&, const truth<2>&);
template verdicts judge(const subject&, const pair<3>&, const pair<3>&, const truth<3>&, const truth<3>&);

} // namespace precision
