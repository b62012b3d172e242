// The cold stages of decisions, and the whole of one with a flat shape, which is a call anyway: graze::compiled
// contains them, so that a unit need not compile them.
#pragma once

#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_flights.hpp>
#include <graze/predicate/classify_walls.hpp>

namespace graze::inline v0_1::detail {

extern template encounter classify_exactly(const ball<2, float>&, const ball<2, float>&, const open_number&);
extern template encounter classify_exactly(const ball<3, float>&, const ball<3, float>&, const open_number&);
extern template encounter classify_exactly(const ball<2, double>&, const ball<2, double>&, const open_number&);
extern template encounter classify_exactly(const ball<3, double>&, const ball<3, double>&, const open_number&);
extern template decided_balls classify_further(const ball<2, float>&, const ball<2, float>&);
extern template decided_balls classify_further(const ball<3, float>&, const ball<3, float>&);
extern template decided_balls classify_further(const ball<2, double>&, const ball<2, double>&);
extern template decided_balls classify_further(const ball<3, double>&, const ball<3, double>&);
extern template flat_answer decide_plane_slowly(const ball<2, float>&, const plane<2, float>&, flat_question, stage&);
extern template flat_answer decide_plane_slowly(const ball<3, float>&, const plane<3, float>&, flat_question, stage&);
extern template flat_answer decide_plane_slowly(const ball<2, double>&, const plane<2, double>&, flat_question, stage&);
extern template flat_answer decide_plane_slowly(const ball<3, double>&, const plane<3, double>&, flat_question, stage&);
extern template flat_answer decide_flat_slowly<flat_question::what>(const ball<2, float>&, const wall<2, float>&,
                                                                    stage&);
extern template flat_answer decide_flat_slowly<flat_question::what>(const ball<3, float>&, const wall<3, float>&,
                                                                    stage&);
extern template flat_answer decide_flat_slowly<flat_question::what>(const ball<2, double>&, const wall<2, double>&,
                                                                    stage&);
extern template flat_answer decide_flat_slowly<flat_question::what>(const ball<3, double>&, const wall<3, double>&,
                                                                    stage&);
extern template flat_answer decide_flat_slowly<flat_question::what>(const ball<3, float>&, const triangle<float>&,
                                                                    stage&);
extern template flat_answer decide_flat_slowly<flat_question::what>(const ball<3, double>&, const triangle<double>&,
                                                                    stage&);
extern template flat_answer decide_flat_slowly<flat_question::feature>(const ball<2, float>&, const wall<2, float>&,
                                                                       stage&);
extern template flat_answer decide_flat_slowly<flat_question::feature>(const ball<3, float>&, const wall<3, float>&,
                                                                       stage&);
extern template flat_answer decide_flat_slowly<flat_question::feature>(const ball<2, double>&, const wall<2, double>&,
                                                                       stage&);
extern template flat_answer decide_flat_slowly<flat_question::feature>(const ball<3, double>&, const wall<3, double>&,
                                                                       stage&);
extern template flat_answer decide_flat_slowly<flat_question::feature>(const ball<3, float>&, const triangle<float>&,
                                                                       stage&);
extern template flat_answer decide_flat_slowly<flat_question::feature>(const ball<3, double>&, const triangle<double>&,
                                                                       stage&);
extern template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<2, float>&, const wall<2, float>&,
                                                                         stage&);
extern template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<3, float>&, const wall<3, float>&,
                                                                         stage&);
extern template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<2, double>&, const wall<2, double>&,
                                                                         stage&);
extern template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<3, double>&, const wall<3, double>&,
                                                                         stage&);
extern template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<3, float>&, const triangle<float>&,
                                                                         stage&);
extern template flat_answer decide_flat_slowly<flat_question::clearance>(const ball<3, double>&,
                                                                         const triangle<double>&, stage&);
extern template encounter classify_exactly(const flight<2, float>&, const flight<2, float>&, const open_number&);
extern template encounter classify_exactly(const flight<3, float>&, const flight<3, float>&, const open_number&);
extern template encounter classify_exactly(const flight<2, double>&, const flight<2, double>&, const open_number&);
extern template encounter classify_exactly(const flight<3, double>&, const flight<3, double>&, const open_number&);
extern template flat_answer decide_flat<flat_question::what>(const ball<2, float>&, const wall<2, float>&, stage&);
extern template flat_answer decide_flat<flat_question::feature>(const ball<2, float>&, const wall<2, float>&, stage&);
extern template flat_answer decide_flat<flat_question::clearance>(const ball<2, float>&, const wall<2, float>&, stage&);
extern template flat_answer decide_flat<flat_question::what>(const ball<3, float>&, const wall<3, float>&, stage&);
extern template flat_answer decide_flat<flat_question::feature>(const ball<3, float>&, const wall<3, float>&, stage&);
extern template flat_answer decide_flat<flat_question::clearance>(const ball<3, float>&, const wall<3, float>&, stage&);
extern template flat_answer decide_flat<flat_question::what>(const ball<3, float>&, const triangle<float>&, stage&);
extern template flat_answer decide_flat<flat_question::feature>(const ball<3, float>&, const triangle<float>&, stage&);
extern template flat_answer decide_flat<flat_question::clearance>(const ball<3, float>&, const triangle<float>&,
                                                                  stage&);
extern template flat_answer decide_flat<flat_question::what>(const ball<2, double>&, const wall<2, double>&, stage&);
extern template flat_answer decide_flat<flat_question::feature>(const ball<2, double>&, const wall<2, double>&, stage&);
extern template flat_answer decide_flat<flat_question::clearance>(const ball<2, double>&, const wall<2, double>&,
                                                                  stage&);
extern template flat_answer decide_flat<flat_question::what>(const ball<3, double>&, const wall<3, double>&, stage&);
extern template flat_answer decide_flat<flat_question::feature>(const ball<3, double>&, const wall<3, double>&, stage&);
extern template flat_answer decide_flat<flat_question::clearance>(const ball<3, double>&, const wall<3, double>&,
                                                                  stage&);
extern template flat_answer decide_flat<flat_question::what>(const ball<3, double>&, const triangle<double>&, stage&);
extern template flat_answer decide_flat<flat_question::feature>(const ball<3, double>&, const triangle<double>&,
                                                                stage&);
extern template flat_answer decide_flat<flat_question::clearance>(const ball<3, double>&, const triangle<double>&,
                                                                  stage&);

} // namespace graze::inline v0_1::detail
