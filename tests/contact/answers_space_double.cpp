#include "answers_definition.hpp"

namespace answers {

template answer<3, double, graze::contact<3, double>> of(const graze::ball<3, double>&, const graze::ball<3, double>&);
template answer<3, double, graze::wall_contact<3, double>> of(const graze::ball<3, double>&,
                                                              const graze::plane<3, double>&);
template answer<3, double, graze::wall_contact<3, double>> of(const graze::ball<3, double>&,
                                                              const graze::wall<3, double>&);

template answer<3, double, graze::wall_contact<3, double>> of(const graze::ball<3, double>&,
                                                              const graze::triangle<double>&);

} // namespace answers
