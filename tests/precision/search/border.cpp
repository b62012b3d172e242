#include "border.hpp"

#include <algorithm>
#include <cmath>

namespace search {

namespace {

using graze::precision::answer;
using oracle::encounter;
using oracle::feature;
using oracle::piece;

template <int N>
using rational_point = std::array<mpq_class, static_cast<std::size_t>(N)>;

template <int N>
mpq_class product(const rational_point<N>& x, const rational_point<N>& y) {
    mpq_class sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sum += x[i] * y[i];
    }
    return sum;
}

mpq_class quotient(const mpz_class& x, const mpz_class& y) {
    mpq_class q(x, y);
    q.canonicalize();
    return q;
}

mpq_class square_of(const mpq_class& x) { return x * x; }

// The least value of piece / k over the times t >= 0 at which it holds.
std::optional<mpq_class> least_of(const piece& p) {
    const mpq_class from = p.low && *p.low > 0 ? *p.low : mpq_class(0);
    if (p.never || (p.high && *p.high < from)) {
        return std::nullopt;
    }
    mpq_class t = from;
    if (p.a != 0) {
        t = std::max(from, quotient(-p.h, p.a));
        t = p.high ? std::min(t, *p.high) : t;
    }
    return mpq_class((mpq_class(p.a) * t * t + 2 * mpq_class(p.h) * t + p.c) / p.k);
}

// The time at which the centre goes through the face.
std::optional<mpq_class> crossing(const piece& face) {
    if (face.never || face.a == 0) {
        return std::nullopt;
    }
    const mpq_class t = quotient(-face.h, face.a);
    const bool is_ahead = t > 0 && !(face.low && t < *face.low) && !(face.high && t > *face.high);
    return is_ahead ? std::optional(t) : std::nullopt;
}

template <int N>
oracle::answer meet(const precision::pair<N>& p) {
    return std::visit([&](const auto& other) { return oracle::meet(p.a, other); }, p.other);
}

// For a wall or a triangle; empty for a ball or a plane.
template <int N>
std::vector<graze::vec<N, double>> corner_and_edges(const precision::pair<N>& p) {
    std::vector<graze::vec<N, double>> all;
    std::visit(
        [&](const auto& w) {
            if constexpr (requires { w.corner; }) {
                all.push_back(w.corner);
                all.insert(all.end(), w.edge.begin(), w.edge.end());
            }
        },
        p.other);
    return all;
}

} // namespace

template <int N>
struct borders<N>::affine {
    rational_point<N> at, by;

    [[nodiscard]] affine minus(const affine& other) const {
        affine d = *this;
        for (std::size_t i = 0; i < d.at.size(); ++i) {
            d.at[i] -= other.at[i];
            d.by[i] -= other.by[i];
        }
        return d;
    }
    [[nodiscard]] mpq_class square_at(const mpq_class& t) const {
        return product<N>(at, at) + 2 * t * product<N>(at, by) + t * t * product<N>(by, by);
    }
    [[nodiscard]] mpq_class square_at(const oracle::surd& t) const {
        const mpq_class p = quotient(t.p, t.r), q = quotient(t.q, t.r), ab = product<N>(at, by);
        const mpq_class bb = product<N>(by, by);
        const mpq_class rational = square_at(p) + bb * q * q * t.d, root = 2 * q * (ab + bb * p);
        const mpz_class whole = rational.get_den() * root.get_den();
        return oracle::approximate(
            {rational.get_num() * root.get_den(), root.get_num() * rational.get_den(), t.d, whole});
    }
};

