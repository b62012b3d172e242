#include "integer_line.hpp"

#include <utility>

namespace compare::run {

namespace {

template <int N>
void scale(integer_line<N>& a, const mpz_class& factor) {
    if (factor == 1) {
        return;
    }
    a.denominator *= factor;
    for (int i = 0; i < N; ++i) {
        a.place[i] *= factor;
        a.speed[i] *= factor;
    }
}

// Gives both the same denominator.
template <int N>
void join(integer_line<N>& a, integer_line<N>& b) {
    if (a.denominator == b.denominator) {
        return;
    }
    const mpz_class common = lcm(a.denominator, b.denominator);
    scale(a, mpz_class(common / a.denominator));
    scale(b, mpz_class(common / b.denominator));
}

// x times the denominator of a, which is b's too if b is given. Scales both lines so that it is an integer.
template <int N>
mpz_class in_units_of(const mpq_class& x, integer_line<N>& a, integer_line<N>* b) {
    if (mpz_divisible_p(a.denominator.get_mpz_t(), x.get_den_mpz_t()) == 0) {
        scale(a, x.get_den());
        if (b != nullptr) {
            scale(*b, x.get_den());
        }
    }
    mpz_class units;
    mpz_divexact(units.get_mpz_t(), a.denominator.get_mpz_t(), x.get_den_mpz_t());
    return units * x.get_num();
}

} // namespace

template <int N>
bool bounce_head_on(integer_line<N>& first, integer_line<N>& second, const mpq_class& reach, const mpq_class& inverse_a,
                    const mpq_class& inverse_b) {
    integer_line<N> a(first), b(second);
    join(a, b);
    int axis = -1;
    for (int i = 0; i < N; ++i) {
        if (a.speed[i] != b.speed[i]) {
            if (axis >= 0) {
                return false;
            }
            axis = i;
        }
    }
    for (int i = 0; i < N; ++i) {
        if (i != axis && (axis < 0 || a.place[i] != b.place[i])) {
            return false;
        }
    }
    mpz_class distance = in_units_of(reach, a, &b);
    const mpz_class closing = a.speed[axis] - b.speed[axis]; // when they touch, a is behind b by the reach
    if (sgn(closing) < 0) {
        distance = -distance;
    }
    const mpz_class apart = a.place[axis] - b.place[axis] + distance; // apart + closing t is 0 at the contact
    const mpq_class all = inverse_a + inverse_b;
    const mpq_class share_a = 2 * inverse_a / all, share_b = 2 * inverse_b / all; // their sum is 2: of one denominator
    a.since = b.since = {sgn(closing) < 0 ? apart : mpz_class(-apart), mpz_class(abs(closing))};
    scale(a, share_a.get_den());
    scale(b, share_a.get_den());
    a.place[axis] -= share_a.get_num() * apart;
    a.speed[axis] -= share_a.get_num() * closing;
    b.place[axis] += share_b.get_num() * apart;
    b.speed[axis] += share_b.get_num() * closing;
    first = std::move(a);
    second = std::move(b);
    return true;
}

template <int N>
bool bounce_off(integer_line<N>& a, const mpq_class& r, const graze::vec<N, mpq_class>& point,
                const graze::vec<N, mpq_class>& normal) {
    int axis = -1;
    for (int i = 0; i < N; ++i) {
        if (sgn(normal[i]) != 0) {
            if (axis >= 0) {
                return false;
            }
            axis = i;
        }
    }
    const int direction = axis < 0 ? 0 : sgn(a.speed[axis]);
    if (direction == 0) {
        return false;
    }
    const mpz_class touch = in_units_of<N>(mpq_class(point[axis] - direction * r), a, nullptr);
    const mpz_class way = touch - a.place[axis];
    a.since = {direction < 0 ? mpz_class(-way) : way, mpz_class(abs(a.speed[axis]))};
    a.place[axis] = touch + way;
    a.speed[axis] = -a.speed[axis];
    return true;
}

template bool bounce_head_on(integer_line<2>&, integer_line<2>&, const mpq_class&, const mpq_class&, const mpq_class&);
template bool bounce_head_on(integer_line<3>&, integer_line<3>&, const mpq_class&, const mpq_class&, const mpq_class&);
template bool bounce_off(integer_line<2>&, const mpq_class&, const graze::vec<2, mpq_class>&,
                         const graze::vec<2, mpq_class>&);
template bool bounce_off(integer_line<3>&, const mpq_class&, const graze::vec<3, mpq_class>&,
                         const graze::vec<3, mpq_class>&);

} // namespace compare::run
