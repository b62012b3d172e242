// A run's limits, the events that its observer is told, and its outcome.
#pragma once

#include <graze/scene/mechanics.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace graze::inline v0_1 {

// How far to go: up to a time, its own events included, or a number of events, whichever is first; without either,
// until nothing more happens. cascade: that many events in a row, none of which is certainly later than the first, end
// the run as a cascade without end; 0 stands for 1000 and a hundred more for each ball. jam: that many events in a row
// of one ball with the same four others or fewer, while time advances by no more than 2^-26 of itself, are a jam, which
// ends the run as a cascade too; 0 stands for 10,000. stop_jams: instead, jammed balls, except mirrors, stop where they
// are, and the others go on until something meets one that has stopped.
template <class T>
struct run_limits {
    std::optional<T> time{};
    std::uint64_t events = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t cascade = 0;
    std::uint64_t jam = 0;
    bool stop_jams = false;
};

// Whether balls are examined with their neighbours in shells, or with every other ball. The sequence of events does not
// depend on it. [surroundings.hpp]
enum class cells { where_useful, none };

// time: every event up to the time asked for has been done. events: that many have been done. exhausted: nothing more
// will ever happen, so no event reaches a later time or a larger number. stopped: the observer returned false. cascade:
// events follow each other without end while time stands still, or almost. idle: in a scene that has a period, nothing
// has happened while balls left a thousand shells for each ball and a hundred thousand more, and it is not known
// whether anything will; advance goes on looking.
enum class ending { time, events, exhausted, stopped, cascade, idle };

[[nodiscard]] constexpr const char* to_string(ending e) noexcept {
    switch (e) {
    case ending::time:
        return "time";
    case ending::events:
        return "events";
    case ending::exhausted:
        return "exhausted";
    case ending::stopped:
        return "stopped";
    case ending::cascade:
        return "cascade";
    case ending::idle:
        return "idle";
    }
    return "unknown";
}

// events: done in this call. choices: how many of them shared a ball with another event of exactly the same time, so
// that an order had to be chosen; it depends on the scene's numbers alone. The other event was predicted as well when
// the first of that time was taken, or one of that time has caused it since. jammed: for a cascade, the ball whose
// event would have been next and the bodies of its last events; before them, all that have been stopped in this call.
// Each is named once.
struct outcome {
    ending why;
    std::uint64_t events = 0;
    std::uint64_t choices = 0;
    std::vector<participant> jammed{};
};

// An event that has been done. who: by the scene's indices. when: its time. before_a, after_a: ball a's states;
// before_b, after_b: ball b's, or nullptr for a plane or a wall. chosen: it is one of outcome::choices.
// References are valid until the observer returns.
template <mechanics M>
struct run_event {
    scene_pair who;
    const typename M::time& when;
    const typename M::state& before_a;
    const typename M::state& after_a;
    const typename M::state* before_b;
    const typename M::state* after_b;
    bool chosen;
};

// The observer that ignores all events.
struct ignore_event {
    template <class E>
    constexpr void operator()(const E&) const noexcept {}
};

} // namespace graze::inline v0_1
