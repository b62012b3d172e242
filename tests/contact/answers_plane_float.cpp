#include "answers_definition.hpp"

namespace answers {

template answer<2, float, graze::contact<2, float>> of(const graze::ball<2, float>&, const graze::ball<2, float>&);
template answer<2, float, graze::wall_contact<2, float>> of(const graze::ball<2, float>&,
                                                            const graze::plane<2, float>&);
template answer<2, float, graze::wall_contact<2, float>> of(const graze::ball<2, float>&, const graze::wall<2, float>&);

} // namespace answers
