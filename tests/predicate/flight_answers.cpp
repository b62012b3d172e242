#include "flight_answers.hpp"

#include <graze/collide.hpp>
#include <graze/overlaps.hpp>
#include <graze/time_of_impact.hpp>

namespace flight_answers {

template <int N, class T, class B>
answer_of<B, N, T> of(const graze::flight<N, T>& a, const B& b) {
    answer_of<B, N, T> r;
    const auto note = [](graze::stage& told) { return [&told](graze::stage s) { told = s; }; };
    r.what = graze::classify(a, b, note(r.decided_by));
    r.overlaps = graze::overlaps(a, b);
    r.time = graze::time_of_impact(a, b);
    r.contact = graze::collide(a, b, note(r.given_by));
    return r;
}

namespace {

int sign_of(std::partial_ordering o) { return o < 0 ? -1 : o > 0 ? 1 : o == 0 ? 0 : 2; }

} // namespace

template <int N, class T>
int order_of(const graze::impact_time<N, T>& x, const graze::impact_time<N, T>& y, graze::stage& decided_by) {
    const int sign = x.compare(y, [&](graze::stage s) { decided_by = s; });
    return (x == y) == (sign == 0) && sign_of(x <=> y) == sign ? sign : 3;
}
template <int N, class T>
int order_of(const graze::impact_time<N, T>& x, const T& y) {
    const int sign = sign_of(x <=> y);
    return (x == y) == (sign == 0) ? sign : 3;
}
template <int N, class T>
rounded_time<T> rounded(const graze::impact_time<N, T>& x) {
    return {static_cast<T>(x), x.lower(), x.upper()};
}

#define GRAZE_INSTANTIATE(N, T)                                                                                        \
    template answer_of<graze::flight<N, T>, N, T> of(const graze::flight<N, T>&, const graze::flight<N, T>&);          \
    template answer_of<graze::plane<N, T>, N, T> of(const graze::flight<N, T>&, const graze::plane<N, T>&);            \
    template answer_of<graze::wall<N, T>, N, T> of(const graze::flight<N, T>&, const graze::wall<N, T>&);              \
    template int order_of(const graze::impact_time<N, T>&, const graze::impact_time<N, T>&, graze::stage&);            \
    template int order_of(const graze::impact_time<N, T>&, const T&);                                                  \
    template rounded_time<T> rounded(const graze::impact_time<N, T>&);

GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)
GRAZE_INSTANTIATE(2, float)

} // namespace flight_answers
