// In a space of periods: how far each ball has been brought back, and which image it met last.
#pragma once

#include <graze/scene/body.hpp>

#include <vector>

namespace graze::inline v0_1::detail {

// A mirror has met that image of what stands.
struct passage {
    body a, b;
    image_index image;
    bool operator==(const passage&) const = default;
};

// Images are counted from where everything would be if nothing had ever been brought back. Empty where there is no
// period; all is 0 then.
class image_ledger {
  public:
    struct entry {
        image_index last{}, gone{};
    };

    explicit image_ledger(std::size_t balls = 0) : entries_(balls) {}

    // So many periods ball a has gone back.
    [[nodiscard]] image_index gone(body a) const noexcept { return get(a).gone; }
    // So many periods are between that image of b, another ball or what stands, and b itself, as a and b fly.
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
    std::vector<entry> entries_; // of the balls; what stands has none
};

} // namespace graze::inline v0_1::detail
