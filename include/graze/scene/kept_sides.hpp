// On which side of planes and walls a point is.
#pragma once

#include <graze/scene/event_heap.hpp>

#include <array>

namespace graze::inline v0_1::detail {

// The planes and walls that a point left and beyond which the rounding of its position may have carried it, each with
// the sign of the side on which it belongs. A point touches few at once: of more than there is room for, the one that
// was met first is forgotten.
class kept_sides {
  public:
    // 0 if nothing is known of it.
    [[nodiscard]] int of(body standing) const noexcept {
        for (const entry& e : entries_) {
            if (e.standing == standing) {
                return e.side;
            }
        }
        return 0;
    }
    void keep(body standing, int side) noexcept {
        forget_if([&](body b, int) { return b == standing; });
        for (std::size_t i = entries_.size() - 1; i > 0; --i) {
            entries_[i] = entries_[i - 1];
        }
        entries_[0] = {standing, side};
    }
    // Forgets those for which f(standing, side).
    template <class F>
    void forget_if(F f) {
        std::size_t kept = 0;
        for (const entry& e : entries_) {
            if (e.standing != no_body && !f(e.standing, e.side)) {
                entries_[kept++] = e;
            }
        }
        while (kept < entries_.size()) {
            entries_[kept++] = entry{};
        }
    }

  private:
    struct entry {
        body standing = no_body;
        int side = 0;
    };
    std::array<entry, 6> entries_{};
};

} // namespace graze::inline v0_1::detail
