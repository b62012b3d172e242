// The source of graze::compiled: the cold stages of decisions, times and contacts, for float and double in the plane
// and in space. It is compiled with exceptions and without -ffast-math; what uses it may be compiled with either.
#include <graze/collide.hpp>
#include <graze/time_of_impact.hpp>

namespace graze::inline v0_1::detail {

template encounter classify_exactly(const ball<2, float>&, const ball<2, float>&, const open_number&);
template encounter classify_exactly(const ball<3, float>&, const ball<3, float>&, const open_number&);
template encounter classify_exactly(const ball<2, double>&, const ball<2, double>&, const open_number&);
template encounter classify_exactly(const ball<3, double>&, const ball<3, double>&, const open_number&);
template decided_balls classify_further(const ball<2, float>&, const ball<2, float>&);
template decided_balls classify_further(const ball<3, float>&, const ball<3, float>&);
template decided_balls classify_further(const ball<2, double>&, const ball<2, double>&);
template decided_balls classify_further(const ball<3, double>&, const ball<3, double>&);
template flat_answer decide_plane_slowly(const ball<2, float>&, const plane<2, float>&, flat_question, stage&);
template flat_answer decide_plane_slowly(const ball<3, float>&, const plane<3, float>&, flat_question, stage&);
template flat_answer decide_plane_slowly(const ball<2, double>&, const plane<2, double>&, flat_question, stage&);
template flat_answer decide_plane_slowly(const ball<3, double>&, const plane<3, double>&, flat_question, stage&);
template flat_answer decide_flat_slowly<flat_question::what>(const ball<2, float>&, const wall<2, float>&, stage&);
template flat_answer decide_flat_slowly<flat_question::what>(const ball<3, float>&, const wall<3, float>&, stage&);
template flat_answer decide_flat_slowly<flat_question::what>(const ball<2, double>&, const wall<2, double>&, stage&);
template flat_answer decide_flat_slowly<flat_question::what>(const ball<3, double>&, const wall<3, double>&, stage&);
template flat_answer decide_flat_slowly<flat_question::what>(const ball<3, float>&, const triangle<float>&, stage&);
template flat_answer decide_flat_slowly<flat_question::what>(const ball<3, double>&, const triangle<double>&, stage&);
template flat_answer decide_flat_slowly<flat_question::feature>(const ball<2, float>&, const wall<2, float>&, stage&);
template flat_answer decide_flat_slowly<flat_question::feature>(const ball<3, float>&, const wall<3, float>&, stage&);
template flat_answer decide_flat_slowly<flat_question::feature>(const ball<2, double>&, const wall<2, double>&, stage&);
template flat_answer decide_flat_slowly<flat_question::feature>(const ball<3, double>&, const wall<3, double>&, stage&);
template flat_answer decide_flat_slowly<flat_question::feature>(const ball<3, float>&, const triangle<float>&, stage&);
template flat_answer decide_flat_slowly<flat_question::feature>(const ball<3, double>&, const triangle<double>&,
                                                                stage&);
template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<2, float>&, const wall<2, float>&, stage&);
template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<3, float>&, const wall<3, float>&, stage&);
template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<2, double>&, const wall<2, double>&,
                                                                  stage&);
template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<3, double>&, const wall<3, double>&,
                                                                  stage&);
template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<3, float>&, const triangle<float>&,
                                                                  stage&);
template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<3, double>&, const triangle<double>&,
                                                                  stage&);
