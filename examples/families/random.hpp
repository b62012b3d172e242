// Random integers that are the same everywhere.
#pragma once

#include <cstdint>

namespace families {

// The generator splitmix64 (Steele, Lea, Flood 2014). Arguments of one call are evaluated in any order: draw at most
// one number in them.
class random {
  public:
    explicit constexpr random(std::uint64_t seed) : state_(seed) {}

    // Each index of a seed has its own stream.
    constexpr random(std::uint64_t seed, std::uint64_t index) : state_(seed) {
        const std::uint64_t mixed = next();
        state_ = mixed ^ (index * 0xd1342543de82ef95U);
        state_ = next();
    }

    constexpr std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }

    // From 0 to n - 1, n > 0. Uniform to within n/2^64.
    constexpr std::uint64_t below(std::uint64_t n) { return next() % n; }

    // From low to high, both included.
    constexpr std::int64_t in(std::int64_t low, std::int64_t high) {
        return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
    }

    // Less than 2^bits in magnitude.
    constexpr std::int64_t signed_bits(int bits) {
        const std::int64_t limit = (std::int64_t{1} << bits) - 1;
        return in(-limit, limit);
    }

    constexpr bool one_in(std::uint64_t n) { return below(n) == 0; }

    constexpr std::int64_t either_sign(std::int64_t x) { return one_in(2) ? x : -x; }

  private:
    std::uint64_t state_;
};

} // namespace families
