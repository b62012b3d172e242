// What an accepted build would say: graze's own formulas in numbers of as many digits as a type has, each operation
// rounded to nearest, and without a limit of range.
#pragma once

#include "judge.hpp"

#include <optional>
#include <string>
#include <vector>

namespace precision {

class reference {
  public:
    // For a formula that computes `of`: graze's own of that name, or of `variant` if that is given, or any that
    // computes it where there is none of that name.
    reference(const subject& formula, quantity of, const std::string& variant = {});

    // Whether there is any.
    [[nodiscard]] bool exists() const { return !formulas_.empty(); }
    // Its name, "halved.stable".
    [[nodiscard]] std::string name() const { return formulas_.front()->variant; }
    // What it says, as the type holds the pair.
    [[nodiscard]] const subject& formula() const { return *formulas_.front(); }

  private:
    graze::precision::subjects formulas_;
};

} // namespace precision
