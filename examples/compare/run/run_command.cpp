#include "run_command.hpp"

#include "../input_error.hpp"
#include "../report.hpp"
#include "../rounding.hpp"
#include "../whole_file.hpp"
#include "run_report.hpp"
#include "scene_in.hpp"

#include <graze/scene/overlapping.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <variant>

namespace compare::run {

namespace {

std::vector<runnable> runnables_of(const run_options& o) {
    std::vector<runnable> all = all_runnables();
    const auto named = [&](const std::string& name) {
        return std::any_of(all.begin(), all.end(), [&](const runnable& r) { return r.type == name; });
    };
    std::string names;
    for (const runnable& r : all) {
        names += (names.empty() ? "" : ", ") + r.type;
    }
    for (const std::string& name : o.types) {
        if (!named(name)) {
            throw input_error("--types: no number type \"" + printable(name) + "\" runs; there are " + names);
        }
    }
    if (!o.paths.empty() && !named(o.beside)) {
        throw input_error("--beside: no number type \"" + printable(o.beside) + "\" runs; there are " + names);
    }
    std::erase_if(all, [&](const runnable& r) {
        const bool wanted = o.types.empty() || std::find(o.types.begin(), o.types.end(), r.type) != o.types.end();
        return o.certified_alone || !(wanted || (!o.paths.empty() && r.type == o.beside));
    });
    return all;
}

using place = std::array<double, 2>;

outline circle(double x, double y, double radius) {
    outline o;
    for (int i = 0; i <= 72; ++i) {
        const double angle = i * 0.087266462599716479; // 5°
        o.points.push_back(place{x + radius * std::cos(angle), y + radius * std::sin(angle)});
    }
    return o;
}

// "3 pairs overlap at the start: ball 0 and ball 1, ...", or nothing.
template <int N>
std::string overlap_remark(const exact_scene<N>& scene) {
    const auto own = scene_in<exact>(scene, exact(1), [](const exact& x) { return x; });
    const std::vector<graze::scene_pair> pairs = graze::overlapping(own.view());
    if (pairs.empty()) {
        return "";
    }
    constexpr std::size_t most_named = 3;
    std::string text =
        std::to_string(pairs.size()) + (pairs.size() == 1 ? " pair overlaps" : " pairs overlap") + " at the start: ";
    for (std::size_t i = 0; i < std::min(pairs.size(), most_named); ++i) {
        text += (i > 0 ? ", " : "") + to_string(pairs[i]);
    }
    return text + (pairs.size() > most_named ? ", ...\n" : "\n");
}

// Mirrors, walls, and planes as far as a picture reaches.
std::vector<outline> outlines_of(const exact_scene<2>& scene) {
    std::vector<outline> all;
    const auto number = [](const exact& x) { return nearest_double(x); };
    for (const exact_ball<2>& b : scene.balls) {
        if (b.inverse_mass.is_zero()) {
            all.push_back(circle(number(b.shape.position[0]), number(b.shape.position[1]), number(b.shape.radius)));
        }
    }
    for (const auto& w : scene.walls) {
        const auto far = w.corner + w.edge[0];
        all.push_back({{place{number(w.corner[0]), number(w.corner[1])}, place{number(far[0]), number(far[1])}}});
    }
    for (const auto& p : scene.planes) {
        const double n[2] = {number(p.normal[0]), number(p.normal[1])};
        const double reach = 1e4 / std::hypot(n[0], n[1]);
        all.push_back({{place{number(p.point[0]) - reach * n[1], number(p.point[1]) + reach * n[0]},
                        place{number(p.point[0]) + reach * n[1], number(p.point[1]) - reach * n[0]}}});
    }
    return all;
}

std::vector<path> paths_of(const certified_result<2>& proved, const exact_scene<2>& scene) {
    std::vector<path> all(scene.balls.size());
    const auto add = [&](std::size_t ball, double t, const graze::vec<2, certified>& x) {
        all[ball].push_back(path::value_type{t, near_double(x[0]), near_double(x[1])});
    };
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const auto& x = scene.balls[i].shape.position;
        all[i].push_back(path::value_type{0, nearest_double(x[0]), nearest_double(x[1])});
    }
    for (const certified_event<2>& e : proved.events) {
        add(static_cast<std::size_t>(e.who.a), near_double(e.time), e.a.position);
        if (e.b) {
            add(static_cast<std::size_t>(e.who.b), near_double(e.time), e.b->position);
        }
    }
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        add(i, near_double(proved.end), proved.balls[i].position);
    }
    return all;
}

// The digits after the point of a number of about this size.
long decimals_for(double size, int digits) {
    return size > 0 ? digits - 1 - static_cast<long>(std::floor(std::log10(size))) : digits;
}

