// How far a decision is from the border where it changes, by the oracle.
//
// For a pair, f(t) is the square of the distance between the centre and the other thing, minus r² (for two balls, R²).
// The signs of f'(0), f(0) and of the least f ahead decide. L² is the sum of the squares of the lengths that the
// formulas start from: |Δx|² + R², |x - point|² + r² or |x - corner|² + the edges' |e|² + r². The relative distances
// are
//   receding     |f'(0)|/(2 L |Δu|), for balls |h|/(L |Δu|), for a plane the product of two sines
//   overlapping  |f(0)|/L²
//   hitting      |least f|/L²; if the centre goes through a wall, (ρ² + r²)/L², where ρ is the distance from there
//                to the wall's rim. A plane is neither missed nor grazed.
//   feature      the distance between the touched point and the point of the other feature (of its whole plane or
//                line) that is closest to the centre then, divided by L
// The first three are at most 1.
#pragma once

#include "../truth.hpp"

#include <graze/precision/subject.hpp>

namespace search {

// Squares of relative distances. They are exact, except for those of features, which are right to a relative 2^-64.
template <int N>
class borders {
  public:
    // p must be valid.
    explicit borders(const precision::pair<N>& p);

    // The distance from the pairs for which this answer would be right; if the answer is on the wrong side of several
    // borders, the farthest counts. 0 on the border; empty if the answer is right. An answer without an encounter says
    // that there is a collision if it has values, and that there is none if it has none.
    [[nodiscard]] std::optional<mpq_class> square_to(const graze::precision::answer& given) const;

    // The nearest border, including those of features if the answer names them.
    [[nodiscard]] mpq_class least_square(const graze::precision::answer& given) const;

  private:
    struct affine; // a moving point: at + t by

    [[nodiscard]] mpq_class square_to(oracle::encounter given) const;
    [[nodiscard]] std::optional<mpq_class> square_to_feature(const graze::precision::answer& given) const;
    [[nodiscard]] mpq_class square_to_feature(const oracle::piece& other) const;
    [[nodiscard]] bool tells_feature(const graze::precision::answer& given) const;
    [[nodiscard]] affine foot_on(const oracle::piece& feature) const;
    [[nodiscard]] mpq_class least_ahead() const; // f, as described under hitting

    oracle::point<N> w_, u_;
    std::vector<oracle::point<N>> edges_;
    bool is_triangle_;
    oracle::answer met_;
    oracle::encounter ahead_ = oracle::encounter::hit; // by the least f
    mpq_class length_square_;
    mpq_class receding_, overlapping_, hitting_;
};

extern template class borders<2>;
extern template class borders<3>;

// Log2 of the root of x > 0, linear between powers of two: the same on every machine.
[[nodiscard]] double bits_of_root(const mpq_class& x);
// The logarithm itself, from such bits.
[[nodiscard]] double logarithm_from(double bits);

} // namespace search
