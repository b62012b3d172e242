#include "truth.hpp"

#include <algorithm>

namespace precision {

const mpq_class& exact_number::to(int bits) const {
    constexpr unsigned long precisions[] = {192, 512};
    const std::size_t i = bits <= 192 ? 0 : 1;
    if (!known_[i]) {
        known_[i] =
            value_.q == 0 || value_.d == 0 ? mpq_class(value_.p, value_.r) : oracle::approximate(value_, precisions[i]);
        known_[i]->canonicalize();
    }
    return *known_[i];
}

namespace {

template <int N>
using rational_vector = std::array<mpq_class, N>;

template <int N, class T>
rational_vector<N> difference(const graze::vec<N, T>& x, const graze::vec<N, T>& y) {
    rational_vector<N> z;
    for (int i = 0; i < N; ++i) {
        z[static_cast<std::size_t>(i)] = mpq_class(x[i]) - mpq_class(y[i]);
    }
    return z;
}

template <std::size_t N>
mpq_class product(const std::array<mpq_class, N>& x, const std::array<mpq_class, N>& y) {
    mpq_class sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
        sum += x[i] * y[i];
    }
    return sum;
}

exact_vector one(const mpq_class& x) { return {exact_number(oracle::rational(x))}; }
exact_vector one(const oracle::surd& x) { return {exact_number(x)}; }

template <int N>
exact_vector all(const oracle::surd_vector<N>& x) {
    exact_vector v;
    for (int i = 0; i < N; ++i) {
        v.emplace_back(x[i]);
    }
    return v;
}

mpq_class inverse(double mass) { return std::isinf(mass) ? mpq_class(0) : mpq_class(1 / mpq_class(mass)); }
mpq_class inverse(const mpq_class& mass) { return mass == 0 ? mass : mpq_class(1 / mass); } // 0 stands for infinity

template <class P>
oracle::answer meet(const P& p) {
    return std::visit([&](const auto& other) { return oracle::meet(p.a, other); }, p.other);
}

template <int N, class T, class Other>
mpq_class inverse_of_other(const Other& other) {
    const auto* const b = std::get_if<graze::ball<N, T>>(&other);
    return b == nullptr ? mpq_class(0) : inverse(b->mass);
}

template <int N>
bool is_finite(const graze::vec<N, double>& x) {
    for (int i = 0; i < N; ++i) {
        if (!std::isfinite(x[i])) {
            return false;
        }
    }
    return true;
}

template <int N>
bool is_valid(const graze::ball<N, double>& b) {
    return is_finite(b.position) && is_finite(b.velocity) && std::isfinite(b.radius) && b.radius >= 0 && b.mass > 0;
}

template <int N, class T>
bool is_zero(const graze::vec<N, T>& x) {
    for (int i = 0; i < N; ++i) {
        if (x[i] != 0) {
            return false;
        }
    }
    return true;
}

template <class T>
bool are_parallel(const graze::vec<3, T>& x, const graze::vec<3, T>& y) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (mpq_class(x[i]) * mpq_class(y[j]) != mpq_class(x[j]) * mpq_class(y[i])) {
            return false;
        }
    }
    return true;
}

// Whether the edges span a wall or a triangle: none is zero, and they are not parallel.
template <class Flat>
bool has_edges(const Flat& w) {
    for (const auto& e : w.edge) {
        if (is_zero(e)) {
            return false;
        }
    }
    if constexpr (std::tuple_size_v<decltype(w.edge)> == 2) {
        return !are_parallel(w.edge[0], w.edge[1]);
    }
    return true;
}

} // namespace

template <int N>
bool is_valid(const pair<N>& p) {
    if (!is_valid<N>(p.a)) {
        return false;
    }
    if (const auto* b = std::get_if<graze::ball<N, double>>(&p.other)) {
        return is_valid<N>(*b) && !(std::isinf(p.a.mass) && std::isinf(b->mass));
    }
    if (const auto* plane = std::get_if<graze::plane<N, double>>(&p.other)) {
        return is_finite(plane->point) && is_finite(plane->normal) && !is_zero(plane->normal);
    }
    return std::visit(
        [](const auto& w) {
            bool valid = true;
            if constexpr (requires { w.corner; }) {
                valid = is_finite(w.corner);
                for (const auto& e : w.edge) {
                    valid = valid && is_finite(e);
                }
                valid = valid && has_edges(w);
            }
            return valid;
        },
        p.other);
}

template <int N>
truth<N>::truth(const pair<N>& p)
    : pair_(p), inverse_a_(inverse(p.a.mass)), inverse_b_(inverse_of_other<N, double>(p.other)), met_(meet(p)) {}

template <int N>
truth<N>::truth(rational_pair<N> p, mpq_class inverse_a, mpq_class inverse_b)
    : pair_(std::move(p)), inverse_a_(std::move(inverse_a)), inverse_b_(std::move(inverse_b)),
      met_(meet(std::get<rational_pair<N>>(pair_))) {}

