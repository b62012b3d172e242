// The sides of planes and walls on which a point is.
#pragma once

#include <graze/scene/body.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>

namespace graze::inline v0_1::detail {

// The planes and walls that a point left and beyond which the rounding of its position may have carried it, each with
// the sign of the side on which it belongs.
class kept_sides {
  public:
    // 0 if nothing is known of it.
    [[nodiscard]] int of(const standing_image& standing) const noexcept {
        const auto e = std::find_if(entries_.begin(), entries_.end(), is_of{standing});
        return e != entries_.end() ? e->side : 0;
    }
    void keep(const standing_image& standing, int side) {
        forget(standing);
        if (side != 0) {
            entries_.push_back({standing, side});
        }
    }
    void forget(const standing_image& standing) noexcept {
        entries_.erase(std::remove_if(entries_.begin(), entries_.end(), is_of{standing}), entries_.end());
    }
    void clear() noexcept { entries_.clear(); }
    // From now on, images are counted from that one.
    void count_from(image_index first) noexcept {
        for (entry& e : entries_) {
            e.standing.image = e.standing.image - first;
        }
    }

    // f(standing, side) of each.
    template <class F>
    void for_each(F f) const {
        for (const entry& e : entries_) {
            f(e.standing, e.side);
        }
    }
    // Forgets those of which keeps(standing, side) is false.
    template <class F>
    void keep_if(F keeps) {
        entries_.erase(std::remove_if(entries_.begin(), entries_.end(),
                                      [&](const entry& e) { return !keeps(e.standing, e.side); }),
                       entries_.end());
    }

  private:
    struct entry {
        standing_image standing;
        int side;
    };
    struct is_of {
        standing_image standing;
        [[nodiscard]] bool operator()(const entry& e) const noexcept { return e.standing == standing; }
    };
    records<entry> entries_;
};

} // namespace graze::inline v0_1::detail
