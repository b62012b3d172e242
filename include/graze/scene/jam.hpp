// Balls whose events among themselves never end.
#pragma once

#include <graze/scene/body.hpp>

#include <array>
#include <vector>

namespace graze::inline v0_1::detail {

// Counts, for each ball, its events in a row with no more than two others, and how far time has come meanwhile. Where a
// jam is depends on nobody else.
class jam_watch {
  public:
    jam_watch() = default;
    explicit jam_watch(body balls) : counts_(balls) {}

    // Ball a has met b at about that time. True if so many of its events, `most`, have been with the same two or fewer
    // while time has advanced by no more than 2^-26 of itself.
    [[nodiscard]] bool note(body a, body b, double now, std::uint64_t most) noexcept {
        count& c = counts_[a];
        if (b != c.others[0] && b != c.others[1]) {
            if (c.others[1] == no_body && c.others[0] != no_body) {
                c.others[1] = b;
            } else {
                c = {{b, no_body}, 0, now};
            }
        }
        if (++c.events < most) {
            return false;
        }
        const bool is_jam = now - c.since <= 0x1p-26 * (now < 0 ? -now : now);
        c.events = 0;
        c.since = now;
        return is_jam;
    }
    // Those among whom ball a's last events were.
    [[nodiscard]] std::array<body, 3> around(body a) const noexcept {
        return {a, counts_[a].others[0], counts_[a].others[1]};
    }

  private:
    struct count {
        std::array<body, 2> others{no_body, no_body};
        std::uint64_t events = 0;
        double since = 0;
    };
    std::vector<count> counts_;
};

} // namespace graze::inline v0_1::detail
