// Runs on straight tracks in rational numbers, with a look at all pairs at every step. Balls that meet head-on have
// rational states, and every step can be checked by hand.
#pragma once

#include <graze/scene/scene_pair.hpp>

#include <gmpxx.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

namespace line_oracle {

using rational = mpq_class;

// A ball on the track y = track, which runs along x.
struct bead {
    rational x, v;
    int track;
    rational radius, mass;
};

struct event {
    graze::scene_pair who;
    rational time;
    bool chosen;
};

// Beads between the planes x = 0 and x = length, in the order of the scene's lists. Plane 0 is x = 0.
class tracks {
  public:
    tracks(std::vector<bead> beads, rational length) : beads_(std::move(beads)), length_(std::move(length)) {
        for (std::size_t i = 0; i < beads_.size(); ++i) {
            order_.push_back(static_cast<int>(i));
        }
        const auto key = [&](int i) {
            const bead& b = at(i);
            return std::tuple(b.x, rational(b.track), b.v, b.radius, b.mass);
        };
        std::sort(order_.begin(), order_.end(), [&](int i, int j) { return key(i) < key(j); });
    }

    // The first `count` events.
    [[nodiscard]] std::vector<event> run(std::size_t count) {
        std::vector<event> told;
        while (told.size() < count) {
            std::vector<event> batch = first();
            if (batch.empty()) {
                break;
            }
            std::vector<bool> moved(beads_.size());
            for (event& e : batch) {
                const bool two = e.who.with == graze::partner::ball;
                if (moved[index(e.who.a)] || (two && moved[index(e.who.b)])) {
                    continue;
                }
                for (const event& present : first()) { // includes what has arisen since the batch was found
                    e.chosen = e.chosen || (present.who == e.who && present.chosen);
                }
                moved[index(e.who.a)] = true;
                if (two) {
                    moved[index(e.who.b)] = true;
                }
                resolve(e);
                told.push_back(e);
            }
        }
        told.resize(std::min(told.size(), count));
        return told;
    }
    // Everything that happens at the earliest time, in the order of the balls' numbers, then the planes'.
    [[nodiscard]] std::vector<event> first() const {
        std::vector<event> all;
        for (std::size_t i = 0; i < order_.size(); ++i) {
            const int a = order_[i];
            for (std::size_t j = i + 1; j < order_.size(); ++j) {
                const int b = order_[j];
                if (at(a).track == at(b).track) {
                    const bool a_left = at(a).x < at(b).x;
                    const bead& left = a_left ? at(a) : at(b);
                    const bead& right = a_left ? at(b) : at(a);
                    if (left.v > right.v) {
                        const rational gap = right.x - left.x - left.radius - right.radius;
                        all.push_back({{graze::partner::ball, a, b}, now_ + gap / (left.v - right.v), false});
                    }
                }
            }
            if (at(a).v < 0) {
                all.push_back({{graze::partner::plane, a, 0}, now_ + (at(a).x - at(a).radius) / -at(a).v, false});
            }
            if (at(a).v > 0) {
                all.push_back(
                    {{graze::partner::plane, a, 1}, now_ + (length_ - at(a).x - at(a).radius) / at(a).v, false});
            }
        }
        if (all.empty()) {
            return all;
        }
        const rational earliest = std::min_element(all.begin(), all.end(), [](const event& x, const event& y) {
                                      return x.time < y.time;
                                  })->time;
        std::erase_if(all, [&](const event& e) { return e.time != earliest; });
        std::vector<int> times(beads_.size());
        const auto each = [&](const event& e, auto f) {
            f(index(e.who.a));
            if (e.who.with == graze::partner::ball) {
                f(index(e.who.b));
            }
        };
        for (const event& e : all) {
            each(e, [&](std::size_t i) { ++times[i]; });
        }
        for (event& e : all) {
            each(e, [&](std::size_t i) { e.chosen = e.chosen || times[i] > 1; });
        }
        return all;
    }

  private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] bead& at(int i) { return beads_[index(i)]; }
    [[nodiscard]] const bead& at(int i) const { return beads_[index(i)]; }

    void resolve(const event& e) {
        for (bead& b : beads_) {
            b.x += b.v * (e.time - now_);
        }
        now_ = e.time;
        bead& a = at(e.who.a);
        if (e.who.with == graze::partner::plane) {
            a.v = -a.v;
            return;
        }
        bead& b = at(e.who.b);
        const rational common = (a.mass * a.v + b.mass * b.v) / (a.mass + b.mass); // the velocity of the centre of mass
        a.v = 2 * common - a.v;
        b.v = 2 * common - b.v;
    }

    std::vector<bead> beads_;
    std::vector<int> order_;
    rational length_;
    rational now_ = 0;
};

} // namespace line_oracle