template flat_answer decide_flat<flat_question::what>(const ball<2, float>&, const wall<2, float>&, stage&);
template flat_answer decide_flat<flat_question::feature>(const ball<2, float>&, const wall<2, float>&, stage&);
template flat_answer decide_flat<flat_question::clearance>(const ball<2, float>&, const wall<2, float>&, stage&);
template flat_answer decide_flat<flat_question::what>(const ball<3, float>&, const wall<3, float>&, stage&);
template flat_answer decide_flat<flat_question::feature>(const ball<3, float>&, const wall<3, float>&, stage&);
template flat_answer decide_flat<flat_question::clearance>(const ball<3, float>&, const wall<3, float>&, stage&);
template flat_answer decide_flat<flat_question::what>(const ball<3, float>&, const triangle<float>&, stage&);
template flat_answer decide_flat<flat_question::feature>(const ball<3, float>&, const triangle<float>&, stage&);
template flat_answer decide_flat<flat_question::clearance>(const ball<3, float>&, const triangle<float>&, stage&);
template flat_answer decide_flat<flat_question::what>(const ball<2, double>&, const wall<2, double>&, stage&);
template flat_answer decide_flat<flat_question::feature>(const ball<2, double>&, const wall<2, double>&, stage&);
template flat_answer decide_flat<flat_question::clearance>(const ball<2, double>&, const wall<2, double>&, stage&);
template flat_answer decide_flat<flat_question::what>(const ball<3, double>&, const wall<3, double>&, stage&);
template flat_answer decide_flat<flat_question::feature>(const ball<3, double>&, const wall<3, double>&, stage&);
template flat_answer decide_flat<flat_question::clearance>(const ball<3, double>&, const wall<3, double>&, stage&);
template flat_answer decide_flat<flat_question::what>(const ball<3, double>&, const triangle<double>&, stage&);
template flat_answer decide_flat<flat_question::feature>(const ball<3, double>&, const triangle<double>&, stage&);
template flat_answer decide_flat<flat_question::clearance>(const ball<3, double>&, const triangle<double>&, stage&);
template flat_collision meet_flat(const ball<2, float>&, const wall<2, float>&, stage&);
template flat_collision meet_flat(const ball<3, float>&, const wall<3, float>&, stage&);
template flat_collision meet_flat(const ball<3, float>&, const triangle<float>&, stage&);
template flat_collision meet_flat(const ball<2, double>&, const wall<2, double>&, stage&);
template flat_collision meet_flat(const ball<3, double>&, const wall<3, double>&, stage&);
template flat_collision meet_flat(const ball<3, double>&, const triangle<double>&, stage&);
template encounter classify_exactly(const flight<2, float>&, const flight<2, float>&, const open_number&);
template encounter classify_exactly(const flight<3, float>&, const flight<3, float>&, const open_number&);
template encounter classify_exactly(const flight<2, double>&, const flight<2, double>&, const open_number&);
template encounter classify_exactly(const flight<3, double>&, const flight<3, double>&, const open_number&);

