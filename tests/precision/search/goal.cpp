#include "goal.hpp"

#include "border.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace search {

namespace {

constexpr std::array<const char*, 4> aim_names = {"error", "nearest", "farthest", "fallback"};
// Bits of distances are cut off at this number; scores of wrong decisions are above it, others below.
constexpr double found_from = 0x1p15;

// A pair as its type holds it, and what is asked about it. std::nullopt outside the domain.
struct asked {
    const graze::precision::subject* formula;
    std::optional<graze::precision::answer> given; // nothing if it threw
};

template <int N>
std::optional<asked> ask(const goal& g, const precision::pair<N>& held) {
    for (const auto* formula : g.formulas) {
        try {
            if (auto given = (*formula)(held)) {
                return asked{formula, std::move(given)};
            }
        } catch (const std::exception&) {
            return asked{formula, std::nullopt};
        }
    }
    return std::nullopt;
}

// A decision's score from the squared distance to the border: wrong_by if it is wrong, else least.
double score_by(aim what, const std::optional<mpq_class>& wrong_by, const mpq_class& least) {
    const auto bits_of = [](const mpq_class& square) {
        return square == 0 ? -found_from : std::max(bits_of_root(square), 1 - found_from);
    };
    if (wrong_by) {
        const double bits = bits_of(*wrong_by);
        return *wrong_by == 0 ? found_from : 2 * found_from + (what == aim::nearest ? -bits : bits);
    }
    return std::min(-bits_of(least), found_from - 1);
}

std::optional<double> score_of_decision(const goal& g, const any_pair& p) {
    return std::visit(
        [&]<int N>(const precision::pair<N>& drawn) -> std::optional<double> {
            const auto q = precision::held(drawn, g.formulas.front()->type);
            const auto found = q ? ask(g, *q) : std::nullopt;
            if (!found) {
                return std::nullopt;
            }
            if (!found->given) { // where a decision is promised, none is a wrong one
                return found->formula->correctly_rounded ? std::optional(found_from) : std::nullopt;
            }
            const borders<N> near(*q);
            const auto wrong_by = near.square_to(*found->given);
            return score_by(g.what, wrong_by, wrong_by ? mpq_class(0) : near.least_square(*found->given));
        },
        p);
}

std::optional<double> score_of_order(const goal& g, const any_pair& first, const any_pair& second) {
    return std::visit(
        [&]<int N>(const precision::pair<N>& drawn) -> std::optional<double> {
            const auto& type = g.formulas.front()->type;
            const auto p = precision::held(drawn, type);
            const auto q = precision::held(std::get<precision::pair<N>>(second), type);
            if (!p || !q) {
                return std::nullopt;
            }
            const precision::truth<N> right_p(*p), right_q(*q);
            if (!precision::is_ordered(right_p) || !precision::is_ordered(right_q)) {
                return std::nullopt;
            }
            const oracle::surd &t = *right_p.met().time, &u = *right_q.met().time;
            const int order = oracle::compare(t, u);
            mpq_class square = 0;
            if (order != 0) {
                constexpr unsigned long precise = 512;
                const mpq_class x = oracle::approximate(t, precise), y = oracle::approximate(u, precise);
                mpq_class apart = (x - y) / std::max(x, y);
                if (apart == 0) { // too near for these to tell
                    mpq_div_2exp(apart.get_mpq_t(), mpq_class(1).get_mpq_t(), precise);
                }
                square = apart * apart;
            }
            for (const auto* formula : g.formulas) {
                try {
                    if (const auto given = (*formula)(*p, *q); given && given->order) {
                        const bool is_right = *given->order == order;
                        return score_by(g.what, is_right ? std::nullopt : std::optional(square), square);
                    }
                } catch (const std::exception&) {
                    return formula->correctly_rounded ? std::optional(found_from) : std::nullopt;
                }
            }
            return std::nullopt;
        },
        first);
}

std::optional<double> score_of_work(const goal& g, const any_pair& p) {
    return std::visit(
        [&](const auto& drawn) -> std::optional<double> {
            const auto q = precision::held(drawn, g.formulas.front()->type);
            if (!q) {
                return std::nullopt;
            }
            const auto before = work_done();
            const auto found = ask(g, *q);
            const bool is_answered = found && found->given; // otherwise it is bad input
            return is_answered ? std::optional(static_cast<double>(work_done() - before)) : std::nullopt;
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

std::vector<magnitudes::range> magnitudes::of(const any_pair& p) const {
    return std::visit(
        [&]<int N>(const precision::pair<N>& q) {
            std::vector<range> all;
            const auto add = [&](const range& r, int count = N) {
                all.insert(all.end(), static_cast<std::size_t>(count), r);
            };
            const auto ball = [&] {
                add(lengths);
                add(velocities);
                add(lengths, 1);
                add(masses, 1);
            };
            ball();
            if (std::holds_alternative<graze::ball<N, double>>(q.other)) {
                ball();
            } else if (std::holds_alternative<graze::plane<N, double>>(q.other)) {
                add(lengths);
                add({});
            } else {
                add(lengths, N * N); // a corner and N - 1 edges
            }
            return all;
        },
        p);
}

magnitudes::range range_from(const std::string& option, const std::string& text) {
    magnitudes::range r;
    const auto colon = text.find(':');
    const auto number = [&](const std::string& word, double& to) {
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), to);
        return error == std::errc() && end == word.data() + word.size() && to > 0 && std::isfinite(to);
    };
    if (colon == std::string::npos || !number(text.substr(0, colon), r.low) ||
        !number(text.substr(colon + 1), r.high) || r.low > r.high) {
        throw std::invalid_argument(option + " " + text +
                                    ": the least and the greatest magnitude expected, as 1e-3:1e3");
    }
    return r;
}

std::optional<double> goal::score(const any_pair& p, const any_pair* other) const {
    const auto is_within = [&](const any_pair& q) {
        const std::vector<magnitudes::range> ranges = within.of(q);
        const std::vector<double> numbers = std::visit([](const auto& r) { return precision::numbers_of(r); }, q);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (std::isfinite(numbers[i]) && !ranges[i].holds(numbers[i])) {
                return false;
            }
        }
        return true;
    };
    if (!is_within(p) || (other != nullptr && !is_within(*other))) {
        return std::nullopt;
    }
    if (is_about_orders()) {
        return other == nullptr ? std::nullopt : score_of_order(*this, p, *other);
    }
    switch (what) {
    case aim::nearest:
    case aim::farthest:
        return score_of_decision(*this, p);
    case aim::fallback:
        return score_of_work(*this, p);
    case aim::error:
        break;
    }
    for (const auto* formula : formulas) {
        const auto judged = precision::judge_one(*formula, of, p);
        if (judged && !judged->errors.empty()) {
            // Infinite if there is no number: that is an overflow and no loss of bits.
            const double largest = judged->largest();
            return std::isfinite(largest) ? std::optional(largest) : std::nullopt;
        }
    }
    return std::nullopt;
}

bool goal::is_found(double score) const { return what == aim::error || what == aim::fallback || score >= found_from; }

std::string goal::tell(double score) const {
    std::array<char, 96> text{};
    if (what == aim::error) {
        std::snprintf(text.data(), text.size(), "error of %.6g units in the last place", score);
    } else if (what == aim::fallback) {
        std::snprintf(text.data(), text.size(), "%.0f basic blocks of work", score);
    } else if (score == found_from) {
        return "wrong on the border itself";
    } else if (is_found(score)) {
        const double bits = score - 2 * found_from;
        std::snprintf(text.data(), text.size(), "wrong at 2^%.2f from the border",
                      logarithm_from(what == aim::nearest ? -bits : bits));
    } else {
        std::snprintf(text.data(), text.size(), "right at 2^%.2f from the border", logarithm_from(-score));
    }
    return text.data();
}

} // namespace search