template <int N>
void describe(run_report& r, const certified_result<N>& proved, const run_options& o) {
    for (const certified_event<N>& e : proved.events) {
        const long decimals = std::min<long>(decimals_of(e.time) - 1, o.wanted.digits);
        r.events.push_back({e.who, decimal_text(e.time, std::max(decimals, 0L)), near_double(e.time), e.tied,
                            e.either_order, e.chosen});
        r.choices += e.chosen ? 1 : 0;
    }
    r.why = proved.why;
    r.jammed = proved.jammed;
    r.problem = proved.problem;
    r.bits = proved.bits;
    r.attempts = proved.attempts;
    r.seconds = proved.seconds;
    r.digits_wanted = o.wanted.digits;
    r.digits = proved.digits;
    const int digits = std::min(o.wanted.digits, proved.digits);
    const long time_decimals = std::min<long>(decimals_of(proved.end) - 1, o.wanted.digits);
    r.end = decimal_text(proved.end, std::max(time_decimals, 0L));
    if (r.end.find('.') != std::string::npos) {
        r.end.erase(r.end.find_last_not_of('0') + 1);
        r.end.erase(r.end.find_last_not_of('.') + 1);
    }
    double largest = 0, fastest = 0;
    for (const auto& b : proved.balls) {
        for (int i = 0; i < N && !b.mass.is_infinite(); ++i) {
            largest = std::max(largest, std::abs(near_double(b.position[i])));
            fastest = std::max(fastest, std::abs(near_double(b.velocity[i])));
        }
    }
    for (std::size_t i = 0; i < proved.balls.size(); ++i) {
        const auto& b = proved.balls[i];
        if (b.mass.is_infinite()) {
            continue;
        }
        end_state s{static_cast<int>(i), {}, {}};
        for (int k = 0; k < N; ++k) {
            s.position.push_back(decimal_text(b.position[k], decimals_for(largest, digits)));
            s.velocity.push_back(decimal_text(b.velocity[k], decimals_for(fastest, digits)));
        }
        r.states.push_back(std::move(s));
    }
    if (o.distance) {
        r.distance_of = o.distance;
        const certified distance =
            sqrt(graze::squared_norm(proved.balls[static_cast<std::size_t>(*o.distance)].position));
        r.distance = decimal_text(
            distance,
            std::max(std::min(decimals_of(distance) - 1, decimals_for(near_double(distance), o.wanted.digits)), 0L));
    }
}

template <int N>
run_report report_of(const exact_scene<N>& scene, const run_options& o, const std::vector<runnable>& types,
                     const progress_line& line) {
    if (o.distance && static_cast<std::size_t>(*o.distance) >= scene.balls.size()) {
        throw input_error("--distance: there is no ball " + std::to_string(*o.distance) + ", the last one is " +
                          std::to_string(scene.balls.size() - 1));
    }
    certainty wanted = o.wanted;
    // Beside types, the truth needs more digits than the finest type has.
    constexpr int of_types = 120;
    wanted.digits = types.empty() ? wanted.digits : std::max(wanted.digits, of_types);
    wanted.digits += o.distance ? 3 : 0;
    const certified_result<N> proved = certified_run<N>(scene, o.how_far, wanted, line);
    run_report r;
    describe<N>(r, proved, o);
    true_sequence<N> truth = sequence_of<N>(proved, scene);
    if (o.distance) {
        truth.distance_of = static_cast<std::size_t>(*o.distance);
    }
    run_plan plan{o.how_far, o.timing, !o.paths.empty(), {}};
    if (!proved.problem.empty() || interrupted()) { // no farther than the truth is known
        plan.how_far.events = proved.events.size();
    }
    for (const runnable& type : types) {
        const std::string running = "running " + type.type + " (" + std::to_string(r.types.size() + 1) + " of " +
                                    std::to_string(types.size()) + ")";
        line.show(running);
        plan.show_progress = [&](std::uint64_t events, double time) {
            line.show(running + ": " + progress_of(plan.how_far, events, time));
        };
        history found;
        if (interrupted()) {
            found.compared = comparison::none;
        } else if constexpr (N == 2) {
            found = type.in_plane(scene, truth, plan);
        } else {
            found = type.in_space(scene, truth, plan);
        }
        found.type = type.type;
        found.library = type.library;
        const first_mistake mistake = first_mistake_of<N>(found, proved);
        r.types.push_back({std::move(found), mistake});
    }
    line.show("");
    r.interrupted = interrupted();
    if constexpr (N == 2) {
        if (!o.paths.empty()) {
            r.paths = paths_of(proved, scene);
            for (const exact_ball<2>& b : scene.balls) {
                r.radii.push_back(nearest_double(b.shape.radius));
            }
            r.outlines = outlines_of(scene);
        }
    }
    return r;
}

void write_picture_that_is(const std::string& svg, const std::string& command, const std::string& path) {
    if (svg.empty()) {
        throw std::runtime_error(path + ": there is no picture to write: nothing happened");
    }
    write_picture_file(svg, command, path);
}

} // namespace

bool run_scene(const run_options& o, const std::string& command, const progress_line& line) {
    const scene_file file = read_scene(o.scene, o.numbers);
    const std::vector<runnable> types = runnables_of(o);
    if (!o.paths.empty() && std::holds_alternative<exact_scene<3>>(file.scene)) {
        throw input_error("--paths: " + printable(o.scene) + " is no scene in the plane");
    }
    std::cout << std::visit([](const auto& scene) { return overlap_remark(scene); }, file.scene) << std::flush;
    note_interruptions();
    run_report r = std::visit([&](const auto& scene) { return report_of(scene, o, types, line); }, file.scene);
    r.command = command;
    r.scene = file.name;
    if (!o.json.empty()) {
        write_whole_file(o.json, to_json(r));
    }
    std::cout << to_text(r, o.with_events) << std::flush;
    if (!o.picture.empty()) { // last, since these fail without gnuplot
        write_picture_that_is(digits_picture(r), command, o.picture);
    }
    if (!o.paths.empty()) {
        const auto beside = std::find_if(r.types.begin(), r.types.end(),
                                         [&](const judged_history& j) { return j.found.type == o.beside; });
        write_picture_that_is(beside == r.types.end() ? "" : paths_picture(r, *beside), command, o.paths);
    }
    return r.problem.empty() && !r.interrupted && r.why != graze::ending::cascade;
}

} // namespace compare::run