template int compare_exactly(const event<2, float>&, const event<2, float>&);
template int compare_exactly(const event<3, float>&, const event<3, float>&);
template int compare_exactly(const event<2, double>&, const event<2, double>&);
template int compare_exactly(const event<3, double>&, const event<3, double>&);
template int compare_exactly(const event<2, float>&, const binary&);
template int compare_exactly(const event<3, float>&, const binary&);
template int compare_exactly(const event<2, double>&, const binary&);
template int compare_exactly(const event<3, double>&, const binary&);
template float round_hard_time<float>(const event<2, float>&, double);
template float round_slowly<float>(const event<2, float>&, double, rounding);
template float round_hard_time<float>(const event<3, float>&, double);
template float round_slowly<float>(const event<3, float>&, double, rounding);
template float round_exactly<float>(const exact_root&, rounding);
template double round_hard_time<double>(const event<2, double>&, double);
template double round_slowly<double>(const event<2, double>&, double, rounding);
template double round_hard_time<double>(const event<3, double>&, double);
template double round_slowly<double>(const event<3, double>&, double, rounding);
template double round_exactly<double>(const exact_root&, rounding);
template struct procedures_of<2, float, two_balls<2>, false>;
template struct procedures_of<2, float, two_balls<2>, true>;
template struct procedures_of<2, float, ball_and_plane<2>, false>;
template struct procedures_of<2, float, ball_and_plane<2>, true>;
template struct procedures_of<2, float, ball_and_wall<2>, false>;
template struct procedures_of<2, float, ball_and_wall<2>, true>;
template struct procedures_of<2, double, two_balls<2>, false>;
template struct procedures_of<2, double, two_balls<2>, true>;
template struct procedures_of<2, double, ball_and_plane<2>, false>;
template struct procedures_of<2, double, ball_and_plane<2>, true>;
template struct procedures_of<2, double, ball_and_wall<2>, false>;
template struct procedures_of<2, double, ball_and_wall<2>, true>;
template struct procedures_of<3, float, two_balls<3>, false>;
template struct procedures_of<3, float, two_balls<3>, true>;
template struct procedures_of<3, float, ball_and_plane<3>, false>;
template struct procedures_of<3, float, ball_and_plane<3>, true>;
template struct procedures_of<3, float, ball_and_wall<3>, false>;
template struct procedures_of<3, float, ball_and_wall<3>, true>;
template struct procedures_of<3, double, two_balls<3>, false>;
template struct procedures_of<3, double, two_balls<3>, true>;
template struct procedures_of<3, double, ball_and_plane<3>, false>;
template struct procedures_of<3, double, ball_and_plane<3>, true>;
template struct procedures_of<3, double, ball_and_wall<3>, false>;
template struct procedures_of<3, double, ball_and_wall<3>, true>;
template flat_time flat_time_in_doubles(const event_row<2, float>&, double) noexcept;
template flat_time flat_time_in_doubles(const event_row<3, float>&, double) noexcept;
template flat_time flat_time_in_doubles(const event_row<2, double>&, double) noexcept;
template flat_time flat_time_in_doubles(const event_row<3, double>&, double) noexcept;
template std::optional<impact_time<2, float>> time_of_overlap(const ball<2, float>&, const ball<2, float>&);
template std::optional<impact_time<2, float>> time_of_overlap(const flight<2, float>&, const flight<2, float>&);
template std::optional<impact_time<3, float>> time_of_overlap(const ball<3, float>&, const ball<3, float>&);
template std::optional<impact_time<3, float>> time_of_overlap(const flight<3, float>&, const flight<3, float>&);
template std::optional<impact_time<2, double>> time_of_overlap(const ball<2, double>&, const ball<2, double>&);
template std::optional<impact_time<2, double>> time_of_overlap(const flight<2, double>&, const flight<2, double>&);
template std::optional<impact_time<3, double>> time_of_overlap(const ball<3, double>&, const ball<3, double>&);
template std::optional<impact_time<3, double>> time_of_overlap(const flight<3, double>&, const flight<3, double>&);
template std::optional<impact_time<2, float>> time_of_impact_exactly(const ball<2, float>&, const ball<2, float>&);
template std::optional<impact_time<3, float>> time_of_impact_exactly(const ball<3, float>&, const ball<3, float>&);
template std::optional<impact_time<2, double>> time_of_impact_exactly(const ball<2, double>&, const ball<2, double>&);
template std::optional<impact_time<3, double>> time_of_impact_exactly(const ball<3, double>&, const ball<3, double>&);
template impact_time<2, float> enclosed_exactly(event<2, float>);
template impact_time<3, float> enclosed_exactly(event<3, float>);
template impact_time<2, double> enclosed_exactly(event<2, double>);
template impact_time<3, double> enclosed_exactly(event<3, double>);
template impact_time<2, float> enclosed_slowly(const event<2, float>&, encounter);
template impact_time<3, float> enclosed_slowly(const event<3, float>&, encounter);
template impact_time<2, double> enclosed_slowly(const event<2, double>&, encounter);
template impact_time<3, double> enclosed_slowly(const event<3, double>&, encounter);
template std::optional<impact_time<2, float>> time_of_plane_slowly(const ball<2, float>&, const plane<2, float>&,
                                                                   encounter);