template <int N>
borders<N>::borders(const precision::pair<N>& p) : is_triangle_(p.other.index() == 3), met_(meet(p)) {
    // Uses the units of the pieces, since it lifts the same numbers.
    oracle::groups<double> g;
    oracle::collect<N>(g.lengths, p.a.position);
    g.lengths.collect(p.a.radius);
    oracle::collect<N>(g.velocities, p.a.velocity);
    const auto* ball = std::get_if<graze::ball<N, double>>(&p.other);
    const auto* plane = std::get_if<graze::plane<N, double>>(&p.other);
    const std::vector<graze::vec<N, double>> flat = corner_and_edges(p);
    oracle::collect<N>(g.lengths, ball != nullptr ? ball->position : plane != nullptr ? plane->point : flat.front());
    if (ball != nullptr) {
        g.lengths.collect(ball->radius);
        oracle::collect<N>(g.velocities, ball->velocity);
    }
    for (std::size_t i = 1; i < flat.size(); ++i) {
        oracle::collect<N>(g.lengths, flat[i]);
    }
    w_ = oracle::next<N>(g.lengths);
    mpz_class r = g.lengths.next();
    u_ = oracle::next<N>(g.velocities);
    w_ = w_ - oracle::next<N>(g.lengths);
    if (ball != nullptr) {
        r += g.lengths.next();
        u_ = u_ - oracle::next<N>(g.velocities);
    }
    mpz_class square = oracle::dot<N>(w_, w_) + r * r;
    for (std::size_t i = 1; i < flat.size(); ++i) {
        edges_.push_back(oracle::next<N>(g.lengths));
        square += oracle::dot<N>(edges_.back(), edges_.back());
    }
    length_square_ = square;

    const auto by = [](const mpq_class& x, const mpq_class& y) { return y == 0 ? mpq_class(0) : mpq_class(x / y); };
    const piece* closest = nullptr;
    for (const piece& one : met_.pieces) {
        if (one.holds_now() && (closest == nullptr || one.c * closest->k < closest->c * one.k)) {
            closest = &one;
        }
    }
    const mpz_class speed_square = oracle::dot<N>(u_, u_);
    receding_ = by(square_of(quotient(closest->h, closest->k)), length_square_ * speed_square);
    overlapping_ = by(square_of(quotient(closest->c, closest->k)), square_of(length_square_));
    hitting_ = 1;
    if (plane == nullptr) {
        const mpq_class f = least_ahead() - (!flat.empty() && crossing(met_.pieces.front()) ? mpq_class(r * r) : 0);
        hitting_ = by(square_of(f), square_of(length_square_));
        ahead_ = f > 0 ? encounter::miss : f == 0 ? encounter::graze : encounter::hit;
        if (met_.what != encounter::recede && met_.what != encounter::overlap) {
            ahead_ = met_.what; // a point that goes through a wall's rim is a hit
        }
    }
}

template <int N>
mpq_class borders<N>::least_ahead() const {
    if (const auto t = edges_.empty() ? std::nullopt : crossing(met_.pieces.front())) {
        const affine centre = foot_on(met_.pieces.front());
        std::optional<mpq_class> rim;
        for (const piece& p : met_.pieces) {
            if (p.where == (N == 2 ? feature::corner : feature::edge)) {
                const mpq_class square = centre.minus(foot_on(p)).square_at(*t);
                rim = rim ? std::min(*rim, square) : square;
            }
        }
        return -*rim;
    }
    std::optional<mpq_class> least;
    for (const piece& p : met_.pieces) {
        if (const auto one = least_of(p)) {
            least = least ? std::min(*least, *one) : *one;
        }
    }
    return least.value();
}

// The feature of a wall, relative to the wall's corner.
template <int N>
typename borders<N>::affine borders<N>::foot_on(const piece& of) const {
    const auto rational = [](const oracle::point<N>& x) {
        rational_point<N> y;
        std::ranges::copy(x.component, y.begin());
        return y;
    };
    const auto along = [&](const oracle::point<N>& x, const oracle::point<N>& e) {
        const mpq_class share = quotient(oracle::dot<N>(x, e), oracle::dot<N>(e, e));
        rational_point<N> y = rational(e);
        for (mpq_class& component : y) {
            component *= share;
        }
        return y;
    };
    const oracle::point<N> origin = w_ - w_;
    if (of.where == feature::corner) {
        oracle::point<N> corner = of.index % 2 == 1 ? edges_[0] : origin;
        corner = of.index >= 2 ? corner + edges_[1] : corner;
        return {rational(corner), rational(origin)};
    }
    if constexpr (N == 2) {
        return {along(w_, edges_[0]), along(u_, edges_[0])};
    } else {
        if (of.where == feature::edge) {
            const auto i = static_cast<std::size_t>(of.index / 2);
            const oracle::point<N> from = of.index % 2 == 1 ? edges_[i] : origin;
            const bool is_slanted = is_triangle_ && of.index == 1;
            const oracle::point<N> edge = is_slanted ? edges_[1] - edges_[0] : edges_[1 - i];
            affine f{along(w_ - from, edge), along(u_, edge)};
            for (std::size_t k = 0; k < N; ++k) {
                f.at[k] += from[k];
            }
            return f;
        }
        oracle::point<N> normal;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
            normal[k] = edges_[0][l] * edges_[1][m] - edges_[0][m] * edges_[1][l];
        }
        return affine{rational(w_), rational(u_)}.minus({along(w_, normal), along(u_, normal)});
    }
}

