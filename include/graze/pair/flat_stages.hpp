// The encounter of a ball with a flat shape by the later stages: scaled doubles, double words, then integers. All of it
// is compiled once per dimension and input type.
#pragma once

#include <graze/exact/approximate.hpp>
#include <graze/machine/environment.hpp>
#include <graze/number/bounded_word.hpp>
#include <graze/pair/bounded_double.hpp>
#include <graze/pair/compiled_questions.hpp>
#include <graze/pair/flat_judges.hpp>
#include <graze/pair/flat_signs.hpp>
#include <graze/pair/known_zero.hpp>
#include <graze/pair/pair.hpp>
#include <graze/pair/recorded_questions.hpp>
#include <graze/pair/scaled_row.hpp>
#include <graze/pair/stage.hpp>

namespace graze::inline v0_1::detail {

// what: the answer's feature means nothing. clearance: overlap if the two are inside each other now, else miss.
enum class flat_question : std::uint8_t { what, feature, clearance };

// The answer to a question from its decision.
template <class Decision>
[[nodiscard, gnu::always_inline]] constexpr inline flat_answer answer_of(const Decision& decision,
                                                                         flat_question question) {
    if (question == flat_question::clearance) {
        const int c = decision.clearance();
        return {c != open_sign, c < 0 ? encounter::overlap : encounter::miss};
    }
    const flat_answer found = decision.what();
    return question == flat_question::feature ? decision.with_feature(found) : found;
}

// By doubles and a bound from their magnitudes.
template <flat_question Question, int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline flat_answer
answer_by_filter_here(const flat_motion<N, double>& m, const flat_way<N, double>& way,
                      const filtered_judge<N, T>& judge) {
    const flat_decision<N, double, filtered_judge<N, T>> decision(m, way, judge);
    if constexpr (Question == flat_question::what) {
        return decision.what();
    } else {
        return answer_of(decision, Question);
    }
}
template <flat_question Question, int N, class T>
[[nodiscard, gnu::noinline]] constexpr flat_answer answer_by_filter_called(const flat_motion<N, double>& m,
                                                                           const flat_way<N, double>& way,
                                                                           const filtered_judge<N, T>& judge) {
    return answer_by_filter_here<Question>(m, way, judge);
}
// In the plane a call would cost a twentieth of the answer.
template <flat_question Question, int N, class T>
[[nodiscard, gnu::always_inline]] constexpr inline flat_answer
answer_by_filter(const flat_motion<N, double>& m, const flat_way<N, double>& way, const filtered_judge<N, T>& judge) {
    if constexpr (N == 2) {
        return answer_by_filter_here<Question>(m, way, judge);
    } else {
        return answer_by_filter_called<Question>(m, way, judge);
    }
}

// What is asked of a pair. rests: only whether it is one, since the ball recedes. guesses: any answer will do.
struct flat_asked {
    flat_question question;
    bool is_triangle, rests, guesses;
};

// The answer to a question for which there may be a guess: the probable answer.
template <class Decision>
[[nodiscard, gnu::always_inline]] constexpr inline flat_answer
answer_of(const Decision& decision, flat_question question, const flat_answer& guess) {
    if (question == flat_question::feature) {
        if (const flat_answer first = decision.if_alone(guess); first.certain) {
            return first;
        }
    }
    return answer_of(decision, question);
}
template <int N>
[[nodiscard, gnu::noinline]] constexpr flat_answer answer_by_name(flat_questions<N>& q, flat_question question,
                                                                  const flat_answer& guess) {
    return answer_of(flat_decision<N, named, flat_questions<N>>(q), question, guess);
}

// By numbers of T. In the plane, where formulas are short, the procedure is compiled for T; in space it asks by name.
// Not certain if the edges may be parallel.
template <int N, class T, class Judge>
[[nodiscard, gnu::always_inline]] constexpr inline flat_answer
answer_in(const flat_motion<N, T>& m, const Judge& judge, const flat_asked& asked, const flat_answer& guess = {}) {
    if constexpr (N == 2) {
        const auto way = way_of(m);
        return judge(way_square{}, way) != 1 ? flat_answer{}
               : asked.rests                 ? flat_answer{true}
                             : answer_of(flat_decision<N, T, Judge>(m, way, judge), asked.question, guess);
    } else {
        using questions =
            std::conditional_t<Judge::is_quick, compiled_questions<N, T, Judge>, recorded_questions<N, T, Judge>>;
        questions q(m, judge);
        return q.sign(flat_name::square, {}) != 1 ? flat_answer{}
               : asked.rests                      ? flat_answer{true}
                                                  : answer_by_name<N>(q, asked.question, guess);
    }
}

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
template <flat_question Question, int N, class In>
[[nodiscard, gnu::noinline]] flat_answer answer_by_scaling(const In& in, bool is_triangle) noexcept {
    const auto m = flat_motion_in<N, double>(in, is_triangle);
    filtered_judge<N, double> judge{magnitudes_of(m)};
    if constexpr (Question == flat_question::clearance) {
        forget_rest_in(judge.scales);
    }
    return usable<double>(judge.scales) ? answer_by_filter<Question>(m, way_of(m), judge) : flat_answer{};
}

// In doubles with a running error, as far as no feature is asked for: this settles balls that are far away, and most
// that nearly graze.
template <int N, class In>
[[nodiscard, gnu::noinline]] flat_answer answer_by_refining(const In& in, const flat_asked& asked) noexcept {
    if (asked.question == flat_question::clearance) {
        return {};
    }
    const auto m = flat_motion_in<N, bounded_double<53>>(in, asked.is_triangle);
    if (asked.rests) {
        return {refined_judge{}(edges_span{}, edges_of(m)) == 1};
    }
    const auto zeros = flat_motion_in<N, known_zero>(in, asked.is_triangle);
    const refined_judge judge{graze::dot(zeros.u, face_normal(zeros.e)).is_zero(), asked.guesses};
    const bool lacks_feature = asked.question == flat_question::feature && !asked.guesses;
    flat_asked now = asked;
    now.question = lacks_feature ? flat_question::what : asked.question;
    const flat_answer found = answer_in(m, judge, now);
    return lacks_feature && found.what == encounter::hit ? flat_answer{} : found;
}

// In double words with a running error. What doubles say is probable, whatever their bounds.
template <int N, class In>
[[nodiscard, gnu::noinline]] flat_answer answer_by_words(const In& in, const flat_asked& asked) noexcept {
    const flat_answer guess = asked.question == flat_question::feature
                                  ? answer_by_refining<N>(in, {flat_question::feature, asked.is_triangle, false, true})
                                  : flat_answer{};
    return answer_in(flat_motion_in<N, bounded_word>(in, asked.is_triangle), word_judge{}, asked, guess);
}

// Not certain if edges are parallel.
template <int N>
[[nodiscard, gnu::noinline]] constexpr flat_answer
answer_by_integers(const lifted_inputs<ball_and_wall<N>::lengths, ball_and_wall<N>::velocities, 0>& in,
                   const flat_asked& asked) {
    exact_workspace room;
    auto here = in;
    here.use(room);
    return answer_in(flat_motion_in<N, big_integer>(here, asked.is_triangle), exact_judge{&room}, asked);
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
template <flat_question Question, int N, class T>
[[nodiscard, gnu::noinline]] flat_answer answer_by_scaled(const T* row, const flat_asked& asked, bool filtered,
                                                          stage& by) noexcept {
    const scaled_row<ball_and_wall<N>, T> scaled(row);
    if (!(scaled.length.plain && scaled.velocity.plain)) {
        return {};
    }
    if (!filtered && !asked.rests) {
        if (const flat_answer found = answer_by_scaling<Question, N>(scaled, asked.is_triangle); found.certain) {
            by = wider(by, stage::refined);
            return found;
        }
    }
    const flat_answer found = answer_by_refining<N>(scaled, asked);
    by = wider(by, found.certain ? stage::refined : stage::double_word);
    return found.certain || asked.rests ? found : answer_by_words<N>(scaled, asked);
}

// The answer for a row of checked numbers. If edges are parallel it is not certain.
template <flat_question Question, int N, class T, class Row>
[[nodiscard, gnu::noinline]] constexpr flat_answer refine_flat(const Row& row, bool is_triangle, bool rests,
                                                               bool filtered, stage& by) {
    const flat_asked asked{Question, is_triangle, rests && Question != flat_question::clearance, false};
    if constexpr (has_error_free_doubles && !is_wide_integer<T>) {
        if (!std::is_constant_evaluated() && rounds_to_nearest()) {
            const flat_answer found = answer_by_scaled<Question, N, T>(row.data(), asked, filtered, by);
            if (found.certain) {
                return found;
            }
        }
    }
    by = stage::exact;
    return answer_by_integers<N>(lift_row<ball_and_wall<N>>(row), asked);
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