template std::optional<impact_time<3, float>> time_of_plane_slowly(const ball<3, float>&, const plane<3, float>&,
                                                                   encounter);
template std::optional<impact_time<2, double>> time_of_plane_slowly(const ball<2, double>&, const plane<2, double>&,
                                                                    encounter);
template std::optional<impact_time<3, double>> time_of_plane_slowly(const ball<3, double>&, const plane<3, double>&,
                                                                    encounter);
template std::optional<impact_time<2, float>> time_of_flat_slowly(const ball<2, float>&, const wall<2, float>&,
                                                                  const flat_answer&);
template std::optional<impact_time<3, float>> time_of_flat_slowly(const ball<3, float>&, const wall<3, float>&,
                                                                  const flat_answer&);
template std::optional<impact_time<2, double>> time_of_flat_slowly(const ball<2, double>&, const wall<2, double>&,
                                                                   const flat_answer&);
template std::optional<impact_time<3, double>> time_of_flat_slowly(const ball<3, double>&, const wall<3, double>&,
                                                                   const flat_answer&);
template std::optional<impact_time<2, double>> time_in_unusual_units(const ball<2, double>&, const ball<2, double>&,
                                                                     stage&);
template std::optional<impact_time<3, double>> time_in_unusual_units(const ball<3, double>&, const ball<3, double>&,
                                                                     stage&);
template std::optional<impact_time<2, float>> time_of_impact_further(const ball<2, float>&, const ball<2, float>&,
                                                                     stage&);
template std::optional<impact_time<2, float>> time_of_impact_further(const flight<2, float>&, const flight<2, float>&,
                                                                     stage&);
template std::optional<impact_time<3, float>> time_of_impact_further(const ball<3, float>&, const ball<3, float>&,
                                                                     stage&);
template std::optional<impact_time<3, float>> time_of_impact_further(const flight<3, float>&, const flight<3, float>&,
                                                                     stage&);
template std::optional<impact_time<2, double>> time_of_impact_further(const ball<2, double>&, const ball<2, double>&,
                                                                      stage&);
template std::optional<impact_time<2, double>> time_of_impact_further(const flight<2, double>&,
                                                                      const flight<2, double>&, stage&);
template std::optional<impact_time<3, double>> time_of_impact_further(const ball<3, double>&, const ball<3, double>&,
                                                                      stage&);
template std::optional<impact_time<3, double>> time_of_impact_further(const flight<3, double>&,
                                                                      const flight<3, double>&, stage&);
template std::optional<impact_time<2, float>> time_of_impact_exactly(const flight<2, float>&, const flight<2, float>&);
template std::optional<impact_time<3, float>> time_of_impact_exactly(const flight<3, float>&, const flight<3, float>&);
template std::optional<impact_time<2, double>> time_of_impact_exactly(const flight<2, double>&,
                                                                      const flight<2, double>&);
template std::optional<impact_time<3, double>> time_of_impact_exactly(const flight<3, double>&,
                                                                      const flight<3, double>&);

template component_set contact_in_doubles(contact<2, float>&, encounter, const ball<2, float>&, const ball<2, float>&,
                                          double, double, double) noexcept;
template component_set contact_in_doubles(contact<2, float>&, encounter, const flight<2, float>&,
                                          const flight<2, float>&, double, double, double) noexcept;
template component_set contact_in_doubles(contact<3, float>&, encounter, const ball<3, float>&, const ball<3, float>&,
                                          double, double, double) noexcept;
template component_set contact_in_doubles(contact<3, float>&, encounter, const flight<3, float>&,
                                          const flight<3, float>&, double, double, double) noexcept;
template component_set contact_in_doubles(contact<2, double>&, encounter, const ball<2, double>&,
                                          const ball<2, double>&, double, double, double) noexcept;
template component_set contact_in_doubles(contact<2, double>&, encounter, const flight<2, double>&,
                                          const flight<2, double>&, double, double, double) noexcept;
