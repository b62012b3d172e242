// The pairs of a block that the lanes leave open, to be decided one by one.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

// The number of pairs decided at a time: small enough for the stack.
inline constexpr std::size_t block_size = 256;

struct open_pairs {
    std::array<std::uint64_t, block_size / 64> word{};

    // Adds the pairs from i on whose bits are set. They lie in one word.
    [[gnu::always_inline]] void add(std::size_t i, unsigned bits) noexcept {
        word[i / 64] |= static_cast<std::uint64_t>(bits) << (i % 64);
    }
    // Adds all from i to count - 1.
    void add_rest(std::size_t i, std::size_t count) noexcept {
        for (; i < count; ++i) {
            add(i, 1);
        }
    }
    // f(i) of each, in order.
    template <class F>
    void each(const F& f) const {
        for (std::size_t w = 0; w < word.size(); ++w) {
            for (std::uint64_t rest = word[w]; rest != 0; rest &= rest - 1) {
                f(64 * w + static_cast<std::size_t>(std::countr_zero(rest)));
            }
        }
    }
};

} // namespace graze::inline v0_1::detail
