#include "measurable.hpp"

#include "stopwatch.hpp"

#include <algorithm>
#include <limits>

namespace compare {

const char* to_string(graze::variant v) noexcept {
    switch (v) {
    case graze::variant::textbook:
        return "textbook";
    case graze::variant::halved:
        return "halved";
    case graze::variant::kahan:
        return "kahan";
    case graze::variant::lagrange:
        return "lagrange";
    }
    return "unknown";
}

const char* to_string(graze::root_form f) noexcept { return f == graze::root_form::printed ? "printed" : "stable"; }

std::vector<method> all_methods() {
    std::vector<method> methods;
    for (const auto v :
         {graze::variant::textbook, graze::variant::halved, graze::variant::kahan, graze::variant::lagrange}) {
        for (const auto f : {graze::root_form::printed, graze::root_form::stable}) {
            methods.push_back({v, f});
        }
    }
    return methods;
}

namespace {

struct pairs_view {
    const std::vector<truth>& truths;
    std::vector<int> hardness;
};

pairs_view view_of(const group& g) {
    return std::visit(
        []<int N>(const group_pairs<N>& pairs) {
            pairs_view view{pairs.truths, {}};
            for (const problem<N>& p : pairs.problems) {
                view.hardness.push_back(p.hardness);
            }
            return view;
        },
        g.pairs);
}

// Stops after so many seconds.
row_score score_of(solver& solves, std::size_t how, const pairs_view& pairs, double seconds) {
    const stopwatch since_start;
    row_score score;
    for (std::size_t i = 0; i < pairs.truths.size() && since_start.seconds() <= seconds; ++i) {
        score.add(solves.answer_to(how, i, pairs.truths[i]), pairs.truths[i], pairs.hardness[i]);
    }
    return score;
}

} // namespace

std::vector<row> measure(const measurable& type, const group& g, const measurement_plan& plan) {
    const std::unique_ptr<solver> solves = type.prepare(g);
    const pairs_view pairs = view_of(g);
    const std::vector<method> methods = solves->methods();
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (std::find(plan.methods.begin(), plan.methods.end(), methods[i]) != plan.methods.end()) {
            chosen.push_back(i);
        }
    }
    const bool limited = type.information.is_exact && !plan.every_pair;
    const double limit = limited ? plan.scoring_seconds / static_cast<double>(std::max<std::size_t>(chosen.size(), 1))
                                 : std::numeric_limits<double>::infinity();
    std::vector<row> rows;
    std::vector<timed_candidate> candidates;
    for (const std::size_t how : chosen) {
        row& r = rows.emplace_back();
        r.variant = to_string(methods[how].variant);
        r.root = to_string(methods[how].root);
        score_of(*solves, how, pairs, limit).write_to(r);
        candidates.push_back({[&solves, how](std::size_t count) { solves->run(how, count); }, pairs.truths.size()});
    }
    if (plan.timing_seconds > 0) {
        const std::vector<timing> times = time_interleaved(candidates, plan.timing_seconds);
        for (std::size_t i = 0; i < times.size(); ++i) {
            rows[i].nanoseconds = times[i].median;
            rows[i].nanoseconds_low = times[i].low;
            rows[i].nanoseconds_high = times[i].high;
            rows[i].timed_pairs = times[i].pairs;
            rows[i].repeats = times[i].repeats;
        }
    }
    return rows;
}

} // namespace compare
