// Compares one answer with the truth.
#pragma once

#include "truth.hpp"

#include <map>

namespace precision {

using graze::precision::reading;
using graze::precision::subject;

// Of one quantity of one pair. wrong: the decision, or the sign of a number whose sign is one. errors: in units in the
// last place that the exact value has in the type (of a vector, its largest component); infinite where there is no
// number. A number beside an exact 0 has no such error and counts as misrounded alone.
struct verdict {
    bool wrong = false;
    std::size_t values = 0, misrounded = 0;
    std::vector<double> errors;

    [[nodiscard]] double largest() const;
};

using verdicts = std::map<quantity, verdict>;

// Empty where the formula is not about such a pair.
template <int N>
[[nodiscard]] verdicts judge(const subject& formula, const pair<N>& p, const truth<N>& right);

// Of an order: both pairs must be apart and collide, as is_ordered says.
template <int N>
[[nodiscard]] bool is_ordered(const truth<N>& p);
template <int N>
[[nodiscard]] verdicts judge(const subject& formula, const pair<N>& p, const pair<N>& q, const truth<N>& right_p,
                             const truth<N>& right_q);

// What the reading says; nothing where it is no number.
[[nodiscard]] std::optional<mpq_class> exactly(const reading& x);

extern template verdicts judge(const subject&, const pair<2>&, const truth<2>&);
extern template verdicts judge(const subject&, const pair<3>&, const truth<3>&);
extern template bool is_ordered(const truth<2>&);
extern template bool is_ordered(const truth<3>&);
extern template verdicts judge(const subject&, const pair<2>&, const pair<2>&, const truth<2>&, const truth<2>&);
extern template verdicts judge(const subject&, const pair<3>&, const pair<3>&, const truth<3>&, const truth<3>&);

} // namespace precision
