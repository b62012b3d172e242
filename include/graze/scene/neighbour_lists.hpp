// The neighbours of each ball of a run: those that it may meet while it is in its shell.
#pragma once

#include <graze/machine/fetch.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/image_code.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

namespace graze::inline v0_1::detail {

// Lists of bodies, in one piece of memory. If one ball is on another's list, the other is on its list. image: which of
// a body's images it is, where there are any. After make_room, no change of lists allocates or throws.
class neighbour_lists {
  public:
    neighbour_lists() = default;
    neighbour_lists(body balls, bool with_images) : lists_(balls), with_images_(with_images) {}

    [[nodiscard]] std::span<const body> of(body a) const noexcept {
        return {bodies_.data() + lists_[a].first, lists_[a].size};
    }
    // Of each of them, where there are any.
    [[nodiscard]] std::span<const image_code> images_of(body a) const noexcept {
        return with_images_ ? std::span(images_.data() + lists_[a].first, lists_[a].size)
                            : std::span<const image_code>();
    }

    // Fetches from memory where a list is; then the list.
    void fetch_place(body a) const noexcept { detail::fetch(lists_[a]); }
    void fetch(body a) const noexcept {
        const std::span<const body> all = of(a);
        for (std::size_t i = 0; i < all.size(); i += 16) {
            fetch_line(all.data() + i);
        }
    }

    void make_room(body a, std::size_t more) {
        const list& l = lists_[a];
        if (l.size + more > l.capacity) {
            move(a, std::bit_ceil(std::max<std::size_t>(least, l.size + more)));
        }
    }
    void add(body a, body b, image_code image) noexcept {
        list& l = lists_[a];
        bodies_[l.first + l.size] = b;
        if (with_images_) {
            images_[l.first + l.size] = image;
        }
        ++l.size;
    }
    // One b from a's list, whatever its image.
    void remove(body a, body b) noexcept {
        list& l = lists_[a];
        const std::span<body> all(bodies_.data() + l.first, l.size);
        const auto i = static_cast<std::size_t>(std::find(all.begin(), all.end(), b) - all.begin());
        if (i == all.size()) {
            return;
        }
        --l.size;
        all[i] = all[l.size];
        if (with_images_) {
            images_[l.first + i] = images_[l.first + l.size];
        }
    }
    void clear(body a) noexcept { lists_[a].size = 0; }

  private:
    static constexpr std::size_t least = 8;
    struct list {
        std::size_t first = 0;
        std::uint32_t size = 0, capacity = 0;
    };

    void move(body a, std::size_t capacity) {
        records<std::size_t>& spare = spare_[static_cast<std::size_t>(std::countr_zero(capacity))];
        list& l = lists_[a];
        if (l.capacity > 0) {
            auto& left = spare_[static_cast<std::size_t>(std::countr_zero(l.capacity))];
            left.reserve(std::max(left.size() + 1, 2 * left.capacity() * (left.size() == left.capacity() ? 1 : 0)));
        }
        std::size_t first = bodies_.size();
        if (spare.empty()) {
            if (with_images_) {
                images_.resize(first + capacity);
            }
            bodies_.resize(first + capacity);
        } else {
            first = spare.back();
            spare.pop_back();
        }
        const auto copy = [&](auto& pool) {
            std::copy_n(pool.begin() + static_cast<std::ptrdiff_t>(l.first), l.size,
                        pool.begin() + static_cast<std::ptrdiff_t>(first));
        };
        copy(bodies_);
        if (with_images_) {
            copy(images_);
        }
        if (l.capacity > 0) {
            spare_[static_cast<std::size_t>(std::countr_zero(l.capacity))].push_back(l.first);
        }
        l.first = first;
        l.capacity = static_cast<std::uint32_t>(capacity);
    }

    records<list> lists_;
    records<body> bodies_;
    records<image_code> images_;
    std::array<records<std::size_t>, 33> spare_; // pieces that lists have grown out of, by their lengths' logarithm
    bool with_images_ = false;
};

} // namespace graze::inline v0_1::detail
