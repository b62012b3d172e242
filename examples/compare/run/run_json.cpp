#include "run_report.hpp"

#include <nlohmann/json.hpp>

#include <limits>

namespace compare::run {

namespace {

using json = nlohmann::ordered_json;

json optional(const std::optional<double>& x) { return x ? json(*x) : json(nullptr); }

json event_of(const proved_event& e) {
    return {{"who", to_string(e.who)},
            {"time", e.time},
            {"tied", e.tied},
            {"either_order", e.either_order},
            {"chosen", e.chosen}};
}

json type_of(const judged_history& j) {
    json type = {{"type", j.found.type},
                 {"library", j.found.library},
                 {"compared", to_string(j.found.compared)},
                 {"right", j.found.digits.size()},
                 {"digits", j.found.digits},
                 {"end_digits", optional(j.found.end_digits)},
                 {"energy_drift", optional(j.found.energy_drift)},
                 {"momentum_drift", optional(j.found.momentum_drift)},
                 {"events_per_second", j.found.events_per_second},
                 {"problem", j.found.problem}};
    type["first_wrong"] = j.mistake.what == mistake::none ? json(nullptr)
                                                          : json{{"what", to_string(j.mistake.what)},
                                                                 {"event", j.mistake.at + 1},
                                                                 {"time", j.mistake.time},
                                                                 {"text", j.mistake.text}};
    json events = json::array();
    for (std::size_t i = 0; i < j.found.events.size(); ++i) {
        events.push_back({{"who", to_string(j.found.events[i])}, {"time", j.found.times[i]}});
    }
    type["events"] = std::move(events);
    return type;
}

// Whether the states at the end are rational, so that every digit is known.
bool is_exact(const run_report& r) { return r.digits == std::numeric_limits<int>::max(); }

} // namespace

std::string to_json(const run_report& r) {
    json all = {{"schema", "graze-compare run"},
                {"version", 1},
                {"command", r.command},
                {"scene", r.scene},
                {"ending", to_string(r.why)},
                {"problem", r.problem},
                {"interrupted", r.interrupted},
                {"end", r.end},
                {"choices", r.choices},
                {"bits", r.bits},
                {"attempts", r.attempts},
                {"seconds", r.seconds},
                {"digits_wanted", r.digits_wanted},
                {"digits", is_exact(r) ? json(nullptr) : json(r.digits)}};
    if (r.distance_of) {
        all["distance"] = {{"ball", *r.distance_of}, {"from_origin", r.distance}};
    }
    json jammed = json::array(), states = json::array(), events = json::array(), types = json::array();
    for (const graze::participant& p : r.jammed) {
        jammed.push_back(to_string(p));
    }
    for (const end_state& s : r.states) {
        states.push_back({{"ball", s.ball}, {"position", s.position}, {"velocity", s.velocity}});
    }
    for (const proved_event& e : r.events) {
        events.push_back(event_of(e));
    }
    for (const judged_history& j : r.types) {
        types.push_back(type_of(j));
    }
    all["jammed"] = std::move(jammed);
    all["states"] = std::move(states);
    all["events"] = std::move(events);
    all["types"] = std::move(types);
    return all.dump(1) + "\n";
}

} // namespace compare::run
