// The cold stages of times: graze::compiled contains them, so that a unit need not compile them.
#pragma once

#include <graze/time/time_of_flights.hpp>
#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

namespace graze::inline v0_1::detail {

extern template int compare_exactly(const event<2, float>&, const event<2, float>&);
extern template int compare_exactly(const event<3, float>&, const event<3, float>&);
extern template int compare_exactly(const event<2, double>&, const event<2, double>&);
extern template int compare_exactly(const event<3, double>&, const event<3, double>&);
extern template int compare_exactly(const event<2, float>&, const binary&);
extern template int compare_exactly(const event<3, float>&, const binary&);
extern template int compare_exactly(const event<2, double>&, const binary&);
extern template int compare_exactly(const event<3, double>&, const binary&);
extern template float round_hard_time<float>(const event<2, float>&, double);
extern template float round_slowly<float>(const event<2, float>&, double, rounding);
extern template float round_hard_time<float>(const event<3, float>&, double);
extern template float round_slowly<float>(const event<3, float>&, double, rounding);
extern template float round_exactly<float>(const exact_root&, rounding);
extern template double round_hard_time<double>(const event<2, double>&, double);
extern template double round_slowly<double>(const event<2, double>&, double, rounding);
extern template double round_hard_time<double>(const event<3, double>&, double);
extern template double round_slowly<double>(const event<3, double>&, double, rounding);
extern template double round_exactly<double>(const exact_root&, rounding);
extern template struct procedures_of<2, float, two_balls<2>, false>;
extern template struct procedures_of<2, float, two_balls<2>, true>;
extern template struct procedures_of<2, float, ball_and_plane<2>, false>;
extern template struct procedures_of<2, float, ball_and_plane<2>, true>;
extern template struct procedures_of<2, float, ball_and_wall<2>, false>;
extern template struct procedures_of<2, float, ball_and_wall<2>, true>;
extern template struct procedures_of<2, double, two_balls<2>, false>;
extern template struct procedures_of<2, double, two_balls<2>, true>;
extern template struct procedures_of<2, double, ball_and_plane<2>, false>;
extern template struct procedures_of<2, double, ball_and_plane<2>, true>;
extern template struct procedures_of<2, double, ball_and_wall<2>, false>;
extern template struct procedures_of<2, double, ball_and_wall<2>, true>;
extern template struct procedures_of<3, float, two_balls<3>, false>;
extern template struct procedures_of<3, float, two_balls<3>, true>;
extern template struct procedures_of<3, float, ball_and_plane<3>, false>;
extern template struct procedures_of<3, float, ball_and_plane<3>, true>;
extern template struct procedures_of<3, float, ball_and_wall<3>, false>;
extern template struct procedures_of<3, float, ball_and_wall<3>, true>;
extern template struct procedures_of<3, double, two_balls<3>, false>;
extern template struct procedures_of<3, double, two_balls<3>, true>;
extern template struct procedures_of<3, double, ball_and_plane<3>, false>;
extern template struct procedures_of<3, double, ball_and_plane<3>, true>;
extern template struct procedures_of<3, double, ball_and_wall<3>, false>;
extern template struct procedures_of<3, double, ball_and_wall<3>, true>;
extern template flat_time flat_time_in_doubles(const event_row<2, float>&, double) noexcept;
extern template flat_time flat_time_in_doubles(const event_row<3, float>&, double) noexcept;
extern template flat_time flat_time_in_doubles(const event_row<2, double>&, double) noexcept;
extern template flat_time flat_time_in_doubles(const event_row<3, double>&, double) noexcept;
extern template std::optional<impact_time<2, float>> time_of_overlap(const ball<2, float>&, const ball<2, float>&);
extern template std::optional<impact_time<2, float>> time_of_overlap(const flight<2, float>&, const flight<2, float>&);
extern template std::optional<impact_time<3, float>> time_of_overlap(const ball<3, float>&, const ball<3, float>&);
extern template std::optional<impact_time<3, float>> time_of_overlap(const flight<3, float>&, const flight<3, float>&);
extern template std::optional<impact_time<2, double>> time_of_overlap(const ball<2, double>&, const ball<2, double>&);
extern template std::optional<impact_time<2, double>> time_of_overlap(const flight<2, double>&,
                                                                      const flight<2, double>&);
extern template std::optional<impact_time<3, double>> time_of_overlap(const ball<3, double>&, const ball<3, double>&);
extern template std::optional<impact_time<3, double>> time_of_overlap(const flight<3, double>&,
                                                                      const flight<3, double>&);
extern template std::optional<impact_time<2, float>> time_of_impact_exactly(const ball<2, float>&,
                                                                            const ball<2, float>&);
extern template std::optional<impact_time<3, float>> time_of_impact_exactly(const ball<3, float>&,
                                                                            const ball<3, float>&);
extern template std::optional<impact_time<2, double>> time_of_impact_exactly(const ball<2, double>&,
                                                                             const ball<2, double>&);
extern template std::optional<impact_time<3, double>> time_of_impact_exactly(const ball<3, double>&,
                                                                             const ball<3, double>&);
extern template impact_time<2, float> enclosed_exactly(event<2, float>);
extern template impact_time<3, float> enclosed_exactly(event<3, float>);
extern template impact_time<2, double> enclosed_exactly(event<2, double>);
extern template impact_time<3, double> enclosed_exactly(event<3, double>);
extern template impact_time<2, float> enclosed_slowly(const event<2, float>&, encounter);
extern template impact_time<3, float> enclosed_slowly(const event<3, float>&, encounter);
extern template impact_time<2, double> enclosed_slowly(const event<2, double>&, encounter);
extern template impact_time<3, double> enclosed_slowly(const event<3, double>&, encounter);
extern template std::optional<impact_time<2, float>> time_of_plane_slowly(const ball<2, float>&, const plane<2, float>&,
                                                                          encounter);
extern template std::optional<impact_time<3, float>> time_of_plane_slowly(const ball<3, float>&, const plane<3, float>&,
                                                                          encounter);
extern template std::optional<impact_time<2, double>> time_of_plane_slowly(const ball<2, double>&,
                                                                           const plane<2, double>&, encounter);
extern template std::optional<impact_time<3, double>> time_of_plane_slowly(const ball<3, double>&,
                                                                           const plane<3, double>&, encounter);
extern template std::optional<impact_time<2, float>> time_of_flat_slowly(const ball<2, float>&, const wall<2, float>&,
                                                                         const flat_answer&);
extern template std::optional<impact_time<3, float>> time_of_flat_slowly(const ball<3, float>&, const wall<3, float>&,
                                                                         const flat_answer&);
extern template std::optional<impact_time<2, double>> time_of_flat_slowly(const ball<2, double>&,
                                                                          const wall<2, double>&, const flat_answer&);
extern template std::optional<impact_time<3, double>> time_of_flat_slowly(const ball<3, double>&,
                                                                          const wall<3, double>&, const flat_answer&);
extern template std::optional<impact_time<2, double>> time_in_unusual_units(const ball<2, double>&,
                                                                            const ball<2, double>&, stage&);
extern template std::optional<impact_time<3, double>> time_in_unusual_units(const ball<3, double>&,
                                                                            const ball<3, double>&, stage&);
extern template std::optional<impact_time<2, float>> time_of_impact_further(const ball<2, float>&,
                                                                            const ball<2, float>&, stage&);
extern template std::optional<impact_time<2, float>> time_of_impact_further(const flight<2, float>&,
                                                                            const flight<2, float>&, stage&);
extern template std::optional<impact_time<3, float>> time_of_impact_further(const ball<3, float>&,
                                                                            const ball<3, float>&, stage&);
extern template std::optional<impact_time<3, float>> time_of_impact_further(const flight<3, float>&,
                                                                            const flight<3, float>&, stage&);
extern template std::optional<impact_time<2, double>> time_of_impact_further(const ball<2, double>&,
                                                                             const ball<2, double>&, stage&);
extern template std::optional<impact_time<2, double>> time_of_impact_further(const flight<2, double>&,
                                                                             const flight<2, double>&, stage&);
extern template std::optional<impact_time<3, double>> time_of_impact_further(const ball<3, double>&,
                                                                             const ball<3, double>&, stage&);
extern template std::optional<impact_time<3, double>> time_of_impact_further(const flight<3, double>&,
                                                                             const flight<3, double>&, stage&);
extern template std::optional<impact_time<2, float>> time_of_impact_exactly(const flight<2, float>&,
                                                                            const flight<2, float>&);
extern template std::optional<impact_time<3, float>> time_of_impact_exactly(const flight<3, float>&,
                                                                            const flight<3, float>&);
extern template std::optional<impact_time<2, double>> time_of_impact_exactly(const flight<2, double>&,
                                                                             const flight<2, double>&);
extern template std::optional<impact_time<3, double>> time_of_impact_exactly(const flight<3, double>&,
                                                                             const flight<3, double>&);
extern template flat_collision meet_flat(const ball<2, float>&, const wall<2, float>&, stage&);
extern template flat_collision meet_flat(const ball<3, float>&, const wall<3, float>&, stage&);
extern template flat_collision meet_flat(const ball<3, float>&, const triangle<float>&, stage&);
extern template flat_collision meet_flat(const ball<2, double>&, const wall<2, double>&, stage&);
extern template flat_collision meet_flat(const ball<3, double>&, const wall<3, double>&, stage&);
extern template flat_collision meet_flat(const ball<3, double>&, const triangle<double>&, stage&);

} // namespace graze::inline v0_1::detail
