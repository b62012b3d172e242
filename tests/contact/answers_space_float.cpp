#include "answers_definition.hpp"

namespace answers {

template answer<3, float, graze::contact<3, float>> of(const graze::ball<3, float>&, const graze::ball<3, float>&);
template answer<3, float, graze::wall_contact<3, float>> of(const graze::ball<3, float>&,
                                                            const graze::plane<3, float>&);
template answer<3, float, graze::wall_contact<3, float>> of(const graze::ball<3, float>&, const graze::wall<3, float>&);

template answer<3, float, graze::wall_contact<3, float>> of(const graze::ball<3, float>&,
                                                            const graze::triangle<float>&);

} // namespace answers
