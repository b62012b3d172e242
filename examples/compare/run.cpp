#include "run.hpp"

#include "answer_reader.hpp"
#include "exact_access.hpp"
#include "run/interruption.hpp"
#include "stopwatch.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace compare {

namespace {

using run::interrupted;

struct prepared_pairs {
    pair_list list;
    const std::vector<truth>& truths;
    std::vector<int> hardness;
    std::vector<std::size_t> numbers;
};

class number_list {
  public:
    void add(const exact& x) { numbers.push_back(exact_access::view(x)); }
    template <int N>
    void add(const graze::vec<N, exact>& x) {
        for (int i = 0; i < N; ++i) {
            add(x[i]);
        }
    }
    template <int N>
    void add(const exact_ball<N>& b) {
        add(b.shape.position);
        add(b.shape.velocity);
        add(b.shape.radius);
        add(b.inverse_mass);
    }
    std::vector<exact_view> numbers;
};

template <int N>
pair_numbers numbers_of(const problem<N>& pair) {
    number_list list;
    list.add(pair.a);
    switch (pair.kind) {
    case pair_kind::ball_ball:
        list.add(pair.b);
        break;
    case pair_kind::ball_plane:
        list.add(pair.plane.point);
        list.add(pair.plane.normal);
        break;
    case pair_kind::ball_wall:
    case pair_kind::ball_triangle:
        list.add(pair.wall.corner);
        for (const auto& edge : pair.wall.edge) {
            list.add(edge);
        }
        break;
    }
    return {pair.kind, std::move(list.numbers)};
}

prepared_pairs prepared(const group& g) {
    return std::visit(
        []<int N>(const group_pairs<N>& pairs) {
            prepared_pairs result{{N, {}}, pairs.truths, {}, {}};
            for (const problem<N>& p : pairs.problems) {
                result.list.pairs.push_back(numbers_of(p));
                result.hardness.push_back(p.hardness);
                result.numbers.push_back(p.number);
            }
            return result;
        },
        g.pairs);
}

// Stops after this many seconds.
row_score score_of(solver& solves, std::size_t how, const prepared_pairs& pairs, double seconds) {
    const stopwatch since_start;
    row_score score;
    for (std::size_t i = 0; i < pairs.truths.size() && since_start.seconds() <= seconds && !interrupted(); ++i) {
        score.add(read_answer(solves, how, i, pairs.truths[i]), pairs.truths[i], pairs.hardness[i], pairs.numbers[i]);
    }
    return score;
}

} // namespace

std::vector<row> measure(const measurable& type, const group& g, const measurement_plan& plan) {
    const prepared_pairs pairs = prepared(g);
    const std::unique_ptr<solver> solves = type.prepare(pairs.list);
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
        const auto timed = [&solves, how](std::size_t count) {
            if (!interrupted()) {
                solves->run(how, count);
            }
        };
        candidates.push_back({timed, pairs.truths.size()});
    }
    if (plan.timing_seconds > 0) {
        const std::vector<timing> times = time_interleaved(candidates, plan.timing_seconds);
        for (std::size_t i = 0; i < times.size(); ++i) {
            rows[i].nanoseconds = times[i].median;
            rows[i].nanoseconds_low = times[i].low;
            rows[i].nanoseconds_high = times[i].high;
            rows[i].timed_pairs = times[i].pairs;
            rows[i].repeats = times[i].repeated.size();
            rows[i].repeated = times[i].repeated;
        }
    }
    if (interrupted()) {
        rows.clear();
    }
    return rows;
}

void measure_all(results& found, const std::vector<measurable>& types, const std::vector<group>& groups,
                 const measurement_plan& plan, const progress_line& line) {
    std::size_t done = 0;
    for (const measurable& type : types) {
        found.types.push_back(type.information);
        for (const group& pairs : groups) {
            const std::string& name = type.information.name;
            line.show("measuring " + name + " on " + pairs.information.name, done++, types.size() * groups.size());
            if (type.prepare == nullptr) {
                continue;
            }
            std::vector<row> rows;
            if (!interrupted()) {
                rows = measure(type, pairs, plan);
            }
            if (interrupted()) {
                found.missing.push_back({name + " on " + pairs.information.name, "stopped before it was measured"});
            }
            for (row& measured : rows) {
                measured.type = name;
                measured.group = pairs.information.name;
                found.rows.push_back(std::move(measured));
            }
        }
    }
}

} // namespace compare
