// A ball's path until it touches a plane or a face, edge or corner, in sums of two doubles, and the components of its
// contact that are certain.
#pragma once

#include <graze/contact/components.hpp>
#include <graze/contact/contact.hpp>
#include <graze/time/flat_time.hpp>

namespace graze::inline v0_1::detail {

// Takes numbers and writes those whose rounding is certain.
template <int N, class T>
class certain_components {
  public:
    [[gnu::always_inline]] void operator()(const bounded<double>& y, int number, T& to) noexcept {
        const ends<double> interval = ends_of<T>(bounded<double>{y.high, y.low, y.error + underflow});
        const bool certain = agree<T>(interval);
        to = certain ? static_cast<T>(interval.upper) : to;
        certain_ |= component_set{certain} << number;
    }
    // x + y: in double the machine's sum is the result.
    [[gnu::always_inline]] void sum(double x, double y, int number, T& to) noexcept {
        const auto s = two_sum(x, y);
        if (std::is_same_v<T, double> || s.error == 0) {
            exact(s.value, number, to);
        } else {
            (*this)({s.value, s.error, 0}, number, to);
        }
    }
    // For an exact number.
    [[gnu::always_inline]] void exact(double x, int number, T& to) noexcept {
        to = with_plain_zero(static_cast<T>(x));
        certain_ |= component_set{1} << number;
    }
    [[nodiscard]] component_set open_components() const noexcept { return (N == 3 ? 0x1fffU : 0xdb7U) & ~certain_; }

  private:
    component_set certain_ = 0;
};

// Whether no product of two of these numbers underflows to a zero.
template <int N>
[[nodiscard]] inline bool has_no_tiny_edge(const flat_row<N>& f) noexcept {
    for (const auto& e : f.edge) {
        for (int i = 0; i < N; ++i) {
            if (bits_of(e[i]) << 1 != 0 && absolute(e[i]) < 0x1p-400) {
                return false;
            }
        }
    }
    return true;
}

// A ball's path until it touches, in parts: its position, and the errors of the terms that it is added up from.
template <bool Fused, int N, class Take>
struct path_in_parts {
    const flat_row<N>& f;
    const flat_time& t;
    Take& take;

    struct step {
        exact_pair<double> position;
        double size, error; // of its roundings, and of all
        bool stays;
    };
    [[nodiscard, gnu::always_inline]] step at(int i) const noexcept {
        const auto way = two_product(as_factor<Fused>(f.u[i]), as_factor<Fused>(t.high));
        const auto sum = two_sum(f.x[i], way.value);
        const double size = 0x1p-102 * (absolute(f.x[i]) + absolute(way.value));
        return {{sum.value, sum.error + (way.error + f.u[i] * t.low)},
                size,
                size + 1.01 * absolute(f.u[i]) * t.error,
                bits_of(f.u[i]) << 1 == 0};
    }
    template <class T>
    [[gnu::always_inline]] void take_position(const step& s, int i, wall_component part, T& to) const noexcept {
        if (s.stays) {
            take.exact(f.x[i], static_cast<int>(part) + i, to);
        } else {
            take({s.position.value, s.position.error, s.error}, static_cast<int>(part) + i, to);
        }
    }
    // In a direction across the normal.
    template <class T>
    [[gnu::always_inline]] void take_unturned(const step& s, int i, wall_contact<N, T>& c) const noexcept {
        take.exact(0, static_cast<int>(wall_component::normal) + i, c.normal[i]);
        take.exact(f.u[i], static_cast<int>(wall_component::velocity) + i, c.velocity[i]);
        take_position(s, i, wall_component::point, c.point[i]);
    }
};

// 1/x, right to 2^-100 of itself beside the error of x.
template <bool Fused>
[[nodiscard, gnu::always_inline]] inline exact_pair<double> inverse_in_parts(const exact_pair<double>& x) noexcept {
    const double inverse = settled(1 / x.value);
    const auto back = two_product(as_factor<Fused>(inverse), as_factor<Fused>(x.value));
    const double rest = settled(settled(1 - back.value) - back.error) - inverse * x.error;
    return {inverse, inverse * rest};
}
[[nodiscard, gnu::always_inline]] inline bool is_exact_zero(const exact_pair<double>& x) noexcept {
    return x.value == 0 && x.error == 0;
}

} // namespace graze::inline v0_1::detail
