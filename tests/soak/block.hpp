// The definition of run_block, instantiated once in the plane and once in space.
#pragma once

#include "../oracle/encounter.hpp"
#include "soak.hpp"

#include <graze/overlaps.hpp>
#include <graze/time_of_impact.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace soak {

template <int N>
struct event {
    graze::impact_time<N> time;
    oracle::surd truth;
};

// The sign of an ordering, with 2 for `unordered`.
inline int sign_of(std::partial_ordering o) { return o < 0 ? -1 : o > 0 ? 1 : o == 0 ? 0 : 2; }

// A time near x, from its last place to far away; or x itself, if that is a double.
inline double near(families::random& r, double x) {
    const std::uint64_t step = r.below(4) == 0 ? 0 : std::uint64_t{1} << r.below(52);
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63);
    const std::uint64_t moved = r.one_in(2) ? bits + step : bits - std::min(bits, step);
    const double y = std::bit_cast<double>(moved);
    return std::isfinite(y) ? y : std::numeric_limits<double>::max();
}

template <int N>
class block {
  public:
    block(tally& seen, std::vector<event<N>>& earlier, families::random random)
        : seen_(seen), earlier_(earlier), random_(random) {}

    // Compares all answers about one pair. False if one of them is wrong.
    template <class A, class B>
    [[nodiscard]] bool decide(const A& a, const B& b) {
        auto decided_by = graze::stage::filter;
        const auto what = graze::classify(a, b, [&](graze::stage s) { decided_by = s; });
        const oracle::answer met = oracle::meet(a, b);
        ++seen_.pairs;
        ++seen_.encounters.at(static_cast<std::size_t>(met.what));
        seen_.exact += decided_by == graze::stage::exact ? 1U : 0U;
        seen_.hard += decided_by != graze::stage::filter ? 1U : 0U;
        const auto time = graze::time_of_impact(a, b);
        const bool right = static_cast<int>(what) == static_cast<int>(met.what) &&
                           graze::overlaps(a, b) == met.overlaps && time.has_value() == met.time.has_value();
        seen_.wrong += right ? 0U : 1U;
        if (!right || !time) {
            return right;
        }
        return order({*time, *met.time});
    }

  private:
    // Compares e with the last event, with an earlier one of any family, and with a double.
    [[nodiscard]] bool order(const event<N>& e) {
        bool right = true;
        if (!earlier_.empty()) {
            right = order(e, earlier_.back());
            right = order(earlier_[random_.below(earlier_.size())], e) && right;
        }
        earlier_.push_back(e);
        if (random_.one_in(8)) {
            const double m = near(random_, oracle::nearest_double(e.truth));
            right = count(sign_of(e.time <=> m), oracle::compare(e.truth, mpq_class(m))) && right;
        }
        return right;
    }
    [[nodiscard]] bool order(const event<N>& x, const event<N>& y) {
        auto decided_by = graze::stage::filter;
        const int sign = x.time.compare(y.time, [&](graze::stage s) { decided_by = s; });
        seen_.exact_orders += decided_by == graze::stage::exact ? 1U : 0U;
        return count(sign, oracle::compare(x.truth, y.truth));
    }
    [[nodiscard]] bool count(int sign, int truth) {
        ++seen_.orders;
        seen_.ties += truth == 0 ? 1U : 0U;
        seen_.wrong_orders += sign == truth ? 0U : 1U;
        return sign == truth;
    }

    tally& seen_;
    std::vector<event<N>>& earlier_;
    families::random random_;
};

template <int N>
void run_block(drawn what, std::uint64_t seed, std::uint64_t first, std::uint64_t count, tallies& seen,
               std::vector<std::string>& complaints) {
    std::vector<event<N>> earlier;
    for (std::size_t i = 0; i < families_drawn.size(); ++i) {
        const families::family& f = families_drawn[i];
        for (std::uint64_t index = first; index < first + count; ++index) {
            const auto pair = f.draw<N>(seed, index);
            block<N> one(seen[i], earlier, families::random(seed ^ 0x5bd1e995, index * families_drawn.size() + i));
            if (what == drawn::triangles) {
                if constexpr (N == 3) {
                    if (pair.kind == families::pair_kind::ball_wall &&
                        !one.decide(pair.a, graze::triangle<double>{pair.wall.corner, pair.wall.edge})) {
                        complaints.push_back("triangle, " + std::string(f.name) + ", seed " + std::to_string(seed) +
                                             ", pair " + std::to_string(index));
                    }
                }
                continue;
            }
            const bool right = pair.kind == families::pair_kind::ball_ball    ? one.decide(pair.a, pair.b)
                               : pair.kind == families::pair_kind::ball_plane ? one.decide(pair.a, pair.plane)
                                                                              : one.decide(pair.a, pair.wall);
            if (!right) {
                complaints.push_back(std::string(f.name) + " " + std::to_string(N) + "D, seed " + std::to_string(seed) +
                                     ", pair " + std::to_string(index));
            }
        }
    }
}

} // namespace soak