template <int N>
mpq_class borders<N>::square_to(encounter given) const {
    mpq_class farthest = 0;
    const auto crossed = [&](bool is_right, const mpq_class& square) {
        farthest = is_right ? farthest : std::max(farthest, square);
    };
    if (given == encounter::recede) {
        crossed(met_.what == encounter::recede, receding_);
        return farthest;
    }
    crossed(met_.what != encounter::recede, receding_);
    if (given == encounter::overlap) {
        crossed(met_.overlaps, overlapping_);
        return farthest;
    }
    crossed(!met_.overlaps, overlapping_);
    crossed(given == ahead_, hitting_);
    return farthest;
}

template <int N>
bool borders<N>::tells_feature(const answer& given) const {
    return given.where && met_.pieces.size() > 1 && oracle::is_collision(met_.what);
}

template <int N>
mpq_class borders<N>::square_to_feature(const piece& other) const {
    const piece& touched =
        met_.piece_of(met_.where(), met_.face ? 0 : std::countr_zero(met_.edges != 0 ? met_.edges : met_.corners));
    const affine apart = foot_on(other).minus(foot_on(touched));
    if (met_.what == encounter::overlap) {
        return apart.square_at(mpq_class(0)) / length_square_;
    }
    return apart.square_at(touched.root().value()) / length_square_;
}

template <int N>
std::optional<mpq_class> borders<N>::square_to_feature(const answer& given) const {
    std::optional<mpq_class> nearest;
    for (const piece& p : met_.pieces) {
        if (p.where == static_cast<feature>(*given.where) &&
            (given.index == graze::precision::index_unknown || given.index == p.index)) {
            if (met_.has(p.where, p.index)) {
                return std::nullopt;
            }
            const mpq_class square = square_to_feature(p);
            nearest = nearest ? std::min(*nearest, square) : square;
        }
    }
    return nearest ? nearest : mpq_class(1); // 1 if there is no such feature
}

template <int N>
std::optional<mpq_class> borders<N>::square_to(const answer& given) const {
    const bool collides = oracle::is_collision(met_.what);
    if (given.what) {
        const auto what = static_cast<encounter>(*given.what);
        if (what != met_.what) {
            return square_to(what);
        }
    } else if (given.values.empty()) {
        return collides ? std::optional(std::min(square_to(encounter::recede), square_to(encounter::miss)))
                        : std::nullopt;
    } else if (!collides) {
        return std::min({square_to(encounter::overlap), square_to(encounter::graze), square_to(encounter::hit)});
    }
    return tells_feature(given) ? square_to_feature(given) : std::nullopt;
}

template <int N>
mpq_class borders<N>::least_square(const answer& given) const {
    mpq_class least = std::min({receding_, overlapping_, hitting_});
    for (const piece& p : met_.pieces) {
        if (tells_feature(given) && !met_.has(p.where, p.index)) {
            least = std::min(least, square_to_feature(p));
        }
    }
    return least;
}

template class borders<2>;
template class borders<3>;

double bits_of_root(const mpq_class& x) {
    long above = 0, below = 0;
    double share = mpz_get_d_2exp(&above, x.get_num_mpz_t()) / mpz_get_d_2exp(&below, x.get_den_mpz_t());
    long exponent = above - below;
    if (share < 1) {
        share *= 2;
        --exponent;
    }
    return (static_cast<double>(exponent) + (share - 1)) / 2;
}

double logarithm_from(double bits) {
    const double exponent = std::floor(2 * bits);
    return (exponent + std::log2(1 + (2 * bits - exponent))) / 2;
}

} // namespace search
