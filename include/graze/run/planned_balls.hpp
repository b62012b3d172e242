// What each ball of a run does next, in order.
#pragma once

#include <graze/machine/fetch.hpp>
#include <graze/run/event_calendar.hpp>
#include <graze/run/lookout.hpp>
#include <graze/scene/records.hpp>

#include <cstdint>

namespace graze::inline v0_1::detail {

// The plans of a moving scene's balls, and the calendar of when they come.
template <mechanics M>
class planned_balls : public lookout<M> {
  public:
    using lookout<M>::lookout;

  protected:
    using lookout<M>::scene_;
    using lookout<M>::surroundings_;

    void begin_to_plan() {
        calendar_ = event_calendar(scene_.balls());
        plans_.assign(scene_.balls(), {});
    }
    void set(body a, const plan& p) noexcept {
        plans_[a] = p;
        calendar_.schedule(a, p.lower);
    }
    [[nodiscard]] bool is_stale(const plan& p) const noexcept {
        return p.b < scene_.balls() && scene_.count(p.b) != p.count_b;
    }
    // To be called when the calendar may have opened a bucket. Fetches from memory, in steps of one bucket each, what
    // the events of the next buckets will read.
    void fetch_ahead() noexcept {
        if (calendar_.opened() == fetched_) {
            return;
        }
        fetched_ = calendar_.opened();
        if (scene_.balls() <= fit_into_cache) {
            return;
        }
        const auto both = [&](auto f) {
            return [this, f](body a) {
                f(a, plans_[a].is_to_leave());
                if (const body b = plans_[a].b; b < scene_.balls()) {
                    f(b, false);
                }
            };
        };
        calendar_.fetch(6);
        calendar_.for_each_in(5, [&](body a) { detail::fetch(plans_[a]); });
        calendar_.for_each_in(4, both([this](body a, bool) { this->fetch_ball(a); }));
        calendar_.for_each_in(3, both([this](body a, bool) { surroundings_.fetch_list(a); }));
        calendar_.for_each_in(2, both([this](body a, bool leaves) { this->fetch_neighbours(a, leaves); }));
        calendar_.for_each_in(1, both([this](body a, bool leaves) {
                                  if (leaves) {
                                      surroundings_.fetch_lists_around(a);
                                  }
                              }));
    }

    event_calendar calendar_;
    records<plan> plans_;

  private:
    std::uint64_t fetched_ = 0; // how many buckets had been opened
};

} // namespace graze::inline v0_1::detail
