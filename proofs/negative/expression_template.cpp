// A type whose sums are not values, but expressions that refer to their operands.
// expect: sum_is_a_value
#include <graze/number/traits.hpp>

struct expression {};
struct lazy {
    lazy(int = 0) {}
    lazy(const expression&) {}
    lazy operator-() const { return *this; }
};
#ifdef REPAIRED
lazy operator+(const lazy& x, const lazy&) { return x; }
lazy operator-(const lazy& x, const lazy&) { return x; }
#else
expression operator+(const lazy&, const lazy&) { return {}; }
expression operator-(const lazy&, const lazy&) { return {}; }
#endif
lazy operator*(const lazy& x, const lazy&) { return x; }

template <>
struct graze::number_traits<lazy> {
    static constexpr const char* name = "lazy";
    static constexpr bool is_exact = true;
    static constexpr int digits = 0;
};

template <graze::number T>
void runs_formulas() {}
void run() { runs_formulas<lazy>(); }
