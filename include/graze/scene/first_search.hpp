// The earliest event of all balls, found among neighbours.
#pragma once

#include <graze/scene/remaining_pairs.hpp>
#include <graze/scene/surroundings.hpp>
#include <graze/time/enclosure.hpp>

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace graze::inline v0_1::detail {

// A ball and that image of another body.
struct pair_of_bodies {
    body a, b;
    image_index image;
    [[nodiscard]] friend constexpr auto operator<=>(const pair_of_bodies&, const pair_of_bodies&) = default;
};

// All pairs of a ball and another body, the smaller number first for two balls, that may happen first of all, from t =
// 0 on, in the order of their numbers. parts: a numbered scene. bounds(pair, latest): an enclosure of the time at which
// they meet, from the largest double on if they don't or if it is certainly later than `latest`.
//
// If a ball meets another body before its shell ends, one of the two is on the other's list. So all shells that end
// before the earliest time known are renewed, at their ends, until there is none.
template <int N, class Parts, class F>
class first_search {
  public:
    first_search(const Parts& parts, F bounds)
        : parts_(parts), bounds_(bounds), balls_(parts.flights()),
          around_(balls_, 0, standing_cells<N>(parts.extents(), parts.balls()), true, parts.period()) {
        for (body a = 0; a < parts_.balls(); ++a) {
            if (around_.is_everywhere(a)) {
                offer_all(a);
            } else {
                offer_neighbours(a, a + 1);
                note_end(a, 0);
            }
        }
    }
    // Throws std::runtime_error where it cannot be known whether anything ever happens.
    [[nodiscard]] std::vector<pair_of_bodies> find() {
        while (!ends_.empty() && ends_.front().first <= latest_ && ends_.front().first < never) {
            const auto [now, a] = ends_.front();
            std::pop_heap(ends_.begin(), ends_.end(), is_later);
            ends_.pop_back();
            if (around_.is_periodic() && latest_ == never && is_over()) {
                break;
            }
            renew(a, now);
        }
        std::erase_if(found_, [&](const candidate& c) { return c.lower > latest_; });
        std::vector<pair_of_bodies> pairs;
        for (const candidate& c : found_) {
            pairs.push_back(c.who);
        }
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        return pairs;
    }

  private:
    static constexpr double never = std::numeric_limits<double>::max();
    struct candidate {
        double lower;
        pair_of_bodies who;
    };

    void offer(body a, body b, image_index image) {
        const pair_of_bodies who = b < a ? pair_of_bodies{b, a, image_index{} - image} : pair_of_bodies{a, b, image};
        const enclosure t = bounds_(who, latest_);
        if (t.lower() < never && t.lower() <= latest_) {
            found_.push_back({t.lower(), who});
            latest_ = std::min(latest_, t.upper());
        }
    }
    // Those from number `from` on.
    void offer_neighbours(body a, body from) {
        const std::span<const body> list = around_.of(a);
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (const body b = list[i]; b >= from) {
                offer(a, b, around_.is_periodic() && parts_.has_images(b) ? around_.image(a, i, b) : image_index{});
            }
        }
    }
    void offer_all(body a) {
        if (around_.is_periodic()) {
            parts_.refuse(a);
        }
        for (body b = 0; b < parts_.bodies(); ++b) {
            if (b != a) {
                offer(a, b, {});
            }
        }
    }
    void offer_remaining(body a) {
        if (!remaining_.knows(a)) {
            offer_all(a);
            return;
        }
        records<body> near;
        remaining_.list(a, is_alike, near);
        for (const body b : near) {
            offer(a, b, {});
        }
        for (body b = parts_.balls(); b < parts_.bodies(); ++b) {
            offer(a, b, {});
        }
    }
    void note_end(body a, double now) {
        const auto end = around_.end(a, balls_[a], now);
        ends_.emplace_back(end.known ? end.when : now, a);
        std::push_heap(ends_.begin(), ends_.end(), is_later);
    }
    void renew(body a, double now) {
        if (!around_.is_periodic() && !remaining_.is_known() &&
            around_.idle().has_waited(parts_.bodies() - parts_.balls()) &&
            !remaining_.find(balls_, now, around_.idle().affordable_pairs(), is_alike)) {
            around_.idle().wait_longer();
        }
        if (remaining_.is_known()) {
            around_.spread(a);
            offer_remaining(a);
        } else if (around_.look_around(a, balls_[a], now)) {
            around_.make_room(a);
            around_.settle(a);
            offer_neighbours(a, 0);
            note_end(a, now);
        } else {
            around_.spread(a);
            offer_all(a);
        }
    }
    // Whether nothing will ever happen, in a space with periods.
    [[nodiscard]] bool is_over() {
        if (around_.idle().has_idled() && parts_.bodies() == parts_.balls()) {
            const auto flies_alike = [&](const auto& b) { return b.state.velocity == balls_[0].state.velocity; };
            return std::all_of(balls_.begin(), balls_.end(), flies_alike);
        }
        if (around_.idle().is_idle()) {
            throw std::runtime_error("period: nothing has met for long, and whether anything ever will is not known");
        }
        return false;
    }

    static constexpr auto is_later = [](const auto& x, const auto& y) { return x.first > y.first; };
    static constexpr auto is_alike = [](body, body) { return true; }; // the doubles are exact

    const Parts& parts_;
    F bounds_;
    records<flight<N, double>> balls_;
    surroundings<N> around_;
    remaining_pairs<N> remaining_;
    std::vector<candidate> found_;
    double latest_ = never;
    std::vector<std::pair<double, body>> ends_; // a heap
};

} // namespace graze::inline v0_1::detail
