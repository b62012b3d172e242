// All answers of the library about a pair that collides, compiled once for all tests of contacts.
#pragma once

#include <graze/contact/contact.hpp>
#include <graze/pair/stage.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>
#include <graze/time_of_impact.hpp>

#include <optional>

namespace answers {

// collide's contact, the stage that gave it, and time_of_impact's time.
template <int N, class T, class Contact>
struct answer {
    std::optional<Contact> contact;
    graze::stage given_by = graze::stage::filter;
    std::optional<graze::impact_time<N, T>> time;
};

template <int N, class T>
answer<N, T, graze::contact<N, T>> of(const graze::ball<N, T>& a, const graze::ball<N, T>& b);
template <int N, class T>
answer<N, T, graze::wall_contact<N, T>> of(const graze::ball<N, T>& b, const graze::plane<N, T>& p);
template <int N, class T>
answer<N, T, graze::wall_contact<N, T>> of(const graze::ball<N, T>& b, const graze::wall<N, T>& w);
template <class T>
answer<3, T, graze::wall_contact<3, T>> of(const graze::ball<3, T>& b, const graze::triangle<T>& t);

} // namespace answers
