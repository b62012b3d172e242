// The steps of all formulas that decide about a ball and a flat shape, recorded once for every slow number type.
#pragma once

#include <graze/formula/flat_encounter.hpp>
#include <graze/pair/flat_questions.hpp>
#include <graze/pair/recorded.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

// A row of numbers holds, one after the other: the motion; what its way takes; its place; what is chosen of a feature
// (w, d, inside, inward); the feature's numbers; at last what a single formula takes.
template <int N>
struct flat_programs {
    static_assert(N == 3, "in the plane formulas are so short that they are compiled for each type");

    struct program {
        std::uint16_t first = 0;
        std::uint8_t count = 0, result = 0;
    };
    struct choice {
        program steps;
        std::array<std::uint8_t, 2 * N + 2> from{};
    };
    static constexpr std::size_t borders = 8; // of a wall, then of a triangle
    static constexpr std::size_t motion_size = N * (N + 1) + 1;

    std::array<recorded_step, 480> step{};
    int count = 0;
    program way, place, feature, moment;
    std::array<program, static_cast<std::size_t>(flat_name::count)> named{};
    std::array<program, borders> inside{}, inward{}, inside_now{}, touch_norm{}, touch_inside{};
    std::array<std::array<choice, borders>, 5> choose{}; // by corner; the last one of an edge
    std::uint8_t speed = 0, square = 0, chosen = 0, touch = 0, formula = 0;
    std::array<std::uint8_t, N - 1> at{};
    int size = 0;

    consteval flat_programs() { record(); }

  private:
    using number = recorded;

    consteval void record() {
        open_recording r;
        int next = 0;
        const auto fresh = [&] { return number(r, next++); };
        const auto vector = [&] { return make_vec<N>([&](int) { return fresh(); }); };
        flat_motion<N, number> m{vector(), vector(), {}, {}, false};
        for (auto& e : m.e) {
            e = vector();
        }
        m.r = fresh();
        // Takes the steps since the last time.
        const auto take = [&](int result) {
            const program p{static_cast<std::uint16_t>(count), static_cast<std::uint8_t>(r.count),
                            static_cast<std::uint8_t>(result)};
            for (int i = 0; i < r.count; ++i) {
                step[static_cast<std::size_t>(count++)] = r.step[static_cast<std::size_t>(i)];
            }
            size = std::max(size, r.inputs + r.count);
            return p;
        };
        const auto begin = [&](int inputs) {
            r.inputs = inputs;
            r.count = 0;
        };
        const auto keep = [&] {
            const program p = take(0);
            next = r.inputs + r.count;
            begin(next);
            return p;
        };
        begin(next);
        const auto w = way_of(m);
        way = keep();
        speed = static_cast<std::uint8_t>(w.speed.place());
        square = static_cast<std::uint8_t>(w.nn.place());
        for (std::size_t i = 0; i < at.size(); ++i) {
            at[i] = static_cast<std::uint8_t>(w.at[i].place());
        }
        const auto p = place_of(m, w);
        place = keep();
        chosen = static_cast<std::uint8_t>(next);
        const auto from = vector(), along = vector();
        const auto inside_it = fresh(), inward_it = fresh();
        begin(next);
        auto x = edge_of(from, m.u, along, m.r, inside_it, inward_it, w.speed);
        feature = keep();
        x.moment = moment_of(from, m.u);
        moment = keep();
        touch = static_cast<std::uint8_t>(next);
        const flat_touch<N, number> t = [&] {
            flat_touch<N, number> now{fresh(), fresh(), m.r, {}, w.pull};
            for (auto& a : now.at) {
                a = fresh();
            }
            return now;
        }();
        formula = static_cast<std::uint8_t>(next);
        const auto one = [&](auto f, const auto& numbers) {
            begin(next);
            const int result = number(f(numbers)).place();
            return take(result);
        };
        const auto name = [&](auto f, const auto& numbers) {
            named[static_cast<std::size_t>(name_of_formula<decltype(f)>)] = one(f, numbers);
        };
        name(way_square{}, w);
        name(way_speed{}, w);
        name(way_height{}, w);
        name(way_clearance{}, w);
        name(nearest_from_start{}, x);
        name(nearest_from_end{}, x);
        name(foot_from_start{}, x);
        name(foot_from_end{}, x);
        name(border_h{}, x);
        name(border_c{}, x);
        name(border_discriminant{}, x);
        name(corner_h{}, x);
        name(corner_c{}, x);
        name(corner_discriminant{}, x);
        name(direction_speed{}, x);
        name(touch_along_norm<nearest_from_start>{}, x);
        name(touch_along_norm<nearest_from_end>{}, x);
        name(touch_outside{}, x);
        name(touch_inward{}, x);
        name(touch_outside_norm{}, x);
        name(touch_behind_norm{}, x);
        for (std::size_t i = 0; i < borders; ++i) {
            const int k = static_cast<int>(i % 4);
            m.is_triangle = i >= 4;
            if (k >= borders_of(N, m.is_triangle)) {
                continue;
            }
            inside[i] = one(inside_border{k, m.is_triangle}, w);
            inward[i] = one(inward_speed{k, m.is_triangle}, w);
            inside_now[i] = one(inside_border{k, m.is_triangle}, p);
            touch_norm[i] = one(touch_inside_norm{k, m.is_triangle}, w);
            touch_inside[i] = one(graze::touch_inside{k, m.is_triangle}, t);
            for (int corner = 0; corner <= 4; ++corner) {
                const bool is_edge = corner == 4;
                begin(next);
                const int at_corner = is_edge ? ends_of_border(k, m.is_triangle).start : corner;
                const auto c = centre_from(m, at_corner);
                const auto d = direction_from(m, at_corner, k);
                const auto in = is_edge ? inside_border{k, m.is_triangle}(w) : w.speed;
                const auto inwards = is_edge ? inward_speed{k, m.is_triangle}(w) : w.speed;
                choice& here = choose[static_cast<std::size_t>(corner)][i];
                here.steps = take(0);
                for (int j = 0; j < N; ++j) {
                    here.from[static_cast<std::size_t>(j)] = static_cast<std::uint8_t>(c[j].place());
                    here.from[static_cast<std::size_t>(N + j)] = static_cast<std::uint8_t>(d[j].place());
                }
                here.from[2 * N] = static_cast<std::uint8_t>(in.place());
                here.from[2 * N + 1] = static_cast<std::uint8_t>(inwards.place());
            }
        }
    }
};

template <int N>
inline constexpr flat_programs<N> flat_program{};
static_assert(flat_program<3>.size <= 256, "steps name places in a byte");

} // namespace graze::inline v0_1::detail
