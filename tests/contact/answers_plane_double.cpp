#include "answers_definition.hpp"

namespace answers {

template answer<2, double, graze::contact<2, double>> of(const graze::ball<2, double>&, const graze::ball<2, double>&);
template answer<2, double, graze::wall_contact<2, double>> of(const graze::ball<2, double>&,
                                                              const graze::plane<2, double>&);
template answer<2, double, graze::wall_contact<2, double>> of(const graze::ball<2, double>&,
                                                              const graze::wall<2, double>&);

} // namespace answers
