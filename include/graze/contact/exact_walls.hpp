// The components of a ball's contact with a plane or a wall as exact numbers (p + q√d)/r, each rounded once.
//
// Plane or face, with H = w·n, S = u·n, s the sign of H and τ = (|H| - r√(n·n))/|S|:
//   position  x + u τ            = (|S| x + |H| u - r u √(n·n))/|S|                                      (33), (30)
//   normal    s n/|n|            = s n √(n·n)/(n·n)
//   point     x + u τ - r X̂      = (n·n (|S| x + |H| u) - r (n·n u + s |S| n) √(n·n))/(|S| n·n)
//   velocity  u - 2 (u·n̂) n̂      = (n·n u - 2 S n)/(n·n)
// and for an overlap, where τ = 0, the point is (n·n x - H n)/(n·n).
//
// A corner is a ball of radius 0 that nothing moves. An edge along e is one in the plane across it: with the names of
// wall_features' quadratic (a = |u × e|², D = e·e D') and t = e·(w × u), the part across the edge of a vector v is
// e × (v × e)/(e·e), and a e × (w × e) - h e × (u × e) = t e·e (u × e); so
//   point     corner + ((w + u τ)·e/(e·e)) e
//   normal    (w + u τ) across/r = (t e·e (u × e) - √D e × (u × e))/(a e·e r)
//   velocity  u + 2 √D/(e·e r) X̂ = (a e·e r² u - 2 D' e × (u × e) + 2 t √D (u × e))/(a e·e r²).
#pragma once

#include <graze/contact/exact_contact.hpp>
#include <graze/formula/wall_features.hpp>

namespace graze::inline v0_1::detail {

// A ball that meets a plane with hit or overlap; I: the integers of the ball's position.
template <class T, int N, class M, class I>
class exact_plane {
    using Z = root_sum_integer_for<M>;

  public:
    constexpr exact_plane(const M& m, const vec<N, I>& x, bool inside, scales units)
        : m_(m), x_(x), inside_(inside), units_(units) {}

    [[nodiscard]] constexpr T time() const { return round_plane_time<T>(m_, root_, units_.time()); }

    [[nodiscard]] constexpr T position(int i) const {
        return round_to<T>(numerator(i), -(m_.r * m_.u[i]), root_, speed(), units_.length);
    }

    [[nodiscard]] constexpr T point(int i) const {
        if (inside_) {
            return round_to<T>(square_ * x_[i] - height_ * m_.n[i], Z(0), radicand<Z>(), square_, units_.length);
        }
        const auto along = square_ * m_.u[i] - speed_ * m_.n[i]; // s|S| = -S, since they approach
        return round_to<T>(square_ * numerator(i), -(m_.r * along), root_, square_ * speed(), units_.length);
    }

    [[nodiscard]] constexpr T normal(int i) const {
        return round_to<T>(Z(0), below() ? -m_.n[i] : m_.n[i], root_, square_, 0);
    }

    [[nodiscard]] constexpr T velocity(int i) const {
        return round_to<T>(square_ * m_.u[i] - graze::twice(speed_ * m_.n[i]), Z(0), radicand<Z>(), square_,
                           units_.velocity);
    }

  private:
    [[nodiscard]] constexpr bool below() const { return graze::sign(height_) < 0; }
    [[nodiscard]] constexpr auto speed() const { return below() ? speed_ : -speed_; } // |S|
    [[nodiscard]] constexpr auto numerator(int i) const {
        return speed() * x_[i] + (below() ? -height_ : height_) * m_.u[i];
    }

    const M& m_;
    const vec<N, I>& x_;
    bool inside_;
    scales units_;
    decltype(plane_height{}(std::declval<M>())) height_ = plane_height{}(m_);
    decltype(plane_speed{}(std::declval<M>())) speed_ = plane_speed{}(m_);
    decltype(graze::squared_norm(std::declval<M>().n)) square_ = graze::squared_norm(m_.n);
    radicand<Z> root_{square_};
};

struct edge_triple { // e·(w × u)
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::dot(m.e[1], graze::cross(m.w, m.u));
    }
};
struct edge_turned { // u × e
    template <class M>
    [[nodiscard]] constexpr auto operator()(const M& m) const {
        return graze::cross(m.u, m.e[1]);
    }
};
using edge_foot_at_root = value_at_root<edge_a, edge_h, edge_foot<0>, edge_foot_speed>;

// A ball that meets the view's edge with hit or graze.
template <class T, class M>
class exact_edge {
    template <class F>
    using value = decltype(F{}(std::declval<M>()));
    using Z = root_sum_integer_for<M>;
    using path_type = exact_path<T, Z, value<edge_a>, value<edge_h>>;

  public:
    constexpr exact_edge(const M& m, scales units)
        : path(path_until<T, Z>(edge_a{}(m), edge_h{}(m), edge_discriminant{}(m), units)), m_(m) {}

    path_type path;

    // corner: the view's.
    template <class I>
    [[nodiscard]] constexpr T point(const I& corner, int i) const {
        const auto& e = m_.e[1][i];
        return round_to<T>(per_point_ * corner + foot_ * e, -(speed_ * e), path.discriminant, per_point_,
                           path.units.length);
    }

    [[nodiscard]] constexpr T normal(int i) const {
        return round_to<T>(triple_ * square_ * turned_[i], -across_[i], path.discriminant, path.a * (square_ * m_.r),
                           0);
    }

    [[nodiscard]] constexpr T velocity(int i) const {
        return round_to<T>(per_velocity_ * m_.u[i] - graze::twice(reduced_ * across_[i]),
                           graze::twice(triple_ * turned_[i]), path.discriminant, per_velocity_, path.units.velocity);
    }

  private:
    const M& m_;
    decltype(graze::squared_norm(std::declval<M>().e[1])) square_ = graze::squared_norm(m_.e[1]);
    value<edge_triple> triple_ = edge_triple{}(m_);
    value<edge_reduced_discriminant> reduced_ = edge_reduced_discriminant{}(m_);
    value<edge_foot_speed> speed_ = edge_foot_speed{}(m_);
    value<edge_foot_at_root> foot_ = edge_foot_at_root{}(m_);
    decltype(std::declval<path_type>().a * square_) per_point_ = path.a * square_;
    decltype(per_point_ * (std::declval<M>().r * std::declval<M>().r)) per_velocity_ = per_point_ * (m_.r * m_.r);
    value<edge_turned> turned_ = edge_turned{}(m_);
    decltype(graze::cross(std::declval<M>().e[1], std::declval<value<edge_turned>>())) across_ =
        graze::cross(m_.e[1], turned_);
};

} // namespace graze::inline v0_1::detail