template <int N>
std::optional<truth<N>> truth<N>::of_rounded(const pair<N>& p, const value_of& value) {
    bool valid = true;
    const auto number = [&](double x) -> mpq_class {
        const std::optional<mpq_class> y = std::isinf(x) ? mpq_class(0) : value(x);
        valid = valid && y;
        return y.value_or(0);
    };
    const auto vector = [&](const graze::vec<N, double>& x) {
        return graze::make_vec<N>([&](int i) { return number(x[i]); });
    };
    const auto ball = [&](const graze::ball<N, double>& b) {
        const graze::ball<N, mpq_class> r{vector(b.position), vector(b.velocity), number(b.radius), number(b.mass)};
        valid = valid && r.radius >= 0 && (std::isinf(b.mass) || r.mass > 0);
        return r;
    };
    rational_pair<N> r{ball(p.a), {}};
    if (const auto* b = std::get_if<graze::ball<N, double>>(&p.other)) {
        r.other = ball(*b);
    } else if (const auto* plane = std::get_if<graze::plane<N, double>>(&p.other)) {
        graze::plane<N, mpq_class> q{vector(plane->point), vector(plane->normal)};
        valid = valid && !is_zero(q.normal);
        r.other = q;
    } else {
        const auto fill = [&](auto& to, const auto& from) {
            to.corner = vector(from.corner);
            std::transform(from.edge.begin(), from.edge.end(), to.edge.begin(), vector);
            valid = valid && has_edges(to);
        };
        if (const auto* w = std::get_if<graze::wall<N, double>>(&p.other)) {
            fill(r.other.template emplace<2>(), *w);
        } else if constexpr (N == 3) {
            fill(r.other.template emplace<3>(), std::get<3>(p.other));
        }
    }
    if (!valid) {
        return std::nullopt;
    }
    mpq_class inverse_b = inverse_of_other<N, mpq_class>(r.other);
    mpq_class inverse_a = inverse(r.a.mass);
    return truth(std::move(r), std::move(inverse_a), std::move(inverse_b));
}

template <int N>
typename truth<N>::values truth<N>::values_at(oracle::feature where, int index) const {
    values v{where, index, {}};
    const auto put = [&](quantity q, exact_vector x) { v.of[static_cast<std::size_t>(q)].push_back(std::move(x)); };
    const auto of_balls = [&](const auto& a, const auto& b) {
        const auto dx = difference(a.position, b.position), du = difference(a.velocity, b.velocity);
        const mpq_class sum = mpq_class(a.radius) + mpq_class(b.radius);
        const mpq_class q = product(du, du), h = product(dx, du), c = product(dx, dx) - sum * sum;
        put(quantity::coefficient_a, one(q));
        put(quantity::coefficient_h, one(h));
        put(quantity::coefficient_c, one(c));
        put(quantity::discriminant, one(mpq_class(h * h - q * c)));
        if (!oracle::is_collision(met_.what)) {
            return;
        }
        const auto met = oracle::contact(a, b, inverse_a_, inverse_b_, met_);
        put(quantity::time, one(met.time));
        put(quantity::position, all<N>(met.position_a));
        put(quantity::position, all<N>(met.position_b));
        put(quantity::normal, all<N>(met.normal));
        put(quantity::velocity, all<N>(met.velocity_a));
        put(quantity::velocity, all<N>(met.velocity_b));
    };
    const auto of_wall = [&](const oracle::wall_contact<N>& met) {
        put(quantity::time, one(met.time));
        put(quantity::position, all<N>(met.position));
        put(quantity::position, all<N>(met.point));
        put(quantity::normal, all<N>(met.normal));
        put(quantity::velocity, all<N>(met.velocity));
    };
    std::visit(
        [&](const auto& p) {
            std::visit(
                [&](const auto& other) {
                    if constexpr (requires { other.radius; }) {
                        of_balls(p.a, other);
                    } else if (!oracle::is_collision(met_.what)) {
                        return;
                    } else if constexpr (requires { other.normal; }) {
                        of_wall(oracle::contact(p.a, other, met_));
                    } else {
                        of_wall(oracle::contact(p.a, other, met_, where, index));
                    }
                },
                p.other);
        },
        pair_);
    return v;
}

template <int N>
const std::vector<exact_vector>& truth<N>::of(quantity q, oracle::feature where, int index) const {
    for (const values& v : known_) {
        if (v.where == where && v.index == index) {
            return v.of[static_cast<std::size_t>(q)];
        }
    }
    known_.push_back(values_at(where, index));
    return known_.back().of[static_cast<std::size_t>(q)];
}

template class truth<2>;
template class truth<3>;
template bool is_valid(const pair<2>&);
template bool is_valid(const pair<3>&);

} // namespace precision
