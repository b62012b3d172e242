// The square of the distance between a moving centre and a feature of a thing: a parabola that holds over an interval
// of time.
#pragma once

#include "lift.hpp"
#include "surd.hpp"

#include <optional>

namespace oracle {

enum class feature { face, edge, corner };

// a t² + 2 h t + c = k (distance² - r²), k > 0, while low <= t <= high (none: no end; low > high: never).
struct piece {
    mpz_class a, h, c, k = 1;

    mpz_class discriminant() const { return h * h - a * c; }

    feature where = feature::corner;
    int index = 0; // edges: 2i + far, corners: λ_0 + 2 λ_1
    std::optional<mpq_class> low, high;
    bool never = false;

    // Restricts it to the times at which 0 <= start + t·speed <= end.
    void only_within(const mpz_class& start, const mpz_class& speed, const mpz_class& end) {
        if (speed == 0) {
            never = never || start < 0 || start > end;
            return;
        }
        mpq_class from(-start, speed);
        mpq_class to(end - start, speed);
        from.canonicalize();
        to.canonicalize();
        if (from > to) {
            swap(from, to);
        }
        if (!low || from > *low) {
            low = from;
        }
        if (!high || to < *high) {
            high = to;
        }
        never = never || *low > *high;
    }

    bool holds_now() const { return !never && !(low && *low > 0) && !(high && *high < 0); }

    int sign_at(const mpq_class& t) const {
        const mpz_class& n = t.get_num();
        const mpz_class& m = t.get_den();
        return sgn(mpz_class((a * n + 2 * h * m) * n + c * m * m));
    }

    // The sign of the least value.
    int sign_of_minimum() const {
        if (never) {
            return 1;
        }
        if (a == 0) { // constant
            return sgn(c);
        }
        if (low && sgn(mpz_class(a * low->get_num() + h * low->get_den())) >= 0) {
            return sign_at(*low);
        }
        if (high && sgn(mpz_class(a * high->get_num() + h * high->get_den())) <= 0) {
            return sign_at(*high);
        }
        return sgn(mpz_class(a * c - h * h));
    }

    // The smaller root, if it lies in the interval.
    std::optional<surd> root() const {
        const mpz_class d = discriminant();
        if (never || a == 0 || d < 0) {
            return std::nullopt;
        }
        surd t{-h, -1, d, a};
        if ((low && compare(t, *low) < 0) || (high && compare(t, *high) > 0)) {
            return std::nullopt;
        }
        return t;
    }
};

template <int N>
piece corner_piece(const point<N>& w, const point<N>& u, const mpz_class& r, int index) {
    piece p;
    p.a = dot<N>(u, u);
    p.h = dot<N>(w, u);
    p.c = dot<N>(w, w) - r * r;
    p.index = index;
    return p;
}

// The straight edge from the origin along e.
template <int N>
piece edge_piece(const point<N>& w, const point<N>& u, const point<N>& e, const mpz_class& r, int index) {
    const mpz_class ee = dot<N>(e, e);
    const mpz_class we = dot<N>(w, e);
    const mpz_class ue = dot<N>(u, e);
    piece p;
    p.a = dot<N>(u, u) * ee - ue * ue;
    p.h = dot<N>(w, u) * ee - we * ue;
    p.c = (dot<N>(w, w) - r * r) * ee - we * we;
    p.k = ee;
    p.where = feature::edge;
    p.index = index;
    p.only_within(we, ue, ee);
    return p;
}

// height: of the centre above the plane, times √square.
inline piece plane_piece(const mpz_class& height, const mpz_class& speed, const mpz_class& square, const mpz_class& r) {
    piece p;
    p.a = speed * speed;
    p.h = height * speed;
    p.c = height * height - r * r * square;
    p.k = square;
    p.where = feature::face;
    return p;
}

} // namespace oracle