template component_set contact_in_doubles(contact<3, double>&, encounter, const ball<3, double>&,
                                          const ball<3, double>&, double, double, double) noexcept;
template component_set contact_in_doubles(contact<3, double>&, encounter, const flight<3, double>&,
                                          const flight<3, double>&, double, double, double) noexcept;
template void complete(contact<2, float>&, component_set, encounter, const ball<2, float>&, const ball<2, float>&);
template void complete(contact<3, float>&, component_set, encounter, const ball<3, float>&, const ball<3, float>&);
template void complete(contact<2, double>&, component_set, encounter, const ball<2, double>&, const ball<2, double>&);
template void complete(contact<3, double>&, component_set, encounter, const ball<3, double>&, const ball<3, double>&);
template optional_contact<ball<2, float>> collide_further(const ball<2, float>&, const ball<2, float>&, stage&);
template optional_contact<flight<2, float>> collide_further(const flight<2, float>&, const flight<2, float>&, stage&);
template optional_contact<ball<3, float>> collide_further(const ball<3, float>&, const ball<3, float>&, stage&);
template optional_contact<flight<3, float>> collide_further(const flight<3, float>&, const flight<3, float>&, stage&);
template optional_contact<ball<2, double>> collide_further(const ball<2, double>&, const ball<2, double>&, stage&);
template optional_contact<flight<2, double>> collide_further(const flight<2, double>&, const flight<2, double>&,
                                                             stage&);
template optional_contact<ball<3, double>> collide_further(const ball<3, double>&, const ball<3, double>&, stage&);
template optional_contact<flight<3, double>> collide_further(const flight<3, double>&, const flight<3, double>&,
                                                             stage&);
template stage complete_further(contact<2, float>&, component_set, encounter, const ball<2, float>&,
                                const ball<2, float>&);
template stage complete_further(contact<2, float>&, component_set, encounter, const flight<2, float>&,
                                const flight<2, float>&);
template stage complete_further(contact<3, float>&, component_set, encounter, const ball<3, float>&,
                                const ball<3, float>&);
template stage complete_further(contact<3, float>&, component_set, encounter, const flight<3, float>&,
                                const flight<3, float>&);
template stage complete_further(contact<2, double>&, component_set, encounter, const ball<2, double>&,
                                const ball<2, double>&);
template stage complete_further(contact<2, double>&, component_set, encounter, const flight<2, double>&,
                                const flight<2, double>&);
template stage complete_further(contact<3, double>&, component_set, encounter, const ball<3, double>&,
                                const ball<3, double>&);
template stage complete_further(contact<3, double>&, component_set, encounter, const flight<3, double>&,
                                const flight<3, double>&);
template void complete(ball_and_plane<2>, wall_contact<2, float>&, component_set, encounter, int, const ball<2, float>&,
                       const plane<2, float>&);
template void complete(ball_and_plane<3>, wall_contact<3, float>&, component_set, encounter, int, const ball<3, float>&,
                       const plane<3, float>&);
template void complete(ball_and_plane<2>, wall_contact<2, double>&, component_set, encounter, int,
                       const ball<2, double>&, const plane<2, double>&);
template void complete(ball_and_plane<3>, wall_contact<3, double>&, component_set, encounter, int,
                       const ball<3, double>&, const plane<3, double>&);
template void complete(ball_and_wall<2>, wall_contact<2, float>&, component_set, encounter, int, const ball<2, float>&,
                       const wall<2, float>&);
template void complete(ball_and_wall<3>, wall_contact<3, float>&, component_set, encounter, int, const ball<3, float>&,
                       const wall<3, float>&);
template void complete(ball_and_wall<2>, wall_contact<2, double>&, component_set, encounter, int,
                       const ball<2, double>&, const wall<2, double>&);
template void complete(ball_and_wall<3>, wall_contact<3, double>&, component_set, encounter, int,
                       const ball<3, double>&, const wall<3, double>&);
