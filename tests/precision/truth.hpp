// The exact values of all the quantities of one pair that the regression measures, by the oracle.
#pragma once

#include "../oracle/contact.hpp"

#include <graze/precision/subject.hpp>

#include <array>
#include <functional>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace precision {

using graze::precision::pair;
using graze::precision::quantity;

// An exact number and rational approximations of it, each computed once.
class exact_number {
  public:
    explicit exact_number(oracle::surd x) : value_(std::move(x)) {}

    [[nodiscard]] const oracle::surd& exactly() const { return value_; }
    // Within a relative 2^-bits of the number, or the number itself if it is rational. bits <= 512.
    [[nodiscard]] const mpq_class& to(int bits) const;

  private:
    oracle::surd value_;
    mutable std::array<std::optional<mpq_class>, 2> known_;
};

using exact_vector = std::vector<exact_number>;

// A pair of rational numbers, for numbers that no double holds. An infinite mass is 0 here: the truth keeps inverses.
template <int N>
struct rational_pair {
    graze::ball<N, mpq_class> a;
    std::conditional_t<N == 2,
                       std::variant<graze::ball<N, mpq_class>, graze::plane<N, mpq_class>, graze::wall<N, mpq_class>>,
                       std::variant<graze::ball<N, mpq_class>, graze::plane<N, mpq_class>, graze::wall<N, mpq_class>,
                                    graze::triangle<mpq_class>>>
        other;
};

template <int N>
class truth {
  public:
    // p must be valid (see is_valid).
    explicit truth(const pair<N>& p);
    // About p, which must be valid, with each number replaced by value_of it; nothing if the result is no valid pair.
    using value_of = std::function<std::optional<mpq_class>(double)>;
    [[nodiscard]] static std::optional<truth> of_rounded(const pair<N>& p, const value_of& value);

    [[nodiscard]] const oracle::answer& met() const { return met_; }
    // The values of a quantity, in the order of graze::precision::answer; empty if the pair has none. where and index:
    // one of the features of a wall that are met.
    [[nodiscard]] const std::vector<exact_vector>& of(quantity q, oracle::feature where, int index) const;

  private:
    struct values {
        oracle::feature where;
        int index;
        std::array<std::vector<exact_vector>, 10> of;
    };
    truth(rational_pair<N> p, mpq_class inverse_a, mpq_class inverse_b);
    [[nodiscard]] values values_at(oracle::feature where, int index) const;

    std::variant<pair<N>, rational_pair<N>> pair_;
    mpq_class inverse_a_, inverse_b_; // inverses of the masses
    oracle::answer met_;
    mutable std::vector<values> known_;
};

// Whether the numbers are finite (but for one infinite mass) and describe balls, a plane or a wall.
template <int N>
[[nodiscard]] bool is_valid(const pair<N>& p);

extern template class truth<2>;
extern template class truth<3>;
extern template bool is_valid(const pair<2>&);
extern template bool is_valid(const pair<3>&);

} // namespace precision
