// Which stage of a decision gave its answer.
#pragma once

namespace graze::inline v0_1 {

// The stages of an answer, each wider than the one before. filter: doubles with a bound that is the same for all
// motions of one size. refined: doubles in the form that cancels least, with a bound from the terms of the sums.
// double_word: sums of two doubles with a running error. exact: integers.
#if defined(__GNUC__) && !defined(__clang__) // which takes an enumerator for a shadow of the class double_word
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#endif
enum class stage { filter, refined, double_word, exact };
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

// The wider of two.
[[nodiscard]] constexpr stage wider(stage x, stage y) noexcept { return x < y ? y : x; }

// The observer that ignores the stage: calls with it cost nothing. Any callable that takes a stage can take its place;
// it is told once a call, the widest stage that any sign or component of the answer needed.
struct ignore_stage {
    constexpr void operator()(stage) const noexcept {}
};

} // namespace graze::inline v0_1
