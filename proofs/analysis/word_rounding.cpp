// What loose double words lose: counted at compile time, and tried on numbers that show the loss.
#include <graze/analysis/word_rounding.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/number/loose_word.hpp>

namespace {

using namespace graze;
using detail::loose_word;
using detail::word_rounding;
using word = loose_word<false>;

constexpr auto exact = word_rounding::exact_input();
constexpr auto plain = word_rounding::exact_double();

// Two doubles: sums and products are exact but for the rounding of what is zero, and low parts one unit.
static_assert((plain + plain).low == 1 && (plain * plain).low == 1);
// Low parts of one unit each: two products of a high and a low part have two roundings, and adding them up has one. The
// product of the low parts is omitted.
static_assert((exact * exact).low == 3 && (exact * exact).error == 2 * 2 + 3 + 1);
static_assert((exact + exact).low == 2 && (exact + exact).error == 3);

constexpr double u = 0x1p-53;
// (1 + u)(1 + u), with u in the low parts: u² is omitted.
constexpr word one_and_more(1.0, u);
static_assert((one_and_more * one_and_more).high == 1 && (one_and_more * one_and_more).low == 2 * u);
// If the high parts cancel, the low parts are the result.
static_assert((one_and_more - word(1)).high == 0 && (one_and_more - word(1)).low == u);
// in_order: high becomes the nearest double.
static_assert(word(1.0, 3 * u).in_order().high == 1 + 0x1p-51 && word(1.0, 3 * u).in_order().low == -u);

} // namespace
