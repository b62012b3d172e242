// Which stage of a decision gave its answer.
#pragma once

namespace graze::inline v0_1 {

// filter: floating point with a proven bound. exact: integers.
enum class stage { filter, exact };

// The observer that is told nothing: calls with it cost nothing. Any callable that takes a stage can stand in its
// place.
struct ignore_stage {
    constexpr void operator()(stage) const noexcept {}
};

} // namespace graze::inline v0_1
