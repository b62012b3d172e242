// Points by the cells in which they are.
#pragma once

#include <graze/scene/body.hpp>
#include <graze/scene/records.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

// A list of points for each key of a cell. A hash of the key finds it, so that an empty cell takes no memory. After
// make_room, entering and leaving neither allocate nor throw.
class cell_lists {
  public:
    void make_room(std::size_t points) {
        if (nodes_.empty()) {
            nodes_.resize(points);
            heads_.resize(std::bit_ceil(2 * points + 16), no_body);
        }
    }
    void enter(body a, std::uint64_t key) noexcept {
        body& head = heads_[place_of(key)];
        nodes_[a] = {key, head, no_body};
        if (head != no_body) {
            nodes_[head].previous = a;
        }
        head = a;
        ++size_;
    }
    void leave(body a) noexcept {
        const node& n = nodes_[a];
        (n.previous == no_body ? heads_[place_of(n.key)] : nodes_[n.previous].next) = n.next;
        if (n.next != no_body) {
            nodes_[n.next].previous = n.previous;
        }
        --size_;
    }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }

    template <class F>
    void for_each(std::uint64_t key, F f) const {
        for (body b = heads_[place_of(key)]; b != no_body; b = nodes_[b].next) {
            if (nodes_[b].key == key) {
                f(b);
            }
        }
    }

  private:
    struct node {
        std::uint64_t key = 0;
        body next = no_body, previous = no_body;
    };
    [[nodiscard]] std::size_t place_of(std::uint64_t key) const noexcept { return key & (heads_.size() - 1); }

    records<node> nodes_;
    records<body> heads_; // some of which are of several cells; a power of two
    std::size_t size_ = 0;
};

} // namespace graze::inline v0_1::detail
