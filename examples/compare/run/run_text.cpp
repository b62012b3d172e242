#include "run_report.hpp"

#include "../input_error.hpp"
#include "../text_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace compare::run {

namespace {

std::string counted(std::size_t n) { return std::to_string(n) + (n == 1 ? " collision" : " collisions"); }

std::string digits_text(double digits) { return short_number(std::floor(digits * 10) / 10); }

std::string time_text(double t) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", t);
    return text;
}

// At most this many events are listed on a terminal, and the states of at most this many balls.
constexpr std::size_t most_listed = 20;

std::string heading(const run_report& r) {
    const bool nothing = r.events.empty() && r.problem.empty() && !r.interrupted;
    std::string text = printable(r.scene, 200) + ": " +
                       (!nothing                            ? counted(r.events.size())
                        : r.why == graze::ending::exhausted ? "nothing ever collides"
                                                            : "nothing collides");
    if (r.problem.empty() && !r.interrupted && r.why == graze::ending::time) {
        text += " until t = " + r.end;
    } else if (!r.events.empty()) {
        text += " until t = " + time_text(r.events.back().about);
    }
    text += r.problem.empty() && r.why == graze::ending::exhausted && !nothing ? ", and none after that" : "";
    text += ", every decision proved (" + std::to_string(r.bits) + " bits, ";
    text += r.attempts == 1 ? "1 attempt, " : std::to_string(r.attempts) + " attempts, ";
    text += short_number(r.seconds) + " s)\n";
    if (!r.problem.empty()) {
        text +=
            wrapped("The certified run ended there: " + r.problem + ". What follows holds up to that event.") + "\n";
    } else if (r.interrupted) {
        text += "Interrupted: what follows holds up to that event.\n";
    } else if (r.why == graze::ending::cascade) {
        std::string who;
        for (const graze::participant& p : r.jammed) {
            who += (who.empty() ? " among " : ", ") + to_string(p);
        }
        text +=
            wrapped("The run ended there: events follow each other without end" + who + " while time stands still.") +
            "\n";
    }
    const auto tied = static_cast<std::size_t>(
        std::count_if(r.events.begin(), r.events.end(), [](const proved_event& e) { return e.tied; }));
    if (tied > 0) {
        text += std::to_string(tied) + " of them at exactly the time of the one before";
        text += r.choices > 0 ? ", " + std::to_string(r.choices) + " where an order had to be chosen\n" : "\n";
    }
    const auto either =
        std::count_if(r.events.begin(), r.events.end(), [](const proved_event& e) { return e.either_order; });
    if (either > 0) {
        text += std::to_string(either) + " in either order with the one before: no ball takes part in both\n";
    }
    return text;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) {
        text += (text.empty() ? "(" : ", ") + part;
    }
    return text + ")";
}

std::string states_text(const run_report& r) {
    std::string text;
    if (r.distance_of) {
        text += "\nball " + std::to_string(*r.distance_of) + " is " + r.distance + " from the origin\n";
    } else if (r.states.size() <= most_listed) {
        text += "\nat t = " + r.end + ":\n";
        for (const end_state& s : r.states) {
            text += "  ball " + std::to_string(s.ball) + " is at " + joined(s.position) + ", velocity " +
                    joined(s.velocity) + "\n";
        }
    }
    if (r.digits < r.digits_wanted) {
        text +=
            "only " + std::to_string(r.digits) + " of the " + std::to_string(r.digits_wanted) + " digits are certain\n";
    }
    return text;
}

std::string events_text(const run_report& r) {
    text_table table;
    table.column("event");
    table.column("time", true);
    table.column("who", true);
    for (std::size_t i = 0; i < r.events.size(); ++i) {
        const proved_event& e = r.events[i];
        table.line({std::to_string(i + 1), e.time,
                    to_string(e.who) + (e.chosen         ? " (order chosen)"
                                        : e.tied         ? " (same time)"
                                        : e.either_order ? " (either order)"
                                                         : "")});
    }
    return "\n" + table.text();
}

std::string types_text(const run_report& r) {
    text_table table;
    table.column("type", true);
    table.column("right");
    table.column("first");
    table.column("last");
    table.column("end");
    table.span("digits", 2, 3);
    table.column("energy");
    table.column("momentum");
    table.span("drift", 5, 2);
    table.column("events/s");
    table.column("first wrong event", true);
    const auto optional = [](const std::optional<double>& x) { return x ? short_number(*x) : std::string("-"); };
    for (const judged_history& j : r.types) {
        const history& h = j.found;
        const bool any = !h.digits.empty();
        if (h.compared == comparison::none) {
            table.line({h.type, "-", "-", "-", "-", "-", "-", "-", "not run"});
            continue;
        }
        table.line({h.type, std::to_string(h.digits.size()), any ? digits_text(h.digits.front()) : "-",
                    any ? digits_text(h.digits.back()) : "-", h.end_digits ? digits_text(*h.end_digits) : "-",
                    optional(h.energy_drift), optional(h.momentum_drift),
                    h.events_per_second > 0 ? short_count(h.events_per_second) : "-",
                    j.mistake.what == mistake::none ? (h.compared == comparison::part ? "interrupted" : h.problem)
                                                    : j.mistake.text + ", at t = " + time_text(j.mistake.time)});
    }
    return "\n" + table.text();
}

} // namespace

std::string conclusion(const run_report& r) {
    if (r.events.empty()) {
        return r.problem.empty() && !r.interrupted ? "Nothing collides: there is nothing to compare."
                                                   : "No collision is proved: there is nothing to compare.";
    }
    const auto all_right = [&](const judged_history& j) {
        return j.found.compared == comparison::whole && j.mistake.what == mistake::none &&
               j.found.digits.size() == r.events.size();
    };
    const auto digits_of = [](const history& h) {
        return h.end_digits ? *h.end_digits : h.digits.empty() ? 0 : h.digits.back();
    };
    const auto plain =
        std::find_if(r.types.begin(), r.types.end(), [](const judged_history& j) { return j.found.type == "double"; });
    const auto is_enough = [&](const judged_history& j) {
        return all_right(j) && digits_of(j.found) >= r.digits_wanted;
    };
    const judged_history* best = nullptr;
    for (const judged_history& j : r.types) {
        if (is_enough(j) && (best == nullptr || j.found.events_per_second > best->found.events_per_second)) {
            best = &j;
        }
    }
    const std::string wanted = std::to_string(r.digits_wanted) + (r.digits_wanted == 1 ? " digit" : " digits");
    std::string text;
    if (std::any_of(r.types.begin(), r.types.end(),
                    [](const judged_history& j) { return j.found.compared != comparison::whole; })) {
        return "Interrupted: nothing is concluded about what was not run.";
    }
    if (plain != r.types.end()) {
        const auto digits = static_cast<long>(std::floor(digits_of(plain->found)));
        text = "double is right for " + std::string(all_right(*plain) ? "all " : "") +
               counted(plain->found.digits.size()) + ", to " + std::to_string(digits) +
               (digits == 1 ? " digit; " : " digits; ");
        if (is_enough(*plain)) {
            return text + "that is enough for the " + std::to_string(r.digits_wanted) + " wanted.";
        }
    }
    return text + (best != nullptr ? "for " + wanted + " take " + best->found.type + "."
                                   : "for " + wanted + " no type here is enough: take the certified run.");
}

std::string to_text(const run_report& r, bool with_events) {
    std::string text = heading(r) + (with_events ? events_text(r) : "") + states_text(r);
    if (!r.types.empty()) {
        text += types_text(r) + "\n" + wrapped(conclusion(r)) + "\n";
    }
    return text;
}

} // namespace compare::run
