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
    [[nodiscard]] std::size_t count() const noexcept {
        std::size_t sum = 0;
        for (const std::uint64_t w : word) {
            sum += static_cast<std::size_t>(std::popcount(w));
        }
        return sum;
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

// Where lanes cost a fifth of a pair's decision, they lose time on blocks of which they leave most pairs open. After
// such a block seven are asked one by one.
class lane_pause {
  public:
    [[nodiscard]] bool is_over() noexcept {
        if (blocks_ == 0) {
            return true;
        }
        --blocks_;
        return false;
    }
    void note(const open_pairs& left, std::size_t count) noexcept { blocks_ = 4 * left.count() > 3 * count ? 7 : 0; }

  private:
    int blocks_ = 0;
};

} // namespace graze::inline v0_1::detail
