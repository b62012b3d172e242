// The subjects "decide": a pair's encounter, and whether it overlaps.
#pragma once

#include "subject.hpp"

#include <graze/predicate/overlaps_of_shapes.hpp>

namespace environments {

template <partner P, int N, class T>
[[nodiscard]] reply decide(const std::uint64_t* bits) {
    const auto numbers = numbers_from<T, row_length(P, N)>(bits);
    return with_shapes<P, N>(numbers.data(), [](const auto& a, const auto& b) {
        reply r;
        const graze::encounter what = graze::classify(a, b, stage_counter{r});
        const bool overlaps = graze::overlaps(a, b, stage_counter{r});
        r.answer = 2 * static_cast<int>(what) + (overlaps ? 1 : 0);
        return r;
    });
}

template <partner P, int N, class T>
void add_decision(std::vector<subject>& subjects) {
    subjects.push_back({subject_name<N, T>("decide", name_of(P)), row_length(P, N), decide<P, N, T>});
}

} // namespace environments
