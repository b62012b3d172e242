// Balls whose events among themselves never end.
#pragma once

#include <graze/scene/body.hpp>
#include <graze/scene/records.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>

namespace graze::inline v0_1::detail {

// A jammed ball and the bodies that it meets, at most four: as many as a ball has that a mirror presses into the corner
// of three planes. The list may end with no_body.
using jammed_bodies = std::array<body, 5>;

// Counts, for each ball, its events in a row with no more than four others, and how far time advances meanwhile. Other
// balls do not affect this.
class jam_watch {
  public:
    jam_watch() = default;
    explicit jam_watch(body balls) : counts_(balls) {}

    // Ball a has met b at about `now`. True if `most` of its events in a row have been with the same four or fewer
    // while time has advanced by no more than 2^-26 of itself.
    [[nodiscard]] bool note(body a, body b, double now, std::uint64_t most) noexcept {
        count& c = counts_[a];
        const auto known =
            std::find_if(c.others.begin(), c.others.end(), [&](body x) { return x == b || x == no_body; });
        if (known == c.others.end()) {
            c = {others_from(b), 0, now};
        } else {
            *known = b;
        }
        if (++c.events < most) {
            return false;
        }
        const bool is_jam = now - c.since <= 0x1p-26 * (now < 0 ? -now : now);
        c.events = 0;
        c.since = now;
        return is_jam;
    }
    void set_clock_back(double by) noexcept {
        for (count& c : counts_) {
            c.since -= by;
        }
    }
    // Ball a and the bodies of its last events.
    [[nodiscard]] jammed_bodies around(body a) const noexcept {
        jammed_bodies all{a};
        std::copy(counts_[a].others.begin(), counts_[a].others.end(), all.begin() + 1);
        return all;
    }

  private:
    using others = std::array<body, std::tuple_size_v<jammed_bodies> - 1>;

    [[nodiscard]] static constexpr others others_from(body b) noexcept { return {b, no_body, no_body, no_body}; }

    struct count {
        jam_watch::others others = others_from(no_body);
        std::uint64_t events = 0;
        double since = 0;
    };
    records<count> counts_;
};

} // namespace graze::inline v0_1::detail
