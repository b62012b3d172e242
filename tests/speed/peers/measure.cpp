#include "measure.hpp"

#include "../../oracle/encounter.hpp"
#include "../../oracle/rounding.hpp"

#include <statistics.hpp>
#include <stopwatch.hpp>

#include <map>

namespace peers {

namespace {

// Whether and when the ball first touches the thing: at the first of its walls.
template <int N>
std::optional<oracle::surd> truth_of(const scene<N>& s) {
    if (s.walls.empty()) {
        return oracle::meet(s.a, s.b).time;
    }
    std::optional<oracle::surd> first;
    for (const auto& w : s.walls) {
        const auto time = oracle::meet(s.a, w).time;
        if (time && (!first || oracle::compare(*time, *first) < 0)) {
            first = time;
        }
    }
    return first;
}

std::vector<std::optional<oracle::surd>> truths_of(const trial& t) {
    std::vector<std::optional<oracle::surd>> truths;
    std::visit(
        [&](const auto& exactly) {
            for (const auto& s : exactly.all) {
                truths.push_back(truth_of(s));
            }
        },
        t.exactly);
    return truths;
}

// The errors of times, relative and in units of the last place.
class time_errors {
  public:
    // Returns the error in units of the last place, if there is one.
    std::optional<double> add(const oracle::surd& truth, double given) {
        const bool rounded = oracle::is_rounded(truth, given);
        if (oracle::sign_of(truth) == 0) {
            return units_.add(compare::wide_of(given), 0, rounded);
        }
        const mpq_class exact = oracle::approximate(truth, 200);
        const mpq_class off = rounded && oracle::compare(truth, mpq_class(given)) == 0
                                  ? mpq_class(0)
                                  : mpq_class(abs(mpq_class(given) - exact));
        relative_.push_back(mpq_class(off / exact).get_d());
        const compare::wide size = compare::wide_of(exact.get_d()); // rounded down, in the same binade
        return units_.add(compare::wide_of(relative_.back()) * size, size, rounded);
    }
    void finish(score& s, bool planar_balls) {
        if (!relative_.empty()) {
            s.median = compare::median(relative_);
            s.largest = relative_.back();
        }
        s.row.error(planar_balls ? compare::quantity::time : compare::quantity::crossing) = units_.summary();
    }

  private:
    std::vector<double> relative_;
    compare::error_sample units_;
};

// The questions of one hardness.
struct cell_of_errors {
    std::size_t evaluated = 0, wrong = 0;
    std::vector<double> units;
};

std::vector<compare::cell> cells_of(std::map<int, cell_of_errors>& found) {
    std::vector<compare::cell> cells;
    for (auto& [k, c] : found) {
        compare::cell one;
        one.kind = "ball_ball";
        one.hardness = k;
        one.evaluated = c.evaluated;
        one.wrong = c.wrong;
        if (!c.units.empty()) {
            one.time_median = compare::median(c.units);
            one.time_largest = c.units.back();
        }
        cells.push_back(one);
    }
    return cells;
}

score score_of(const trial& t, const contestant& c, const std::vector<std::optional<oracle::surd>>& truths) {
    score s;
    time_errors errors;
    std::map<int, cell_of_errors> cells;
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const std::optional<double> given = c.answer(i);
        ++s.asked;
        s.touch += truths[i] ? 1U : 0U;
        s.missed += truths[i] && !given ? 1U : 0U;
        s.invented += !truths[i] && given ? 1U : 0U;
        const auto units = truths[i] && given ? errors.add(*truths[i], *given) : std::nullopt;
        if (!t.hardness.empty()) {
            cell_of_errors& here = cells[t.hardness[i]];
            ++here.evaluated;
            here.wrong += truths[i].has_value() == given.has_value() ? 0U : 1U;
            if (units) {
                here.units.push_back(*units);
            }
        }
    }
    s.row.cells = cells_of(cells);
    errors.finish(s, t.what == thing::ball);
    s.row.group = t.name;
    s.row.decisions.evaluated = s.asked;
    s.row.decisions.hit_or_miss = s.missed + s.invented;
    return s;
}

} // namespace

std::vector<std::optional<score>> measure(const trial& t, const std::vector<entry>& entries, double timing) {
    const auto truths = truths_of(t);
    std::vector<std::optional<score>> scores;
    std::vector<std::unique_ptr<contestant>> contestants;
    std::vector<compare::timed_candidate> timed;
    for (const entry& e : entries) {
        if ((t.in_space() && !e.in_space) || (t.what != thing::ball && !e.boxes)) {
            scores.emplace_back();
            continue;
        }
        contestants.push_back(e.prepare(t));
        scores.push_back(score_of(t, *contestants.back(), truths));
        scores.back()->row.type = e.name;
        scores.back()->row.variant = e.variant;
        scores.back()->row.root = e.root;
        const contestant& c = *contestants.back();
        timed.push_back({[&c](std::size_t n) {
                             for (std::size_t i = 0; i < n; ++i) {
                                 static_cast<void>(c.answer(i)); // virtual, in another file: not optimised away
                             }
                         },
                         truths.size()});
    }
    if (timing > 0) {
        const auto times = compare::time_interleaved(timed, timing);
        std::size_t next = 0;
        for (auto& s : scores) {
            if (s) {
                const compare::timing& taken = times[next++];
                s->nanoseconds = taken.low; // other work on the machine makes repeats slower, never faster
                s->row.nanoseconds = taken.low;
                s->row.nanoseconds_low = taken.low;
                s->row.nanoseconds_high = taken.high;
                s->row.timed_pairs = taken.pairs;
                s->row.repeats = taken.repeated.size();
                s->row.repeated = taken.repeated;
            }
        }
    }
    return scores;
}

} // namespace peers
