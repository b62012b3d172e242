// An integer that would lose bits.
// expect: integer<50>.*integer<40>
#include <graze/exact/integer.hpp>

constexpr graze::integer<50> wide = std::int32_t{1};
#ifdef REPAIRED
constexpr graze::integer<50> same = wide;
#else
constexpr graze::integer<40> narrow = wide;
#endif
