// Reads the answers of a number type as numbers of Boost.
#pragma once

#include "score.hpp"

namespace compare {

// Receives one number.
class computed_sink final : public number_sink {
  public:
    [[nodiscard]] const computed& value() const { return *value_; }
    void not_finite() override;
    void exactly_right() override;
    void number(const binary_number& x) override;
    void sum(const binary_number& x, const binary_number& y) override;
    void interval(const binary_number& low, const binary_number& high) override;
    void decimal(bool negative, const std::string& digits, long exponent) override;
    void surd(const fraction& p, const fraction& q, const fraction& d) override;

  private:
    std::optional<computed> value_;
};

// The answer of a number type to one pair. right: the true answer.
[[nodiscard]] answer read_answer(solver& of, std::size_t how, std::size_t pair, const truth& right);

} // namespace compare
