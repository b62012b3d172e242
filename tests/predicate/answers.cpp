#include "answers_of_type.hpp"

template graze::encounter answers::encounter_of(const graze::ball<2, double>&, const graze::ball<2, double>&,
                                                graze::stage&);
template bool answers::overlap_of(const graze::ball<2, double>&, const graze::ball<2, double>&, graze::stage&);
template std::optional<graze::impact_time<2, double>> answers::time_of(const graze::ball<2, double>&,
                                                                       const graze::ball<2, double>&);

template graze::encounter answers::encounter_of(const graze::ball<2, double>&, const graze::plane<2, double>&,
                                                graze::stage&);
template bool answers::overlap_of(const graze::ball<2, double>&, const graze::plane<2, double>&, graze::stage&);
template std::optional<graze::impact_time<2, double>> answers::time_of(const graze::ball<2, double>&,
                                                                       const graze::plane<2, double>&);

template graze::encounter answers::encounter_of(const graze::ball<2, double>&, const graze::wall<2, double>&,
                                                graze::stage&);
template bool answers::overlap_of(const graze::ball<2, double>&, const graze::wall<2, double>&, graze::stage&);
template std::optional<graze::impact_time<2, double>> answers::time_of(const graze::ball<2, double>&,
                                                                       const graze::wall<2, double>&);

template int answers::order_of(const graze::impact_time<2, double>&, const graze::impact_time<2, double>&);
template int answers::order_of(const graze::impact_time<2, double>&, const double&);

template graze::encounter answers::encounter_of(const graze::ball<3, double>&, const graze::ball<3, double>&,
                                                graze::stage&);
template bool answers::overlap_of(const graze::ball<3, double>&, const graze::ball<3, double>&, graze::stage&);
template std::optional<graze::impact_time<3, double>> answers::time_of(const graze::ball<3, double>&,
                                                                       const graze::ball<3, double>&);

template graze::encounter answers::encounter_of(const graze::ball<3, double>&, const graze::plane<3, double>&,
                                                graze::stage&);
template bool answers::overlap_of(const graze::ball<3, double>&, const graze::plane<3, double>&, graze::stage&);
template std::optional<graze::impact_time<3, double>> answers::time_of(const graze::ball<3, double>&,
                                                                       const graze::plane<3, double>&);

template graze::encounter answers::encounter_of(const graze::ball<3, double>&, const graze::wall<3, double>&,
                                                graze::stage&);
template bool answers::overlap_of(const graze::ball<3, double>&, const graze::wall<3, double>&, graze::stage&);
template std::optional<graze::impact_time<3, double>> answers::time_of(const graze::ball<3, double>&,
                                                                       const graze::wall<3, double>&);

template int answers::order_of(const graze::impact_time<3, double>&, const graze::impact_time<3, double>&);
template int answers::order_of(const graze::impact_time<3, double>&, const double&);
