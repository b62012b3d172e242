// All answers of the library for flights, compiled once for all their tests.
#pragma once

#include "../oracle/flight.hpp"

#include <graze/contact/contact.hpp>
#include <graze/time/impact_time.hpp>

#include <compare>
#include <optional>

namespace flight_answers {

template <int N, class T, class Contact>
struct answer {
    graze::encounter what{};
    bool overlaps = false;
    graze::stage decided_by = graze::stage::filter; // `what`
    std::optional<graze::impact_time<N, T>> time;
    std::optional<Contact> contact;
    graze::stage given_by = graze::stage::filter; // `contact`
};
template <class B, int N, class T>
using answer_of =
    answer<N, T,
           std::conditional_t<std::is_same_v<B, graze::flight<N, T>>, graze::contact<N, T>, graze::wall_contact<N, T>>>;

template <int N, class T, class B>
answer_of<B, N, T> of(const graze::flight<N, T>& a, const B& b);

// The sign of the first time less the second; 3 if operators contradict each other.
template <int N, class T>
int order_of(const graze::impact_time<N, T>& x, const graze::impact_time<N, T>& y, graze::stage& decided_by);
template <int N, class T>
int order_of(const graze::impact_time<N, T>& x, const T& y);

// A time rounded to nearest, downward and upward.
template <class T>
struct rounded_time {
    T nearest, lower, upper;
};
template <int N, class T>
rounded_time<T> rounded(const graze::impact_time<N, T>& x);

} // namespace flight_answers
