// The cold stages of contacts: graze::compiled contains them, so that a unit need not compile them.
#pragma once

#include <graze/contact/collide_balls.hpp>
#include <graze/contact/collide_flights.hpp>
#include <graze/contact/collide_walls.hpp>

namespace graze::inline v0_1::detail {

extern template component_set contact_in_doubles(contact<2, float>&, encounter, const ball<2, float>&,
                                                 const ball<2, float>&, double, double, double) noexcept;
extern template component_set contact_in_doubles(contact<2, float>&, encounter, const flight<2, float>&,
                                                 const flight<2, float>&, double, double, double) noexcept;
extern template component_set contact_in_doubles(contact<3, float>&, encounter, const ball<3, float>&,
                                                 const ball<3, float>&, double, double, double) noexcept;
extern template component_set contact_in_doubles(contact<3, float>&, encounter, const flight<3, float>&,
                                                 const flight<3, float>&, double, double, double) noexcept;
extern template component_set contact_in_doubles(contact<2, double>&, encounter, const ball<2, double>&,
                                                 const ball<2, double>&, double, double, double) noexcept;
extern template component_set contact_in_doubles(contact<2, double>&, encounter, const flight<2, double>&,
                                                 const flight<2, double>&, double, double, double) noexcept;
extern template component_set contact_in_doubles(contact<3, double>&, encounter, const ball<3, double>&,
                                                 const ball<3, double>&, double, double, double) noexcept;
extern template component_set contact_in_doubles(contact<3, double>&, encounter, const flight<3, double>&,
                                                 const flight<3, double>&, double, double, double) noexcept;
extern template void complete(contact<2, float>&, component_set, encounter, const ball<2, float>&,
                              const ball<2, float>&);
extern template void complete(contact<3, float>&, component_set, encounter, const ball<3, float>&,
                              const ball<3, float>&);
extern template void complete(contact<2, double>&, component_set, encounter, const ball<2, double>&,
                              const ball<2, double>&);
extern template void complete(contact<3, double>&, component_set, encounter, const ball<3, double>&,
                              const ball<3, double>&);
extern template optional_contact<ball<2, float>> collide_further(const ball<2, float>&, const ball<2, float>&, stage&);
extern template optional_contact<flight<2, float>> collide_further(const flight<2, float>&, const flight<2, float>&,
                                                                   stage&);
extern template optional_contact<ball<3, float>> collide_further(const ball<3, float>&, const ball<3, float>&, stage&);
extern template optional_contact<flight<3, float>> collide_further(const flight<3, float>&, const flight<3, float>&,
                                                                   stage&);
extern template optional_contact<ball<2, double>> collide_further(const ball<2, double>&, const ball<2, double>&,
                                                                  stage&);
extern template optional_contact<flight<2, double>> collide_further(const flight<2, double>&, const flight<2, double>&,
                                                                    stage&);
extern template optional_contact<ball<3, double>> collide_further(const ball<3, double>&, const ball<3, double>&,
                                                                  stage&);
extern template optional_contact<flight<3, double>> collide_further(const flight<3, double>&, const flight<3, double>&,
                                                                    stage&);
extern template stage complete_further(contact<2, float>&, component_set, encounter, const ball<2, float>&,
                                       const ball<2, float>&);
extern template stage complete_further(contact<2, float>&, component_set, encounter, const flight<2, float>&,
                                       const flight<2, float>&);
extern template stage complete_further(contact<3, float>&, component_set, encounter, const ball<3, float>&,
                                       const ball<3, float>&);
extern template stage complete_further(contact<3, float>&, component_set, encounter, const flight<3, float>&,
                                       const flight<3, float>&);
extern template stage complete_further(contact<2, double>&, component_set, encounter, const ball<2, double>&,
                                       const ball<2, double>&);
extern template stage complete_further(contact<2, double>&, component_set, encounter, const flight<2, double>&,
                                       const flight<2, double>&);
extern template stage complete_further(contact<3, double>&, component_set, encounter, const ball<3, double>&,
                                       const ball<3, double>&);
extern template stage complete_further(contact<3, double>&, component_set, encounter, const flight<3, double>&,
                                       const flight<3, double>&);
extern template void complete(ball_and_plane<2>, wall_contact<2, float>&, component_set, encounter, int,
                              const ball<2, float>&, const plane<2, float>&);
extern template void complete(ball_and_plane<3>, wall_contact<3, float>&, component_set, encounter, int,
                              const ball<3, float>&, const plane<3, float>&);
extern template void complete(ball_and_plane<2>, wall_contact<2, double>&, component_set, encounter, int,
                              const ball<2, double>&, const plane<2, double>&);
extern template void complete(ball_and_plane<3>, wall_contact<3, double>&, component_set, encounter, int,
                              const ball<3, double>&, const plane<3, double>&);
extern template void complete(ball_and_wall<2>, wall_contact<2, float>&, component_set, encounter, int,
                              const ball<2, float>&, const wall<2, float>&);
extern template void complete(ball_and_wall<3>, wall_contact<3, float>&, component_set, encounter, int,
                              const ball<3, float>&, const wall<3, float>&);
extern template void complete(ball_and_wall<2>, wall_contact<2, double>&, component_set, encounter, int,
                              const ball<2, double>&, const wall<2, double>&);
extern template void complete(ball_and_wall<3>, wall_contact<3, double>&, component_set, encounter, int,
                              const ball<3, double>&, const wall<3, double>&);
extern template component_set contact_by_words(ball_and_plane<2>, wall_contact<2, float>&, encounter, int,
                                               const ball<2, float>&, const plane<2, float>&, double,
                                               const own_clock&) noexcept;
extern template component_set contact_by_words(ball_and_plane<3>, wall_contact<3, float>&, encounter, int,
                                               const ball<3, float>&, const plane<3, float>&, double,
                                               const own_clock&) noexcept;
extern template component_set contact_by_words(ball_and_plane<2>, wall_contact<2, double>&, encounter, int,
                                               const ball<2, double>&, const plane<2, double>&, double,
                                               const own_clock&) noexcept;
extern template component_set contact_by_words(ball_and_plane<3>, wall_contact<3, double>&, encounter, int,
                                               const ball<3, double>&, const plane<3, double>&, double,
                                               const own_clock&) noexcept;
extern template component_set contact_by_words(ball_and_wall<2>, wall_contact<2, float>&, encounter, int,
                                               const ball<2, float>&, const wall<2, float>&, double,
                                               const own_clock&) noexcept;
extern template component_set contact_by_words(ball_and_wall<3>, wall_contact<3, float>&, encounter, int,
                                               const ball<3, float>&, const wall<3, float>&, double,
                                               const own_clock&) noexcept;
extern template component_set contact_by_words(ball_and_wall<2>, wall_contact<2, double>&, encounter, int,
                                               const ball<2, double>&, const wall<2, double>&, double,
                                               const own_clock&) noexcept;
extern template component_set contact_by_words(ball_and_wall<3>, wall_contact<3, double>&, encounter, int,
                                               const ball<3, double>&, const wall<3, double>&, double,
                                               const own_clock&) noexcept;
extern template component_set contact_by_words(ball_and_plane<2>, wall_contact<2, float>&, encounter, int,
                                               const ball<2, float>&, const plane<2, float>&, double,
                                               const clock_of_flight<float>&) noexcept;
extern template component_set contact_by_words(ball_and_plane<3>, wall_contact<3, float>&, encounter, int,
                                               const ball<3, float>&, const plane<3, float>&, double,
                                               const clock_of_flight<float>&) noexcept;
extern template component_set contact_by_words(ball_and_plane<2>, wall_contact<2, double>&, encounter, int,
                                               const ball<2, double>&, const plane<2, double>&, double,
                                               const clock_of_flight<double>&) noexcept;
extern template component_set contact_by_words(ball_and_plane<3>, wall_contact<3, double>&, encounter, int,
                                               const ball<3, double>&, const plane<3, double>&, double,
                                               const clock_of_flight<double>&) noexcept;
extern template component_set contact_by_words(ball_and_wall<2>, wall_contact<2, float>&, encounter, int,
                                               const ball<2, float>&, const wall<2, float>&, double,
                                               const clock_of_flight<float>&) noexcept;
extern template component_set contact_by_words(ball_and_wall<3>, wall_contact<3, float>&, encounter, int,
                                               const ball<3, float>&, const wall<3, float>&, double,
                                               const clock_of_flight<float>&) noexcept;
extern template component_set contact_by_words(ball_and_wall<2>, wall_contact<2, double>&, encounter, int,
                                               const ball<2, double>&, const wall<2, double>&, double,
                                               const clock_of_flight<double>&) noexcept;
extern template component_set contact_by_words(ball_and_wall<3>, wall_contact<3, double>&, encounter, int,
                                               const ball<3, double>&, const wall<3, double>&, double,
                                               const clock_of_flight<double>&) noexcept;
extern template void complete(contact<2, float>&, component_set, encounter, const flight<2, float>&,
                              const flight<2, float>&);
extern template void complete(contact<3, float>&, component_set, encounter, const flight<3, float>&,
                              const flight<3, float>&);
extern template void complete(contact<2, double>&, component_set, encounter, const flight<2, double>&,
                              const flight<2, double>&);
extern template void complete(contact<3, double>&, component_set, encounter, const flight<3, double>&,
                              const flight<3, double>&);

} // namespace graze::inline v0_1::detail
