#include "extent.hpp"

#include "../rounding.hpp"
#include "../text_table.hpp"

#include <algorithm>

namespace compare::run {

std::string progress_of(const extent& how_far, std::uint64_t events, double time) {
    std::string text = "event " + std::to_string(events) + ", t = " + short_number(time);
    double share = 0;
    if (how_far.events) {
        share = static_cast<double>(events) / static_cast<double>(std::max<std::uint64_t>(*how_far.events, 1));
    }
    if (how_far.until) {
        const double end = nearest_double(*how_far.until);
        share = end > 0 ? std::max(share, time / end) : share;
    }
    if (how_far.events || how_far.until) {
        text += " (" + std::to_string(static_cast<int>(100 * std::clamp(share, 0.0, 1.0))) + "%)";
    }
    return text;
}

} // namespace compare::run
