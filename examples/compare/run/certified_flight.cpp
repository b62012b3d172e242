#include "certified_flight.hpp"

#include <algorithm>
#include <utility>

namespace compare::run {

namespace {

template <int N, class Is>
bool all_of(const graze::flight<N, certified>& a, Is is) {
    const auto &x = a.state.position, &u = a.state.velocity;
    return is(a.since) && std::all_of(x.component, x.component + N, is) &&
           std::all_of(u.component, u.component + N, is);
}

bool is_rational(const certified& x) { return x.is_rational(); }

template <int N>
bool are_rational(const graze::vec<N, certified>& x) {
    return std::all_of(x.component, x.component + N, is_rational);
}

template <int N>
integer_line<N> line_of(const certified_flight<N>& a) {
    if (a.line) {
        return *a.line;
    }
    graze::vec<N, mpq_class> place{}, speed{};
    mpz_class denominator = 1;
    for (int i = 0; i < N; ++i) {
        speed[i] = a.state.velocity[i].rational();
        place[i] = a.state.position[i].rational() - speed[i] * a.since.rational();
        denominator = lcm(denominator, lcm(speed[i].get_den(), place[i].get_den()));
    }
    integer_line<N> line{denominator, {}, {}, {a.since.rational().get_num(), a.since.rational().get_den()}};
    for (int i = 0; i < N; ++i) {
        line.place[i] = place[i].get_num() * (denominator / place[i].get_den());
        line.speed[i] = speed[i].get_num() * (denominator / speed[i].get_den());
    }
    return line;
}

// Makes a follow the line, with enclosures of its numbers. A fast ball's place at t = 0 is far off: hence the extra
// bits.
template <int N>
void follow(certified_flight<N>& a, integer_line<N> line) {
    const long bits = a.state.radius.bits();
    const certified since = certified::quotient(line.since.numerator, line.since.denominator, bits + 64);
    for (int i = 0; i < N; ++i) {
        const certified place = certified::quotient(line.place[i], line.denominator, bits + 64);
        const certified speed = certified::quotient(line.speed[i], line.denominator, bits + 64);
        a.state.position[i] = (place + speed * since).at(bits);
        a.state.velocity[i] = speed.at(bits);
    }
    a.since = since.at(bits);
    a.line = std::make_shared<const integer_line<N>>(std::move(line));
}

mpq_class inverse_of(const certified& mass) { return (certified(1) / mass).rational(); }

template <int N>
bool can_be_a_line(const certified_flight<N>& a) {
    return (a.line || all_of<N>(a, is_rational)) && a.state.radius.is_rational();
}

} // namespace

template <int N>
bool is_exact(const certified_flight<N>& a) {
    return a.line || all_of<N>(a, [](const certified& x) { return x.is_exact(); });
}

template <int N>
certified_flight<N> exactly(const certified_flight<N>& a) {
    if (!a.line) {
        return a;
    }
    const auto quotient = [&](const mpz_class& x, const mpz_class& y) {
        mpq_class q(x, y);
        q.canonicalize();
        return certified(std::move(q), a.state.radius.bits());
    };
    certified_flight<N> rational(a);
    rational.line.reset();
    rational.since = quotient(a.line->since.numerator, a.line->since.denominator);
    for (int i = 0; i < N; ++i) {
        rational.state.velocity[i] = quotient(a.line->speed[i], a.line->denominator);
        rational.state.position[i] =
            quotient(a.line->place[i], a.line->denominator) + rational.state.velocity[i] * rational.since;
    }
    return rational;
}

template <int N>
void shorten(certified_flight<N>& a) {
    const auto is_short = [](const certified& x) { return x.is_rational() && x.length() <= long_rational; };
    if (!a.line && all_of<N>(a, is_rational) && !all_of<N>(a, is_short)) {
        follow<N>(a, line_of<N>(a));
    }
}

template <int N>
bool bounce_long(certified_flight<N>& a, certified_flight<N>& b) {
    if ((!a.line && !b.line) || !can_be_a_line<N>(a) || !can_be_a_line<N>(b)) {
        return false;
    }
    integer_line<N> x = line_of<N>(a), y = line_of<N>(b);
    const mpq_class inverse_a = inverse_of(a.state.mass), inverse_b = inverse_of(b.state.mass);
    if (!bounce_head_on<N>(x, y, mpq_class(a.state.radius.rational() + b.state.radius.rational()), inverse_a,
                           inverse_b)) {
        return false;
    }
    if (sgn(inverse_a) != 0) {
        follow<N>(a, std::move(x));
    }
    if (sgn(inverse_b) != 0) {
        follow<N>(b, std::move(y));
    }
    return true;
}

template <int N>
bool bounce_long(certified_flight<N>& a, const graze::plane<N, certified>& p) {
    if (!a.line || !can_be_a_line<N>(a) || !are_rational<N>(p.point) || !are_rational<N>(p.normal)) {
        return false;
    }
    const auto rational = [](const graze::vec<N, certified>& x) {
        return graze::make_vec<N>([&](int i) { return x[i].rational(); });
    };
    integer_line<N> x = *a.line;
    if (!bounce_off<N>(x, a.state.radius.rational(), rational(p.point), rational(p.normal))) {
        return false;
    }
    follow<N>(a, std::move(x));
    return true;
}

template bool is_exact(const certified_flight<2>&);
template bool is_exact(const certified_flight<3>&);
template certified_flight<2> exactly(const certified_flight<2>&);
template certified_flight<3> exactly(const certified_flight<3>&);
template void shorten(certified_flight<2>&);
template void shorten(certified_flight<3>&);
template bool bounce_long(certified_flight<2>&, certified_flight<2>&);
template bool bounce_long(certified_flight<3>&, certified_flight<3>&);
template bool bounce_long(certified_flight<2>&, const graze::plane<2, certified>&);
template bool bounce_long(certified_flight<3>&, const graze::plane<3, certified>&);

} // namespace compare::run
