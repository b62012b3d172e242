// A bad number is named and never yields an answer, whatever the other numbers are.
#include "../property.hpp"
#include "answers.hpp"
#include "faults.hpp"

#include <graze/checked.hpp>

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace {

// The fault that try_classify reports; its message names the field.
template <class A, class B>
std::string told_without_exceptions(const A& a, const B& b) {
    const auto answer = graze::try_classify(a, b);
    if (answer.has_value()) {
        return "";
    }
    const std::string message = answer.error().message();
    CHECK(message.find(std::string(answer.error().argument) + ": " + answer.error().field) == 0);
    return message;
}

// The same message from each predicate.
template <class A, class B>
std::string message(const A& a, const B& b) {
    auto decided_by = graze::stage::filter;
    const std::string first = faults::thrown_by([&] { (void)answers::encounter_of(a, b, decided_by); });
    CHECK(first == faults::thrown_by([&] { (void)answers::overlap_of(a, b, decided_by); }));
    CHECK(first == faults::thrown_by([&] { (void)answers::time_of(a, b); }));
    CHECK(first == told_without_exceptions(a, b));
    return first;
}

template <int N, class T>
graze::vec<N, T> filled(int x) {
    return graze::make_vec<N>([x](int i) { return static_cast<T>(x + i); });
}
template <int N, class T>
graze::ball<N, T> good_ball(int x) {
    return {filled<N, T>(x), filled<N, T>(-1), T(1)};
}
template <int N, class T>
graze::wall<N, T> good_wall() {
    graze::wall<N, T> w{filled<N, T>(0), {}};
    for (std::size_t i = 0; i < w.edge.size(); ++i) {
        w.edge[i][static_cast<int>(i)] = T(2);
    }
    return w;
}

// Sets each component of x in turn to every number that is not finite.
template <int N, class T, class F>
void each_bad(graze::vec<N, T>& x, F f) {
    using limits = std::numeric_limits<T>;
    for (int i = 0; i < N; ++i) {
        const T good = x[i];
        for (const T bad : {limits::quiet_NaN(), limits::signaling_NaN(), -limits::quiet_NaN(), limits::infinity(),
                            -limits::infinity()}) {
            x[i] = bad;
            f();
        }
        x[i] = good;
    }
}

template <int N, class T, class B>
void check_ball(graze::ball<N, T>& tried, const std::string& name, const graze::ball<N, T>& a, const B& b) {
    using limits = std::numeric_limits<T>;
    each_bad(tried.position, [&] { CHECK(message(a, b) == name + ": position is not finite"); });
    each_bad(tried.velocity, [&] { CHECK(message(a, b) == name + ": velocity is not finite"); });
    for (const T bad : {limits::quiet_NaN(), limits::signaling_NaN(), limits::infinity(), -limits::infinity()}) {
        tried.radius = bad;
        CHECK(message(a, b) == name + ": radius is not finite");
    }
    for (const T bad : {T(-1), -limits::denorm_min(), limits::lowest()}) {
        tried.radius = bad;
        CHECK(message(a, b) == name + ": radius is negative");
    }
    for (const T good : {T(0), -T(0), limits::max(), limits::denorm_min()}) {
        tried.radius = good;
        CHECK(message(a, b) == "");
    }
    tried.radius = T(1);
    for (const T mass : {T(0), T(-1), limits::infinity(), limits::quiet_NaN()}) { // decisions ignore the mass
        tried.mass = mass;
        CHECK(message(a, b) == "");
    }
    tried.mass = T(1);
}

template <int N, class T>
void check_each_field() {
    auto a = good_ball<N, T>(5);
    auto b = good_ball<N, T>(1);
    CHECK(message(a, b) == "");
    check_ball(a, "ball a", a, b);
    check_ball(b, "ball b", a, b);

    graze::plane<N, T> p{filled<N, T>(0), filled<N, T>(1)};
    CHECK(message(a, p) == "");
    check_ball(a, "ball", a, p);
    each_bad(p.point, [&] { CHECK(message(a, p) == "plane: point is not finite"); });
    each_bad(p.normal, [&] { CHECK(message(a, p) == "plane: normal is not finite"); });
    p.normal = {};
    p.normal[1] = -T(0);
    CHECK(message(a, p) == "plane: normal is zero");
    p.normal[1] = std::numeric_limits<T>::denorm_min();
    CHECK(message(a, p) == "");

    auto w = good_wall<N, T>();
    CHECK(message(a, w) == "");
    check_ball(a, "ball", a, w);
    each_bad(w.corner, [&] { CHECK(message(a, w) == "wall: corner is not finite"); });
    for (auto& e : w.edge) {
        each_bad(e, [&] { CHECK(message(a, w) == "wall: edge is not finite"); });
        const auto good = e;
        e = {};
        e[0] = -T(0);
        CHECK(message(a, w) == "wall: edge is zero");
        e = good;
    }
}

template <class T>
void check_parallel_edges() {
    const auto a = good_ball<3, T>(5);
    auto w = good_wall<3, T>();
    for (const int factor : {1, -1, 3}) {
        w.edge[1] = T(factor) * w.edge[0];
        CHECK(message(a, w) == "wall: edges are parallel");
        w.edge[0] = {{T(1), T(2), T(3)}};
        w.edge[1] = T(factor) * w.edge[0];
        CHECK(message(a, w) == "wall: edges are parallel");
    }
}

// A number of any kind, including bad ones.
double any_number() {
    using limits = std::numeric_limits<double>;
    const int which = property::in_range(0, 30);
    if (which == 0) {
        return property::one_of(limits::quiet_NaN(), limits::infinity(), -limits::infinity(), limits::max(),
                                limits::lowest(), limits::denorm_min(), -0.0);
    }
    return which < 5 ? std::bit_cast<double>(property::any<std::uint64_t>()) : property::in_range(-2, 10);
}
template <int N>
graze::vec<N, double> any_vector() {
    return graze::make_vec<N>([](int) { return any_number(); });
}
template <int N>
graze::ball<N, double> any_ball() {
    return {any_vector<N>(), any_vector<N>(), any_number(), any_number()};
}

template <class A, class B>
void check_told(const A& a, const B& b) {
    const faults::list all = faults::of(a, b);
    auto decided_by = graze::stage::filter;
    property::tag_if(!all.empty(), "bad");
    PROPERTY_ASSERT(faults::told(all, [&] { (void)answers::encounter_of(a, b, decided_by); }));
    PROPERTY_ASSERT(faults::told(all, [&] { (void)answers::overlap_of(a, b, decided_by); }));
    PROPERTY_ASSERT(faults::told(all, [&] { (void)answers::time_of(a, b); }));
    const std::string thrown = faults::thrown_by([&] { (void)answers::encounter_of(a, b, decided_by); });
    PROPERTY_ASSERT(told_without_exceptions(a, b) == thrown);
    if (all.empty()) {
        PROPERTY_ASSERT(*graze::try_classify(a, b) == answers::encounter_of(a, b, decided_by));
    }
}

template <int N>
void check_any() {
    CHECK(property::check("two balls", [] { check_told(any_ball<N>(), any_ball<N>()); }));
    CHECK(property::check("a ball and a plane", [] {
        check_told(any_ball<N>(), graze::plane<N, double>{any_vector<N>(), any_vector<N>()});
    }));
    CHECK(property::check("a ball and a wall", [] {
        graze::wall<N, double> w{any_vector<N>(), {}};
        for (auto& e : w.edge) {
            e = any_vector<N>();
        }
        check_told(any_ball<N>(), w);
    }));
}

} // namespace

TEST_CASE("A bad number is named by its argument and field") {
    check_each_field<2, double>();
    check_each_field<3, double>();
    check_parallel_edges<double>();
}

TEST_CASE("A bad number never yields an answer, whatever the others are") {
    check_any<2>();
    check_any<3>();
}
