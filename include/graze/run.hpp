// run: the events of a scene, one after the other, in graze's exact mechanics or in any number type.
#pragma once

#include <graze/number/floating.hpp>
#include <graze/run/exact_mechanics.hpp>
#include <graze/run/plain_mechanics.hpp>
#include <graze/run/run.hpp>
#include <graze/scene/scene_of.hpp>

#if defined(GRAZE_COMPILED) && defined(__cpp_exceptions)
#include <graze/contact/compiled.hpp>
#include <graze/predicate/compiled.hpp>
#include <graze/run/compiled.hpp>
#include <graze/time/compiled.hpp>
#endif

namespace graze::inline v0_1 {

// Where no mechanics is named, a run is exact: graze::run run(scene).
template <int N, class T>
run(const scene<N, T>&) -> run<exact_mechanics<N, T>>;

} // namespace graze::inline v0_1
