// What an accepted build would answer: graze's own formulas in numbers with as many digits as a type has, each
// operation rounded to nearest, with unlimited range.
#pragma once

#include "judge.hpp"

#include <optional>
#include <string>
#include <vector>

namespace precision {

class reference {
  public:
    // For a formula that computes `of`: graze's own of the same name or, if given, of the name `variant`; if there is
    // none of that name, any that computes it.
    reference(const subject& formula, quantity of, const std::string& variant = {});

    // Whether graze has such a formula.
    [[nodiscard]] bool exists() const { return !formulas_.empty(); }
    // Its name, "halved.stable".
    [[nodiscard]] std::string name() const { return formulas_.front()->variant; }
    // The formula; it takes the pair as the type holds it.
    [[nodiscard]] const subject& formula() const { return *formulas_.front(); }

  private:
    graze::precision::subjects formulas_;
};

} // namespace precision
