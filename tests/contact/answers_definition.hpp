// The definition of answers::of, instantiated once for each dimension and type.
#pragma once

#include "answers.hpp"

#include <graze/collide.hpp>
#include <graze/time_of_impact.hpp>

namespace answers {

template <class Answer, class A, class B>
Answer all(const A& a, const B& b) {
    Answer r;
    r.contact = graze::collide(a, b, [&](graze::stage s) { r.given_by = s; });
    r.time = graze::time_of_impact(a, b);
    return r;
}

template <int N, class T>
answer<N, T, graze::contact<N, T>> of(const graze::ball<N, T>& a, const graze::ball<N, T>& b) {
    return all<answer<N, T, graze::contact<N, T>>>(a, b);
}
template <int N, class T>
answer<N, T, graze::wall_contact<N, T>> of(const graze::ball<N, T>& b, const graze::plane<N, T>& p) {
    return all<answer<N, T, graze::wall_contact<N, T>>>(b, p);
}
template <int N, class T>
answer<N, T, graze::wall_contact<N, T>> of(const graze::ball<N, T>& b, const graze::wall<N, T>& w) {
    return all<answer<N, T, graze::wall_contact<N, T>>>(b, w);
}

template <class T>
answer<3, T, graze::wall_contact<3, T>> of(const graze::ball<3, T>& b, const graze::triangle<T>& t) {
    return all<answer<3, T, graze::wall_contact<3, T>>>(b, t);
}

} // namespace answers
