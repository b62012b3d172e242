#include "significance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace compare {

double probability_of_no_difference(const std::vector<double>& x, const std::vector<double>& y) {
    constexpr std::size_t fewest = 3;
    if (x.size() < fewest || y.size() < fewest) {
        return 1;
    }
    std::vector<std::pair<double, bool>> all; // a value, and whether it belongs to x
    for (const double value : x) {
        all.emplace_back(value, true);
    }
    for (const double value : y) {
        all.emplace_back(value, false);
    }
    std::sort(all.begin(), all.end());
    const auto n = static_cast<double>(x.size()), m = static_cast<double>(y.size()), both = n + m;
    double ranks = 0, ties = 0; // x's sum of ranks; Σ (t³ - t) over all values that occur t times
    for (auto first = all.begin(); first != all.end();) {
        const auto last = std::find_if(first, all.end(), [&](const auto& v) { return v.first != first->first; });
        const auto before = static_cast<double>(first - all.begin()), tied = static_cast<double>(last - first);
        const auto of_x = static_cast<double>(std::count_if(first, last, [](const auto& v) { return v.second; }));
        ranks += of_x * (before + (tied + 1) / 2);
        ties += tied * tied * tied - tied;
        first = last;
    }
    const double u = ranks - n * (n + 1) / 2;
    const double variance = n * m / 12 * (both + 1 - ties / (both * (both - 1)));
    if (variance <= 0) {
        return 1;
    }
    const double off = std::max(std::fabs(u - n * m / 2) - 0.5, 0.0) / std::sqrt(variance);
    return std::min(1.0, std::erfc(off / std::sqrt(2.0)));
}

} // namespace compare
