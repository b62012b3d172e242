// The subjects "order", of two collisions, and "against", of one and a time in T.
#include "subject.hpp"

#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

namespace environments {
namespace {

constexpr int no_collision = 100; // not an answer in the file

[[nodiscard]] int sign_of(std::partial_ordering o) { return o < 0 ? -1 : o > 0 ? 1 : o == 0 ? 0 : 2; }

template <partner P, int N, class T>
[[nodiscard]] auto time_of(const T* row) {
    return with_shapes<P, N>(row, [](const auto& a, const auto& b) { return graze::time_of_impact(a, b); });
}

// The comparison with an observer. <=>, the reverse and == must agree with it.
template <partner P, partner Q, int N, class T>
[[nodiscard]] reply order(const std::uint64_t* bits) {
    const auto numbers = numbers_from<T, row_length(P, N) + row_length(Q, N)>(bits);
    const auto x = time_of<P, N>(numbers.data());
    const auto y = time_of<Q, N>(numbers.data() + row_length(P, N));
    reply r;
    if (!x || !y) {
        r.answer = no_collision;
        return r;
    }
    r.answer = x->compare(*y, stage_counter{r});
    const bool agree =
        sign_of(*x <=> *y) == r.answer && sign_of(*y <=> *x) == -r.answer && (*x == *y) == (r.answer == 0) && *x == *x;
    r.answer = agree ? r.answer : 10 + r.answer;
    return r;
}

template <partner P, int N, class T>
[[nodiscard]] reply against(const std::uint64_t* bits) {
    const auto numbers = numbers_from<T, row_length(P, N) + 1>(bits);
    const auto x = time_of<P, N>(numbers.data());
    reply r;
    r.answer = x ? sign_of(*x <=> numbers.back()) : no_collision;
    if (x && (*x == numbers.back()) != (r.answer == 0)) {
        r.answer += 10;
    }
    return r;
}

template <int N, class T, partner... P>
void add_all(std::vector<subject>& subjects) {
    const auto add = [&]<partner Q>() {
        subjects.push_back({subject_name<N, T>("against", name_of(Q)), row_length(Q, N) + 1, against<Q, N, T>});
        (subjects.push_back({subject_name<N, T>("order", std::string(name_of(Q)) + '/' + name_of(P)),
                             row_length(Q, N) + row_length(P, N), order<Q, P, N, T>}),
         ...);
    };
    (add.template operator()<P>(), ...);
}

} // namespace

void add_times(std::vector<subject>& subjects) {
    using enum partner;
    if constexpr (level == 0) {
        add_all<2, double, ball, plane>(subjects);
    } else {
        add_all<2, double, ball, plane, wall>(subjects);
    }
    if constexpr (level == 1) {
        add_all<3, float, ball>(subjects);
    } else if constexpr (level >= 2) {
        add_all<3, double, ball, plane, wall>(subjects);
        add_all<2, float, ball, plane, wall>(subjects);
        add_all<3, float, ball, plane, wall>(subjects);
        add_all<2, std::int32_t, ball, plane, wall>(subjects);
        add_all<3, std::int32_t, ball, plane, wall>(subjects);
        add_all<2, std::int64_t, ball, plane, wall>(subjects);
        add_all<3, std::int64_t, ball, plane, wall>(subjects);
    }
}

} // namespace environments
