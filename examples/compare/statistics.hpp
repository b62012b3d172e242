// Largest, median and distribution of many errors.
#pragma once

#include "results.hpp"
#include "wide.hpp"

#include <cstddef>
#include <vector>

namespace compare {

// The smallest value that at least this share of the sorted values does not exceed. values is not empty, 0 <= share <=
// 1.
[[nodiscard]] double quantile(const std::vector<double>& sorted, double share);

// Sorts `values`.
[[nodiscard]] double median(std::vector<double>& values);

// Collects errors in units of the last place of the exact value as a double.
class error_sample {
  public:
    // distance = |computed - exact|. size: the magnitude of the exact value or, for a vector, of its largest component.
    // Returns the error in units of the last place; nothing if size is 0 and distance is not, since there is no unit.
    std::optional<double> add(const wide& distance, const wide& size, bool correctly_rounded);
    void add_not_finite();
    [[nodiscard]] error_statistics summary() const;

  private:
    std::vector<double> errors_, bits_;
    error_statistics counts_;
};

class defect_sample {
  public:
    void add(double defect);
    [[nodiscard]] defect_statistics summary() const;

  private:
    std::vector<double> defects_;
};

} // namespace compare
