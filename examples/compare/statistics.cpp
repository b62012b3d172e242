#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace compare {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double log2_of(const wide& x) {
    const long exponent = exponent_of(x);
    return static_cast<double>(exponent) + std::log2(scaled(x, -exponent));
}

} // namespace

double quantile(const std::vector<double>& sorted, double share) {
    const auto count = static_cast<double>(sorted.size());
    const auto rank = static_cast<std::size_t>(std::max(std::ceil(share * count), 1.0));
    return sorted[std::min(rank, sorted.size()) - 1];
}

double median(std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    return quantile(values, 0.5);
}

std::optional<double> error_sample::add(const wide& distance, const wide& size, bool correctly_rounded) {
    if (size == 0 && distance != 0) {
        ++counts_.unscaled;
        return std::nullopt;
    }
    if (distance == 0) {
        ++counts_.exact;
    }
    if (correctly_rounded) {
        ++counts_.correctly_rounded;
    }
    const double units = distance == 0 ? 0.0 : scaled(distance, 52 - exponent_of(size));
    errors_.push_back(units);
    bits_.push_back(distance == 0 ? infinity : log2_of(size) - log2_of(distance));
    return units;
}

void error_sample::add_not_finite() {
    ++counts_.not_finite;
    errors_.push_back(infinity);
    bits_.push_back(-infinity);
}

error_statistics error_sample::summary() const {
    error_statistics result = counts_;
    result.count = errors_.size();
    if (errors_.empty()) {
        return result;
    }
    std::vector<double> sorted = errors_, bits = bits_;
    std::sort(sorted.begin(), sorted.end());
    std::sort(bits.begin(), bits.end());
    result.median = quantile(sorted, 0.5);
    result.largest = sorted.back();
    result.median_bits = quantile(bits, 0.5);
    result.fewest_bits = bits.front();
    for (std::size_t i = 0; i < quantile_shares.size(); ++i) {
        result.quantiles[i] = quantile(sorted, quantile_shares[i]);
    }
    for (const double error : sorted) {
        if (error > 0.0 && error < infinity) {
            ++result.histogram[std::ilogb(error)];
        }
    }
    return result;
}

void defect_sample::add(double defect) { defects_.push_back(defect); }

defect_statistics defect_sample::summary() const {
    defect_statistics result;
    result.count = defects_.size();
    if (defects_.empty()) {
        return result;
    }
    std::vector<double> sorted = defects_;
    result.median = median(sorted);
    result.largest = sorted.back();
    result.zero = static_cast<std::size_t>(std::count(sorted.begin(), sorted.end(), 0.0));
    return result;
}

} // namespace compare
