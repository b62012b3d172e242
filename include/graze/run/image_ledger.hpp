// In a space with periods: how far each ball has been brought back, and which image it met last.
#pragma once

#include <graze/scene/body.hpp>
#include <graze/scene/records.hpp>

namespace graze::inline v0_1::detail {

// A mirror, a, has met that image of a plane or wall, b.
struct passage {
    body a, b;
    image_index image;
    bool operator==(const passage&) const = default;
};

// Images are counted from where everything would be if nothing had ever been brought back. Empty in a scene without
// periods, where all counts are 0.
class image_ledger {
  public:
    struct entry {
        image_index last{}, gone{};
    };

    explicit image_ledger(std::size_t balls = 0) : entries_(balls) {}

    // How many periods ball a has gone back.
    [[nodiscard]] image_index gone(body a) const noexcept {
        return a < entries_.size() ? entries_[a].gone : image_index{};
    }
    // How many periods there are between that image of b, a ball, plane or wall, and b itself, as a and b fly.
    [[nodiscard, gnu::always_inline]] image_index periods(body a, body b, image_index image) const noexcept {
        if (entries_.empty()) [[likely]] {
            return {};
        }
        return image - entries_[a].gone + (b < entries_.size() ? entries_[b].gone : image_index{});
    }
    [[nodiscard]] image_index last(body a) const noexcept { return get(a).last; }

    void bring_back(body a, image_index periods) noexcept {
        if (a < entries_.size()) {
            entries_[a].gone = entries_[a].gone + periods;
        }
    }
    void meet(body a, image_index image) noexcept {
        if (a < entries_.size()) {
            entries_[a].last = image;
        }
    }
    [[nodiscard]] entry get(body a) const noexcept { return a < entries_.size() ? entries_[a] : entry{}; }
    void set(body a, const entry& e) noexcept {
        if (a < entries_.size()) {
            entries_[a] = e;
        }
    }

  private:
    records<entry> entries_; // of the balls alone
};

} // namespace graze::inline v0_1::detail
