// The events of one time between which a run has to choose.
#pragma once

#include <graze/run/earliest.hpp>
#include <graze/scene/records.hpp>

namespace graze::inline v0_1::detail {

// The balls, except mirrors, of the events of one time.
class balls_of_events {
  public:
    // Notes the balls of each event, and marks the events that share a ball with another one.
    template <mechanics M>
    void note(const moving_scene<M>& scene, records<timed_event<typename M::time>>& events) {
        entries_.clear();
        if (events.size() < 2) {
            return;
        }
        for (std::size_t i = 0; i < events.size(); ++i) {
            for (const body a : {events[i].what.a, events[i].what.b}) {
                if (a < scene.balls() && !scene[a].immovable) {
                    entries_.push_back({a, i});
                }
            }
        }
        std::sort(entries_.begin(), entries_.end());
        for (std::size_t i = 1; i < entries_.size(); ++i) {
            if (entries_[i - 1].first == entries_[i].first) {
                events[entries_[i - 1].second].chosen = events[entries_[i].second].chosen = true;
            }
        }
    }

    // Marks the events, from number `from` on, that share a ball with an event that one at `now` has caused, if that
    // has exactly the same time.
    template <mechanics M>
    void compare(const moving_scene<M>& scene, const records<predicted>& found, const typename M::time& now,
                 records<timed_event<typename M::time>>& events, std::size_t from) const {
        if (from >= events.size()) {
            return;
        }
        const double latest = scene.rules().bounds(now).upper;
        for (const predicted& f : found) {
            if (f.lower <= latest && (has_event(f.a, from) || has_event(f.b, from)) && is_at(scene, f, now)) {
                mark(f.a, from, events);
                mark(f.b, from, events);
            }
        }
    }

  private:
    // A ball, and the number of an event of it.
    struct entry {
        body first;
        std::size_t second;
        [[nodiscard]] friend constexpr bool operator<(const entry& x, const entry& y) noexcept {
            return x.first != y.first ? x.first < y.first : x.second < y.second;
        }
    };

    [[nodiscard]] bool has_event(body a, std::size_t from) const noexcept {
        const auto e = std::lower_bound(entries_.begin(), entries_.end(), entry{a, from});
        return e != entries_.end() && e->first == a;
    }
    template <class Events>
    void mark(body a, std::size_t from, Events& events) const noexcept {
        const auto first = std::lower_bound(entries_.begin(), entries_.end(), entry{a, from});
        for (auto e = first; e != entries_.end() && e->first == a; ++e) {
            events[e->second].chosen = true;
        }
    }
    template <mechanics M>
    [[nodiscard]] static bool is_at(const moving_scene<M>& scene, const predicted& f, const typename M::time& now) {
        try {
            return scene.rules().order(*scene.meet(f.a, f.b, f.image), now) == 0;
        } catch (graze::undecided& e) {
            e.between(scene.named(f.a, f.b));
            throw;
        }
    }

    records<entry> entries_; // sorted
};

} // namespace graze::inline v0_1::detail
