// The encounter of a ball with a flat shape by the later stages: scaled doubles, double words, then integers. All of it
// is compiled once per dimension and input type.
#pragma once

#include <graze/exact/approximate.hpp>
#include <graze/machine/environment.hpp>
#include <graze/number/bounded_word.hpp>
#include <graze/pair/bounded_double.hpp>
#include <graze/pair/flat_signs.hpp>
#include <graze/pair/known_zero.hpp>
#include <graze/pair/pair.hpp>
#include <graze/pair/scaled_row.hpp>
#include <graze/pair/stage.hpp>

namespace graze::inline v0_1::detail {

// what: the answer's feature means nothing. clearance: overlap if the two are inside each other now, else miss.
enum class flat_question : std::uint8_t { what, feature, clearance };

struct no_guess {};

// guess(): the probable answer, if there is one.
template <int N, class T, class Judge, class Guess = no_guess>
[[nodiscard, gnu::always_inline]] constexpr inline flat_answer answer_of(const flat_motion<N, T>& m, const Judge& judge,
                                                                         flat_question question, Guess guess = {}) {
    const auto way = way_of(m);
    const flat_decision<N, T, Judge> decision(m, way, judge);
    if (question == flat_question::clearance) {
        const int c = decision.clearance();
        return {c != open_sign, c < 0 ? encounter::overlap : encounter::miss};
    }
    if constexpr (!std::is_same_v<Guess, no_guess>) {
        if (question == flat_question::feature) {
            if (const flat_answer first = decision.if_alone(guess()); first.certain) {
                return first;
            }
        }
    }
    const flat_answer found = decision.what();
    return question == flat_question::what ? found : decision.with_feature(found);
}

// By doubles and a bound from these magnitudes.
template <int N>
[[nodiscard, gnu::noinline]] flat_answer answer_by_filter(const flat_motion<N, double>& m, const magnitudes& s,
                                                          flat_question question) noexcept {
    const filtered_judge<N, double> judge{s};
    return answer_of(m, judge, question);
}

struct word_judge {
    static constexpr bool has_roots = true;
    [[nodiscard]] bool root(const bounded_word& x, bounded_word& y) const noexcept {
        y = sqrt(x);
        return true;
    }

    template <class F, class X>
    [[nodiscard]] int operator()(F f, const X& x) const noexcept {
        const bounded_word y = f(x);
        return y.has_certain_sign() ? graze::sign(y) : y.is_zero() ? 0 : open_sign;
    }
};
// No sign of it is a certain 0, but that of a speed which is known to vanish.
struct refined_judge {
    static constexpr bool has_roots = false;
    bool moves_along = false; // the plane

    template <class F, class X>
    [[nodiscard]] int operator()(F f, const X& x) const noexcept {
        if constexpr (std::is_same_v<F, way_speed>) {
            if (moves_along) {
                return 0;
            }
        }
        // A step loses less than 2^-1070; inputs below 2^3, a degree below 30 and fewer than 2^11 steps leave that
        // below 2^-900.
        const int s = bounded_double<53>(f(x)).certain_sign(0x1p-900);
        return s != 0 ? s : open_sign;
    }
};
struct exact_judge {
    static constexpr bool has_roots = false;
    workspace* room;

    [[nodiscard]] constexpr workspace::scope scope() const noexcept { return workspace::scope(room); }

