#include "truth.hpp"

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

template <int N>
rational_vector<N> difference(const graze::vec<N, double>& x, const graze::vec<N, double>& y) {
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

template <int N>
oracle::answer meet(const pair<N>& p) {
    return std::visit([&](const auto& other) { return oracle::meet(p.a, other); }, p.other);
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

template <int N>
bool is_zero(const graze::vec<N, double>& x) {
    for (int i = 0; i < N; ++i) {
        if (x[i] != 0) {
            return false;
        }
    }
    return true;
}

bool are_parallel(const graze::vec<3, double>& x, const graze::vec<3, double>& y) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (mpq_class(x[i]) * mpq_class(y[j]) != mpq_class(x[j]) * mpq_class(y[i])) {
            return false;
        }
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
    const auto& w = std::get<graze::wall<N, double>>(p.other);
    bool valid = is_finite(w.corner);
    for (const auto& e : w.edge) {
        valid = valid && is_finite(e) && !is_zero(e);
    }
    if constexpr (N == 3) {
        valid = valid && !are_parallel(w.edge[0], w.edge[1]);
    }
    return valid;
}

template <int N>
truth<N>::truth(const pair<N>& p) : pair_(p), met_(meet(p)) {}

template <int N>
void truth<N>::add_coefficients(const graze::ball<N, double>& a, const graze::ball<N, double>& b, values& v) const {
    const auto dx = difference(a.position, b.position), du = difference(a.velocity, b.velocity);
    const mpq_class sum = mpq_class(a.radius) + mpq_class(b.radius);
    const mpq_class q = product(du, du), h = product(dx, du), c = product(dx, dx) - sum * sum;
    v.of[static_cast<std::size_t>(quantity::coefficient_a)] = {one(q)};
    v.of[static_cast<std::size_t>(quantity::coefficient_h)] = {one(h)};
    v.of[static_cast<std::size_t>(quantity::coefficient_c)] = {one(c)};
    v.of[static_cast<std::size_t>(quantity::discriminant)] = {one(mpq_class(h * h - q * c))};
}

template <int N>
typename truth<N>::values truth<N>::values_at(oracle::feature where, int index) const {
    values v{where, index, {}};
    const auto* b = std::get_if<graze::ball<N, double>>(&pair_.other);
    if (b != nullptr) {
        add_coefficients(pair_.a, *b, v);
    }
    if (!oracle::is_collision(met_.what)) {
        return v;
    }
    const auto put = [&](quantity q, exact_vector x) { v.of[static_cast<std::size_t>(q)].push_back(std::move(x)); };
    if (b != nullptr) {
        const auto c = oracle::contact(pair_.a, *b, inverse(pair_.a.mass), inverse(b->mass), met_);
        put(quantity::time, one(c.time));
        put(quantity::position, all<N>(c.position_a));
        put(quantity::position, all<N>(c.position_b));
        put(quantity::normal, all<N>(c.normal));
        put(quantity::velocity, all<N>(c.velocity_a));
        put(quantity::velocity, all<N>(c.velocity_b));
        return v;
    }
    oracle::wall_contact<N> c;
    if (const auto* plane = std::get_if<graze::plane<N, double>>(&pair_.other)) {
        c = oracle::contact(pair_.a, *plane, met_);
    } else {
        c = oracle::contact(pair_.a, std::get<graze::wall<N, double>>(pair_.other), met_, where, index);
    }
    put(quantity::time, one(c.time));
    put(quantity::position, all<N>(c.position));
    put(quantity::position, all<N>(c.point));
    put(quantity::normal, all<N>(c.normal));
    put(quantity::velocity, all<N>(c.velocity));
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
