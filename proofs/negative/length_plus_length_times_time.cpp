// A formula whose degrees don't match: Eq. (12) as printed, without its parentheses, takes R² from a squared length
// times a squared velocity.
// expect: a sum of quantities of different dimensions
#include <graze/analysis/error_bound.hpp>
#include <graze/formula/discriminant.hpp>

constexpr auto length = graze::error_bound::exact_input({1, 0, 0});
constexpr auto speed = graze::error_bound::exact_input({0, 1, 0});
constexpr graze::relative_motion m{graze::bounded_vector<2>(length), graze::bounded_vector<2>(speed), length};
constexpr auto q = graze::quadratic_of(m);
#ifdef REPAIRED
constexpr auto d = q.h * q.h - q.a * (graze::squared_norm(m.dx) - m.R * m.R);
#else
constexpr auto d = q.h * q.h - (q.a * graze::squared_norm(m.dx) - m.R * m.R);
#endif
