#include "goal.hpp"

#include "../truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace search {

namespace {

using graze::encounter;
using precision::quantity;

constexpr std::array<const char*, 4> aim_names = {"error", "nearest", "farthest", "fallback"};
// Scores of wrong decisions are about twice this; distances are above 2^-found_from.
constexpr double found_from = 4096;

// Relative distances of two balls from the three borders.
struct borders {
    encounter met = encounter::recede;
    double receding = 0, overlapping = 0, hitting = 0; // |h|/(|Δx| |Δu|), |c|/(|Δx|² + R²), |D|/(h² + |a c|)

    // From the one between what is met and what was given; 0 where they are the same.
    [[nodiscard]] double crossed(encounter given) const {
        const auto is = [&](encounter e) { return given == e || met == e; };
        return given == met ? 0 : is(encounter::recede) ? receding : is(encounter::overlap) ? overlapping : hitting;
    }
};

template <int N>
borders borders_of(const precision::pair<N>& p, const graze::ball<N, double>& b) {
    const precision::truth<N> right(p);
    const auto value = [&](quantity q) -> mpq_class {
        return right.of(q, oracle::feature::corner, 0).front().front().to(64);
    };
    const auto ratio = [](const mpq_class& x, const mpq_class& whole) {
        return whole == 0 ? 0.0 : mpq_class(x / whole).get_d();
    };
    const mpq_class a = value(quantity::coefficient_a), h = value(quantity::coefficient_h);
    const mpq_class c = value(quantity::coefficient_c);
    const mpq_class R = mpq_class(p.a.radius) + mpq_class(b.radius);
    borders found;
    found.met = static_cast<encounter>(right.met().what);
    found.receding = std::sqrt(ratio(h * h, a * (c + R * R)));
    found.overlapping = ratio(abs(c), c + 2 * R * R);
    found.hitting = ratio(abs(h * h - a * c), h * h + abs(a * c));
    return found;
}

std::optional<double> score_of_decision(const goal& g, const any_pair& p) {
    return std::visit(
        [&](const auto& drawn) -> std::optional<double> {
            const auto q = precision::held(drawn, g.formula->type);
            if (!q || q->other.index() != 0) {
                return std::nullopt;
            }
            const borders near = borders_of(*q, std::get<0>(q->other));
            std::optional<graze::precision::answer> given;
            try {
                given = (*g.formula)(*q);
            } catch (const std::exception&) {
                return std::nullopt; // no decision, so not a wrong one
            }
            if (!given || !given->what) {
                return std::nullopt;
            }
            if (const double distance = near.crossed(*given->what); distance > 0) {
                const double bits = std::log2(distance);
                return 2 * found_from + (g.what == aim::nearest ? -bits : bits);
            }
            const double least = std::min({near.receding, near.overlapping, near.hitting});
            return -std::max(std::log2(least), -found_from);
        },
        p);
}

std::optional<double> score_of_work(const goal& g, const any_pair& p) {
    return std::visit(
        [&](const auto& drawn) -> std::optional<double> {
            const auto q = precision::held(drawn, g.formula->type);
            if (!q) {
                return std::nullopt;
            }
            const auto before = work_done();
            try {
                if (!(*g.formula)(*q)) {
                    return std::nullopt;
                }
            } catch (const std::exception&) {
                return std::nullopt; // bad input
            }
            return static_cast<double>(work_done() - before);
        },
        p);
}

} // namespace

const char* to_string(aim a) noexcept { return aim_names[static_cast<std::size_t>(a)]; }

aim aim_from(const std::string& word) {
    for (std::size_t i = 0; i < aim_names.size(); ++i) {
        if (word == aim_names[i]) {
            return static_cast<aim>(i);
        }
    }
    throw std::invalid_argument("the goal is \"" + word + "\", not error, nearest, farthest or fallback");
}

std::optional<double> goal::score(const any_pair& p) const {
    switch (what) {
    case aim::nearest:
    case aim::farthest:
        return score_of_decision(*this, p);
    case aim::fallback:
        return score_of_work(*this, p);
    case aim::error:
        break;
    }
    const auto judged = precision::judge_one(*formula, of, p);
    if (!judged || judged->errors.empty()) {
        return std::nullopt;
    }
    const double largest =
        judged->largest(); // infinite where there is no number: an overflow, which is no loss of bits
    return std::isfinite(largest) ? std::optional(largest) : std::nullopt;
}

bool goal::is_found(double score) const { return what == aim::error || what == aim::fallback || score >= found_from; }

std::string goal::tell(double score) const {
    std::array<char, 96> text{};
    if (what == aim::error) {
        std::snprintf(text.data(), text.size(), "error of %.6g units in the last place", score);
    } else if (what == aim::fallback) {
        std::snprintf(text.data(), text.size(), "%.0f basic blocks of work", score);
    } else if (is_found(score)) {
        const double bits = score - 2 * found_from;
        std::snprintf(text.data(), text.size(), "wrong at 2^%.2f from the border", what == aim::nearest ? -bits : bits);
    } else {
        std::snprintf(text.data(), text.size(), "right at 2^%.2f from the border", -score);
    }
    return text.data();
}

std::optional<double> distance_from_border(const any_pair& p, graze::encounter given) {
    return std::visit(
        [&](const auto& q) -> std::optional<double> {
            if (q.other.index() != 0) {
                return std::nullopt;
            }
            const double distance = borders_of(q, std::get<0>(q.other)).crossed(given);
            return distance > 0 ? std::optional(distance) : std::nullopt;
        },
        p);
}

} // namespace search
