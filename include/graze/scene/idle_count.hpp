// For how long nothing has happened to many balls.
#pragma once

#include <algorithm>
#include <cstddef>

namespace graze::inline v0_1::detail {

// In shells that have been left since the last event.
class idle_count {
  public:
    idle_count() = default;
    explicit idle_count(std::size_t balls) : balls_(balls) {}

    void note_shell() noexcept { ++shells_; }
    void note_event() noexcept {
        shells_ = 0;
        wait_ = 0;
    }
    // Whether nothing has happened for long, true from time to time; and for very long.
    [[nodiscard]] bool has_idled() const noexcept { return shells_ % patience() == patience() - 1; }
    [[nodiscard]] bool is_idle() const noexcept { return shells_ > 100'000 + 1000 * balls_; }

    // Whether each ball has left some shells, so that no event may follow; again when `wait_longer` has been called and
    // as many more have been left. By then each ball can look at so many planes and walls, and at so many pairs in all,
    // for less than the shells have cost.
    [[nodiscard]] bool has_waited(std::size_t standing) const noexcept {
        return shells_ >= std::max({wait_, 4 * balls_ + 32, balls_ * standing / 8});
    }
    void wait_longer() noexcept { wait_ = 2 * shells_; }
    [[nodiscard]] std::size_t affordable_pairs() const noexcept { return 8 * shells_; }

  private:
    // Some dozens of each ball.
    [[nodiscard]] std::size_t patience() const noexcept { return 32 * balls_ + 256; }

    std::size_t balls_ = 0;
    std::size_t shells_ = 0;
    std::size_t wait_ = 0;
};

} // namespace graze::inline v0_1::detail
