// A formula in a number type, with the type erased: the subject of a measurement in the precision regression.
#pragma once

#include <graze/formula/quadratic.hpp>
#include <graze/precision/answer.hpp>
#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <concepts>
#include <memory>
#include <type_traits>
#include <variant>

namespace graze::inline v0_1::precision {

// A ball and the other thing of a pair, which in space may be a triangle.
template <int N>
struct pair {
    ball<N, double> a;
    std::conditional_t<N == 2, std::variant<ball<N, double>, plane<N, double>, wall<N, double>>,
                       std::variant<ball<N, double>, plane<N, double>, wall<N, double>, triangle<double>>>
        other;
};

// The answer is empty if the formula is not about such a pair. The call may throw, which counts as a wrong answer.
class subject {
  public:
    subject() = default;
    subject(const subject&) = delete;
    subject& operator=(const subject&) = delete;
    virtual ~subject() = default;

    [[nodiscard]] virtual std::optional<answer> operator()(const pair<2>& p) const = 0;
    [[nodiscard]] virtual std::optional<answer> operator()(const pair<3>& p) const = 0;
    // The order of two pairs' times.
    [[nodiscard]] virtual std::optional<answer> operator()(const pair<2>& p, const pair<2>& q) const = 0;
    [[nodiscard]] virtual std::optional<answer> operator()(const pair<3>& p, const pair<3>& q) const = 0;

    std::string variant;            // what tables call the formula
    quantity measures{};            // what is wrong where it throws
    number_type type;               // in which it runs
    bool correctly_rounded = false; // promises no wrong decision and no misrounded number
};

using subjects = std::vector<std::unique_ptr<subject>>;

namespace detail {

template <class T, int N>
[[nodiscard]] vec<N, T> in_type(const vec<N, double>& x) {
    return make_vec<N>([&](int i) { return number_access<T>::from(x[i]); });
}
template <class T, int N>
[[nodiscard]] ball<N, T> in_type(const ball<N, double>& b) {
    return {in_type<T>(b.position), in_type<T>(b.velocity), number_access<T>::from(b.radius),
            number_access<T>::from(b.mass)};
}
template <class T, int N>
[[nodiscard]] plane<N, T> in_type(const plane<N, double>& p) {
    return {in_type<T>(p.point), in_type<T>(p.normal)};
}
template <class T, int N>
[[nodiscard]] wall<N, T> in_type(const wall<N, double>& w) {
    wall<N, T> result{in_type<T>(w.corner), {}};
    for (std::size_t i = 0; i < w.edge.size(); ++i) {
        result.edge[i] = in_type<T>(w.edge[i]);
    }
    return result;
}

template <class T>
[[nodiscard]] triangle<T> in_type(const triangle<double>& t) {
    return {in_type<T>(t.corner), {in_type<T>(t.edge[0]), in_type<T>(t.edge[1])}};
}

template <class F, class T>
class typed_subject final : public subject {
  public:
    [[nodiscard]] std::optional<answer> operator()(const pair<2>& p) const override { return single(p); }
    [[nodiscard]] std::optional<answer> operator()(const pair<3>& p) const override { return single(p); }
    [[nodiscard]] std::optional<answer> operator()(const pair<2>& p, const pair<2>& q) const override {
        return both(p, q);
    }
    [[nodiscard]] std::optional<answer> operator()(const pair<3>& p, const pair<3>& q) const override {
        return both(p, q);
    }

  private:
    template <int N>
    [[nodiscard]] static std::optional<answer> single(const pair<N>& p) {
        return std::visit(
            [&](const auto& other) -> std::optional<answer> {
                using given = std::remove_cvref_t<decltype(in_type<T>(other))>;
                if constexpr (requires(ball<N, T> b) { F{}(b, in_type<T>(other)); }) {
                    return answered(F{}(in_type<T>(p.a), in_type<T>(other)));
                } else if constexpr (std::is_same_v<given, ball<N, T>> &&
                                     requires(ball<N, T> b) { T(F{}(relative_motion_of(b, b))); }) {
                    return answered(F::measures, T(F{}(relative_motion_of(in_type<T>(p.a), in_type<T>(other)))));
                } else {
                    return std::nullopt;
                }
            },
            p.other);
    }
    template <int N>
    [[nodiscard]] static std::optional<answer> both(const pair<N>& p, const pair<N>& q) {
        if constexpr (requires(ball<N, T> b) { F{}(b, b, b, b); }) {
            const auto* b = std::get_if<ball<N, double>>(&p.other);
            const auto* d = std::get_if<ball<N, double>>(&q.other);
            if (b != nullptr && d != nullptr) {
                return F{}(in_type<T>(p.a), in_type<T>(*b), in_type<T>(q.a), in_type<T>(*d));
            }
        }
        return std::nullopt;
    }
};

} // namespace detail

// A formula that the regression can measure in T: a stateless function object to call with two balls, a ball and a
// plane, a wall or a triangle (or, for an order, four balls), in the plane, in space or both. It returns an answer, or
// the ball_solution or wall_solution of graze::solve. A discriminant may be called with the relative_motion of two
// balls instead, and return a T. It has
//   static constexpr const char* name;      its name in tables, as one word
//   static constexpr quantity measures;     the quantity that counts as wrong if it throws
//   static constexpr bool correctly_rounded = true;   if it promises that nothing is ever wrong
template <class F, class T>
concept measurable = number<T> && std::default_initializable<F> && requires {
    { F::name } -> std::convertible_to<std::string>;
    { F::measures } -> std::convertible_to<quantity>;
};

template <class F, number T>
requires measurable<F, T>
void add(subjects& list) {
    auto s = std::make_unique<detail::typed_subject<F, T>>();
    s->variant = word_of(F::name);
    s->measures = F::measures;
    s->type = describe<T>();
    if constexpr (requires { F::correctly_rounded; }) {
        s->correctly_rounded = F::correctly_rounded;
    }
    list.push_back(std::move(s));
}

} // namespace graze::inline v0_1::precision
