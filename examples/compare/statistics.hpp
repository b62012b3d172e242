// Largest, median and distribution of many errors.
#pragma once

#include "results.hpp"
#include "wide.hpp"

#include <cstddef>
#include <vector>

namespace compare {

// The smallest of the sorted values that at least the share of them do not exceed. values is not empty, 0 <= share
// <= 1.
[[nodiscard]] double quantile(const std::vector<double>& sorted, double share);

// Sorts values.
[[nodiscard]] double median(std::vector<double>& values);

// Collects errors in units of the last place that the exact value has as a double.
class error_sample {
  public:
    // distance = |computed - exact|; size: the exact value's magnitude, of a vector its largest component's. Returns
    // the error in units of the last place, or nothing where there are none: size is 0 and distance is not.
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
