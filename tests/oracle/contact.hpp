// Positions and velocities at the contact, in exact arithmetic. The normal is along the line of centres (or from the
// wall's closest point), and velocities change along it only, so that momentum and energy are conserved.
#pragma once

#include "encounter.hpp"
#include "field.hpp"

namespace oracle {

template <int N>
struct ball_contact {
    surd time;
    surd_vector<N> position_a, position_b, normal, velocity_a, velocity_b;
};

template <int N>
struct wall_contact {
    surd time;
    surd_vector<N> position, point, normal, velocity;
};

template <int N, class V>
surd_vector<N> exact_vector(const V& v) {
    surd_vector<N> x;
    for (int i = 0; i < N; ++i) {
        x[i] = rational(mpq_class(input(v[i])));
    }
    return x;
}

// The direction of x, whose squared length is rational and not 0.
template <int N>
surd_vector<N> unit(const surd_vector<N>& x) {
    const mpq_class square = rational_value(dot(x, x));
    const mpz_class product = square.get_num() * square.get_den();
    const mpz_class root = sqrt(product);
    if (root * root == product) {
        return rational(1 / mpq_class(root, square.get_den())) * x;
    }
    return (square_root(square) / square) * x; // for a rational x only: the root is over another radicand than x's
}

// inverse_a, inverse_b: of the masses. The answer is that of meet(a, b), a collision.
template <int N, class T>
ball_contact<N> contact(const graze::ball<N, T>& a, const graze::ball<N, T>& b, const mpq_class& inverse_a,
                        const mpq_class& inverse_b, const answer& met) {
    ball_contact<N> c;
    c.time = met.time.value();
    const auto ua = exact_vector<N>(a.velocity);
    const auto ub = exact_vector<N>(b.velocity);
    c.position_a = exact_vector<N>(a.position) + c.time * ua;
    c.position_b = exact_vector<N>(b.position) + c.time * ub;
    c.velocity_a = ua;
    c.velocity_b = ub;
    const auto apart = c.position_a - c.position_b;
    const surd square = dot(apart, apart);
    if (sign_of(square) == 0) {
        return c; // two points
    }
    c.normal = unit(apart);
    if (met.what != encounter::graze) {
        const surd change = rational(2) * dot(ua - ub, apart) / rational_value(square) / (inverse_a + inverse_b);
        c.velocity_a = ua - (rational(inverse_a) * change) * apart;
        c.velocity_b = ub + (rational(inverse_b) * change) * apart;
    }
    return c;
}

// v mirrored in the plane with this normal.
template <int N>
surd_vector<N> mirrored(const surd_vector<N>& v, const surd_vector<N>& normal) {
    return v - (rational(2) * dot(v, normal) / rational_value(dot(normal, normal))) * normal;
}

// A ball that touches a plane through p, with this normal.
template <int N, class T>
wall_contact<N> contact_with_face(const graze::ball<N, T>& b, const surd_vector<N>& p, const surd_vector<N>& normal,
                                  const answer& met) {
    wall_contact<N> c;
    const auto x = exact_vector<N>(b.position);
    const auto u = exact_vector<N>(b.velocity);
    const mpq_class height = rational_value(dot(x - p, normal));
    const mpq_class speed = rational_value(dot(u, normal));
    const mpq_class square = rational_value(dot(normal, normal));
    const surd length = square_root(square);
    if (met.what == encounter::hit) {
        c.time = (rational(abs(height)) - rational(mpq_class(input(b.radius))) * length) / abs(speed);
        if (compare(c.time, met.time.value()) != 0) {
            throw std::logic_error("oracle: two times of a face");
        }
    }
    c.position = x + c.time * u;
    c.point = c.position - (dot(c.position - p, normal) / square) * normal;
    c.normal = (rational(sgn(height)) * length / square) * normal;
    c.velocity = mirrored(u, normal);
    return c;
}

template <int N, class T>
wall_contact<N> contact(const graze::ball<N, T>& b, const graze::plane<N, T>& p, const answer& met) {
    return contact_with_face(b, exact_vector<N>(p.point), exact_vector<N>(p.normal), met);
}

// where, index: any one of the features that are met.
template <int N, class T, class Wall>
wall_contact<N> contact(const graze::ball<N, T>& b, const Wall& wall, const answer& met, feature where, int index) {
    surd_vector<N> corner = exact_vector<N>(wall.corner);
    const auto e0 = exact_vector<N>(wall.edge[0]);
    const auto e1 = exact_vector<N>(wall.edge[N - 2]);
    if (where == feature::face) {
        surd_vector<N> normal;
        if constexpr (N == 2) {
            normal[0] = e0[1];
            normal[1] = -e0[0];
        } else {
            for (int i = 0; i < 3; ++i) {
                const int j = (i + 1) % 3, k = (i + 2) % 3;
                normal[i] = e0[j] * e1[k] - e0[k] * e1[j];
            }
        }
        return contact_with_face(b, corner, normal, met);
    }
    wall_contact<N> c;
    c.time = met.time.value();
    const auto u = exact_vector<N>(b.velocity);
    c.position = exact_vector<N>(b.position) + c.time * u;
    if (where == feature::edge) {
        constexpr bool is_triangle = std::is_same_v<Wall, graze::triangle<T>>;
        const auto along = is_triangle && index == 1 ? e1 - e0 : index / 2 == 0 ? e1 : e0;
        if (index % 2 != 0) {
            corner = corner + (index / 2 == 0 ? e0 : e1);
        }
        c.point = corner + (dot(c.position - corner, along) / rational_value(dot(along, along))) * along;
    } else {
        c.point = corner + rational(index & 1) * e0 + rational(N == 3 ? index >> 1 : 0) * e1;
    }
    c.velocity = u;
    const auto apart = c.position - c.point;
    if (sign_of(dot(apart, apart)) != 0) {
        c.normal = unit(apart);
        if (met.what != encounter::graze) {
            c.velocity = mirrored(u, apart);
        }
    }
    return c;
}

} // namespace oracle