    template <class F, class X>
    [[nodiscard]] constexpr int operator()(F f, const X& x) const {
        const workspace::scope own(room);
        return graze::sign(f(x));
    }
};

template <int N, class I>
[[nodiscard, gnu::always_inline]] constexpr inline vec<N, I> difference_of_inputs(const vec<N, I>& x,
                                                                                  const vec<N, I>& y) {
    if constexpr (requires { I::exact_difference(x[0], y[0]); }) {
        return make_vec<N>([&](int i) { return I::exact_difference(x[i], y[i]); });
    } else {
        return x - y;
    }
}
template <int N, class I, class Inputs>
[[nodiscard]] constexpr flat_motion<N, I> flat_motion_in(const Inputs& in, bool is_triangle) {
    const auto s = ball_and_wall<N>::template shapes_of<I>(in);
    return {difference_of_inputs(s.ball.position, s.wall.corner), s.ball.velocity, s.wall.edge, s.ball.radius,
            is_triangle};
}

// Of a pair that is out of the filter's range: scaled, and by the filter.
template <int N, class In>
[[nodiscard, gnu::noinline]] flat_answer answer_by_scaling(const In& in, bool is_triangle,
                                                           flat_question question) noexcept {
    const auto m = flat_motion_in<N, double>(in, is_triangle);
    magnitudes s = magnitudes_of(m);
    if (question == flat_question::clearance) {
        forget_rest_in(s);
    }
    return usable<double>(s) ? answer_by_filter(m, s, question) : flat_answer{};
}

// In doubles with a running error, as far as no feature is asked for: this settles balls that are far away, and most
// that nearly graze.
template <int N, class In>
[[nodiscard, gnu::noinline]] flat_answer answer_by_refining(const In& in, bool is_triangle,
                                                            flat_question question) noexcept {
    const auto m = flat_motion_in<N, bounded_double<53>>(in, is_triangle);
    const refined_judge judge{way_speed{}(way_of(flat_motion_in<N, known_zero>(in, is_triangle))).is_zero()};
    if (question == flat_question::clearance || judge(edges_span{}, edges_of(m)) != 1) {
        return {};
    }
    const auto way = way_of(m);
    const flat_answer found = flat_decision<N, bounded_double<53>, refined_judge>(m, way, judge).what();
    return question == flat_question::feature && found.what == encounter::hit ? flat_answer{} : found;
}

// In double words with a running error. What doubles say is probable, whatever their bounds.
template <int N, class In>
[[nodiscard, gnu::noinline]] flat_answer answer_by_words(const In& in, bool is_triangle,
                                                         flat_question question) noexcept {
    const auto m = flat_motion_in<N, bounded_word>(in, is_triangle);
    const word_judge judge;
    const auto guess = [&] {
        return answer_by_filter(flat_motion_in<N, double>(in, is_triangle), {0, 0, 0}, flat_question::feature);
    };
    return judge(edges_span{}, edges_of(m)) == 1 ? answer_of(m, judge, question, guess) : flat_answer{};
}

template <int N>
[[nodiscard, gnu::noinline]] constexpr flat_answer
answer_by_integers(const lifted_inputs<ball_and_wall<N>::lengths, ball_and_wall<N>::velocities, 0>& in,
                   bool is_triangle, flat_question question) {
    exact_workspace room;
    auto here = in;
    here.use(room);
    return answer_of(flat_motion_in<N, big_integer>(here, is_triangle), exact_judge{&room}, question);
}

// Whether the edges in a row are parallel.
template <int N>
[[nodiscard, gnu::noinline]] constexpr bool
has_parallel_edges(const lifted_inputs<ball_and_wall<N>::lengths, ball_and_wall<N>::velocities, 0>& in) {
    exact_workspace room;
    auto here = in;
    here.use(room);
    const auto n = face_normal(ball_and_wall<N>::template shapes_of<big_integer>(here).wall.edge);
    return sign(graze::squared_norm(n)) == 0;
}

// Of a row of checked numbers by scaled or refined doubles, then by double words. filtered: whether the filter has
// tried.
template <int N, class T>
[[nodiscard, gnu::noinline]] flat_answer answer_by_scaled(const T* row, bool is_triangle, bool filtered,
                                                          flat_question question, stage& by) noexcept {
    const scaled_row<ball_and_wall<N>, T> scaled(row);
    if (!(scaled.length.plain && scaled.velocity.plain)) {
        return {};
    }
    const flat_answer found = filtered ? answer_by_refining<N>(scaled, is_triangle, question)
                                       : answer_by_scaling<N>(scaled, is_triangle, question);
    by = wider(by, found.certain ? stage::refined : stage::double_word);
    return found.certain ? found : answer_by_words<N>(scaled, is_triangle, question);
}

// Whether doubles with a running error tell that the edges in a row are not parallel.
template <int N, class T>
[[nodiscard, gnu::noinline]] bool edges_differ(const T* row) noexcept {
    const scaled_row<ball_and_wall<N>, T> scaled(row);
    return scaled.length.plain &&
           refined_judge{}(edges_span{}, edges_of(flat_motion_in<N, bounded_double<53>>(scaled, false))) == 1;
}

// The answer for a row of checked numbers. If edges are parallel it is not certain.
template <int N, class T, class Row>
[[nodiscard, gnu::noinline]] constexpr flat_answer refine_flat(const Row& row, bool is_triangle, bool rests,
                                                               bool filtered, flat_question question, stage& by) {
    constexpr bool has_words = has_error_free_doubles && !is_wide_integer<T>;
    if (rests && question != flat_question::clearance) {
        by = wider(by, stage::filter);
        if constexpr (has_words) {
            if (!std::is_constant_evaluated() && rounds_to_nearest() && edges_differ<N, T>(row.data())) {
                return flat_answer{true};
            }
        }
        return has_parallel_edges<N>(lift_row<ball_and_wall<N>>(row)) ? flat_answer{} : flat_answer{true};
    }
    if constexpr (has_words) {
        if (!std::is_constant_evaluated() && rounds_to_nearest()) {
            const flat_answer found = answer_by_scaled<N, T>(row.data(), is_triangle, filtered, question, by);
            if (found.certain) {
                return found;
            }
        }
    }
    by = stage::exact;
    const auto in = lift_row<ball_and_wall<N>>(row);
    return has_parallel_edges<N>(in) ? flat_answer{} : answer_by_integers<N>(in, is_triangle, question);
}

// Whether all numbers of a row are below 2^48, so that formulas in doubles don't overflow, not even in a constant
// expression.
template <class Row>
[[nodiscard]] constexpr bool is_moderate_row(const Row& row) noexcept {
    for (const auto& x : row) {
        const binary b = split(x);
        if (!is_finite_input(x) || (b.significand != 0 && b.exponent > -5)) {
            return false;
        }
    }
    return true;
}
template <int N, class T, class Shape>
[[nodiscard]] constexpr bool is_moderate(const ball<N, T>& b, const Shape& s) noexcept {
    return is_moderate_row(packed<pair_with<Shape>>(b, s));
}

} // namespace graze::inline v0_1::detail
