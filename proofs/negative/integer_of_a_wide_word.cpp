// A 64-bit word that may not fit into 40 bits.
// expect: (conver|viable).*(int64_t|long|integer<40>)
#include <graze/exact/integer.hpp>

constexpr std::int64_t word = 1;
#ifdef REPAIRED
constexpr graze::integer<64> x = word;
#else
constexpr graze::integer<40> x = word;
#endif
