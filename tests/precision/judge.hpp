// Compares one answer with the truth.
#pragma once

#include "truth.hpp"

#include <map>

namespace precision {

using graze::precision::reading;
using graze::precision::subject;

// About one quantity of one pair. wrong: the decision is, or the sign of a number that stands for a decision. errors:
// in units in the last place that the exact value (of a vector, its largest component) has in the type; infinite if
// there is no number. A number where the exact one is 0 has no such error and only counts as misrounded.
struct verdict {
    bool wrong = false;
    std::size_t values = 0, misrounded = 0;
    std::vector<double> errors;

    [[nodiscard]] double largest() const;
};

using verdicts = std::map<quantity, verdict>;

// Empty if the formula is not about such a pair.
template <int N>
[[nodiscard]] verdicts judge(const subject& formula, const pair<N>& p, const truth<N>& right);

// The same for an order: the two pairs must be apart and collide, as is_ordered says.
template <int N>
[[nodiscard]] bool is_ordered(const truth<N>& p);
template <int N>
[[nodiscard]] verdicts judge(const subject& formula, const pair<N>& p, const pair<N>& q, const truth<N>& right_p,
                             const truth<N>& right_q);

// The reading's exact value; nothing if it is no number.
[[nodiscard]] std::optional<mpq_class> exactly(const reading& x);

extern template verdicts judge(const subject&, const pair<2>&, const truth<2>&);
extern template verdicts judge(const subject&, const pair<3>&, const truth<3>&);
extern template bool is_ordered(const truth<2>&);
extern template bool is_ordered(const truth<3>&);
extern template verdicts judge(const subject&, const pair<2>&, const pair<2>&, const truth<2>&, const truth<2>&);
extern template verdicts judge(const subject&, const pair<3>&, const pair<3>&, const truth<3>&, const truth<3>&);

} // namespace precision
