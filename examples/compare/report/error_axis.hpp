// The error axis of speed against error.
#pragma once

#include "summary.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace compare::report {

// Decades are at full length down to 10^-20. Below, many decades share the length of one, so that a hundred digits, and
// no error at all, fit below the doubles without crushing them. Heights are in decades of the upper part.
class error_axis {
  public:
    explicit error_axis(const std::vector<candidate>& points) {
        for (const auto& c : points) {
            if (std::isfinite(c.fewest_bits)) {
                highest_ = std::max(highest_, std::ceil(decade_of(c) / 4) * 4);
                lowest_ = std::min(lowest_, decade_of(c));
            }
            infinite_ = infinite_ || (std::isinf(c.fewest_bits) && c.fewest_bits < 0);
        }
    }

    static constexpr double bend = -20; // below this the axis is squeezed, if there is anything to show

    [[nodiscard]] bool bends() const { return lowest_ < bend; }
    [[nodiscard]] double top() const { return highest_ + (infinite_ ? 4.5 : 1); }
    [[nodiscard]] double no_number() const { return highest_ + 3; }
    [[nodiscard]] double no_error() const { return height(std::min(lowest_, bend)) - 2.5; }
    [[nodiscard]] double bottom() const { return no_error() - 1.5; }
    [[nodiscard]] double height(double decade) const {
        return decade >= bend ? decade : bend - 1 - (bend - decade) * squeeze;
    }
    [[nodiscard]] double height(const candidate& c) const {
        if (std::isinf(c.fewest_bits)) {
            return c.fewest_bits > 0 ? no_error() : no_number();
        }
        return height(decade_of(c));
    }

    [[nodiscard]] std::vector<std::pair<double, std::string>> tics() const {
        std::vector<std::pair<double, std::string>> all = {{no_error(), "exact"}};
        for (int decade = static_cast<int>(highest_); decade >= -20; decade -= 4) {
            all.emplace_back(height(decade), decade == 0 ? "1" : power_of_ten(decade));
        }
        for (const int decade : {-30, -50, -70, -100}) {
            if (bends() && decade >= lowest_ - 5) {
                all.emplace_back(height(decade), power_of_ten(decade));
            }
        }
        if (infinite_) {
            all.emplace_back(no_number(), "no number");
        }
        return all;
    }

  private:
    static constexpr double squeeze = 0.11;
    double highest_ = 0, lowest_ = bend;
    bool infinite_ = false;

    [[nodiscard]] static double decade_of(const candidate& c) { return -c.fewest_bits * std::log10(2.0); }
};

} // namespace compare::report
