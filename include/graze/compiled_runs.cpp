// The runs of graze::compiled, in exact mechanics and in doubles. Their decisions, times and contacts are in
// compiled.cpp.
#include <graze/contact/compiled.hpp>
#include <graze/predicate/compiled.hpp>
#include <graze/run.hpp>
#include <graze/time/compiled.hpp>

namespace graze::inline v0_1 {

template class run<exact_mechanics<2, double>>;
template class run<exact_mechanics<3, double>>;
template class run<plain_mechanics<2, double>>;
template class run<plain_mechanics<3, double>>;

} // namespace graze::inline v0_1
