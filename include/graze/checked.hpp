// try_classify, try_overlaps, try_time_of_impact, try_collide: the answer, or what is wrong with the input. They never
// throw.
#pragma once

#include <graze/own_types.hpp>

#include <optional>
#include <type_traits>
#include <utility>

namespace graze::inline v0_1 {

// A V, or what is wrong with the input. It does not convert to bool: where V is bool, that would read like the
// answer.
template <class V>
class [[nodiscard]] result {
  public:
    using value_type = V;

    constexpr result(V value) noexcept : value_(std::move(value)) {}
    constexpr result(const input_error& error) noexcept : error_(error) {}

    [[nodiscard]] constexpr bool has_value() const noexcept { return value_.has_value(); }

    // The answer. has_value()
    [[nodiscard]] constexpr const V& operator*() const noexcept { return *value_; }
    [[nodiscard]] constexpr const V* operator->() const noexcept { return &*value_; }

    // What is wrong. !has_value()
    [[nodiscard]] constexpr const input_error& error() const noexcept { return error_; }

  private:
    std::optional<V> value_;
    input_error error_;
};

namespace detail {

template <class Shape>
using number_of_shape = std::remove_cvref_t<decltype(vector_in(std::declval<const Shape&>())[0])>;

template <class Shape>
constexpr void inspect_any(const Shape& shape, const keeping_first& tell) noexcept {
    if constexpr (is_binary_input<number_of_shape<Shape>>) {
        inspect(shape, tell);
    } else {
        inspect_numbers(shape, tell);
    }
}

// For a wall or a triangle that is right in all other respects.
template <class Shape>
[[nodiscard]] constexpr bool has_parallel_edges(const Shape& shape) noexcept {
    using T = number_of_shape<Shape>;
    if constexpr (std::tuple_size_v<decltype(shape.edge)> == 1) {
        return false;
    } else if constexpr (is_binary_input<T>) {
        return has_parallel_edges<3>(lift_row<ball_and_wall<3>>(packed<ball_and_wall<3>>(ball<3, T>{}, shape)));
    } else {
        return graze::sign(graze::squared_norm(face_normal(shape.edge))) == 0;
    }
}

// The first fault of a pair, as the procedures that throw name it.
template <class A, class B>
[[nodiscard]] constexpr input_error error_in_pair(const A& a, const B& b) noexcept {
    input_error e;
    if constexpr (standing<A>) {
        e = error_in_pair(b, a);
    } else if constexpr (standing<B>) {
        inspect_any(a, {is_flight<A> ? "flight" : "ball", &e});
        inspect_any(b, {name_of(b), &e});
        if constexpr (requires { b.edge; }) {
            if (e.what == nullptr && has_parallel_edges(b)) {
                tell_parallel_edges(keeping_first{name_of(b), &e});
            }
        }
    } else {
        inspect_any(a, {name_of_a<A>, &e});
        inspect_any(b, {name_of_b<B>, &e});
    }
    return e;
}
template <class A, class B>
[[nodiscard]] constexpr input_error error_in_collision(const A& a, const B& b) noexcept {
    input_error e = error_in_pair(a, b);
    if constexpr (!standing<A> && !standing<B>) {
        inspect_masses(a, b, keeping_first{name_of_a<A>, &e}, keeping_first{name_of_b<B>, &e});
    }
    return e;
}

// The answer if nothing is wrong.
template <class Ask>
[[nodiscard]] constexpr auto answer_unless(const input_error& e, Ask ask) noexcept -> result<decltype(ask())> {
    if (e.what != nullptr) {
        return e;
    }
    return ask();
}

} // namespace detail

// The answer of the procedure without try_, for every pair kind, in either order, of graze's shapes or a user's. Where
// that procedure would throw, the error instead: the first fault, as its message names it. Needs no exceptions. An
// observer that throws ends the program.
template <class A, class B, class... Observer>
[[nodiscard]] constexpr auto try_classify(const A& a, const B& b, Observer&&... observer) noexcept {
    return detail::answer_unless(detail::error_in_pair(shape_of(a), shape_of(b)),
                                 [&] { return classify(a, b, observer...); });
}
template <class A, class B, class... Observer>
[[nodiscard]] constexpr auto try_classify_feature(const A& a, const B& b, Observer&&... observer) noexcept {
    return detail::answer_unless(detail::error_in_pair(shape_of(a), shape_of(b)),
                                 [&] { return classify_feature(a, b, observer...); });
}
template <class A, class B, class... Observer>
[[nodiscard]] constexpr auto try_overlaps(const A& a, const B& b, Observer&&... observer) noexcept {
    return detail::answer_unless(detail::error_in_pair(shape_of(a), shape_of(b)),
                                 [&] { return overlaps(a, b, observer...); });
}
template <class A, class B, class... Observer>
[[nodiscard]] constexpr auto try_time_of_impact(const A& a, const B& b, Observer&&... observer) noexcept {
    return detail::answer_unless(detail::error_in_pair(shape_of(a), shape_of(b)),
                                 [&] { return time_of_impact(a, b, observer...); });
}
template <class A, class B, class... Observer>
[[nodiscard]] constexpr auto try_collide(const A& a, const B& b, Observer&&... observer) noexcept {
    return detail::answer_unless(detail::error_in_collision(shape_of(a), shape_of(b)),
                                 [&] { return collide(a, b, observer...); });
}

} // namespace graze::inline v0_1