template component_set contact_by_words(ball_and_plane<2>, wall_contact<2, float>&, encounter, int,
                                        const ball<2, float>&, const plane<2, float>&, double,
                                        const own_clock&) noexcept;
template component_set contact_by_words(ball_and_plane<3>, wall_contact<3, float>&, encounter, int,
                                        const ball<3, float>&, const plane<3, float>&, double,
                                        const own_clock&) noexcept;
template component_set contact_by_words(ball_and_plane<2>, wall_contact<2, double>&, encounter, int,
                                        const ball<2, double>&, const plane<2, double>&, double,
                                        const own_clock&) noexcept;
template component_set contact_by_words(ball_and_plane<3>, wall_contact<3, double>&, encounter, int,
                                        const ball<3, double>&, const plane<3, double>&, double,
                                        const own_clock&) noexcept;
template component_set contact_by_words(ball_and_wall<2>, wall_contact<2, float>&, encounter, int,
                                        const ball<2, float>&, const wall<2, float>&, double,
                                        const own_clock&) noexcept;
template component_set contact_by_words(ball_and_wall<3>, wall_contact<3, float>&, encounter, int,
                                        const ball<3, float>&, const wall<3, float>&, double,
                                        const own_clock&) noexcept;
template component_set contact_by_words(ball_and_wall<2>, wall_contact<2, double>&, encounter, int,
                                        const ball<2, double>&, const wall<2, double>&, double,
                                        const own_clock&) noexcept;
template component_set contact_by_words(ball_and_wall<3>, wall_contact<3, double>&, encounter, int,
                                        const ball<3, double>&, const wall<3, double>&, double,
                                        const own_clock&) noexcept;
template component_set contact_by_words(ball_and_plane<2>, wall_contact<2, float>&, encounter, int,
                                        const ball<2, float>&, const plane<2, float>&, double,
                                        const clock_of_flight<float>&) noexcept;
template component_set contact_by_words(ball_and_plane<3>, wall_contact<3, float>&, encounter, int,
                                        const ball<3, float>&, const plane<3, float>&, double,
                                        const clock_of_flight<float>&) noexcept;
template component_set contact_by_words(ball_and_plane<2>, wall_contact<2, double>&, encounter, int,
                                        const ball<2, double>&, const plane<2, double>&, double,
                                        const clock_of_flight<double>&) noexcept;
template component_set contact_by_words(ball_and_plane<3>, wall_contact<3, double>&, encounter, int,
                                        const ball<3, double>&, const plane<3, double>&, double,
                                        const clock_of_flight<double>&) noexcept;
template component_set contact_by_words(ball_and_wall<2>, wall_contact<2, float>&, encounter, int,
                                        const ball<2, float>&, const wall<2, float>&, double,
                                        const clock_of_flight<float>&) noexcept;
template component_set contact_by_words(ball_and_wall<3>, wall_contact<3, float>&, encounter, int,
                                        const ball<3, float>&, const wall<3, float>&, double,
                                        const clock_of_flight<float>&) noexcept;
template component_set contact_by_words(ball_and_wall<2>, wall_contact<2, double>&, encounter, int,
                                        const ball<2, double>&, const wall<2, double>&, double,
                                        const clock_of_flight<double>&) noexcept;
template component_set contact_by_words(ball_and_wall<3>, wall_contact<3, double>&, encounter, int,
                                        const ball<3, double>&, const wall<3, double>&, double,
                                        const clock_of_flight<double>&) noexcept;
template void complete(contact<2, float>&, component_set, encounter, const flight<2, float>&, const flight<2, float>&);
template void complete(contact<3, float>&, component_set, encounter, const flight<3, float>&, const flight<3, float>&);
template void complete(contact<2, double>&, component_set, encounter, const flight<2, double>&,
                       const flight<2, double>&);
template void complete(contact<3, double>&, component_set, encounter, const flight<3, double>&,
                       const flight<3, double>&);

} // namespace graze::inline v0_1::detail
