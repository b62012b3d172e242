// A pair as a row of numbers, as in the file of questions: position, velocity and radius of the ball; then the same of
// another ball, or point and normal of a plane, or corner and edges of a wall.
#pragma once

#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/wall.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace environments {

enum class partner { ball, plane, wall };

inline constexpr std::array partners{partner::ball, partner::plane, partner::wall};

[[nodiscard]] constexpr const char* name_of(partner p) {
    return p == partner::ball ? "ball-ball" : p == partner::plane ? "ball-plane" : "ball-wall";
}

template <class T>
inline constexpr const char* type_name = nullptr;
template <>
inline constexpr const char* type_name<float> = "float";
template <>
inline constexpr const char* type_name<double> = "double";
template <>
inline constexpr const char* type_name<std::int32_t> = "int32";
template <>
inline constexpr const char* type_name<std::int64_t> = "int64";

[[nodiscard]] constexpr std::size_t row_length(partner p, int n) {
    const auto size = static_cast<std::size_t>(n);
    return 2 * size + 1 + (p == partner::ball ? 2 * size + 1 : p == partner::plane ? 2 * size : size * size);
}

// Takes shapes from consecutive numbers.
template <int N, class T>
class shapes_of_row {
  public:
    explicit shapes_of_row(const T* first) : next_(first) {}

    [[nodiscard]] graze::ball<N, T> ball() {
        graze::ball<N, T> b{};
        take(b.position);
        take(b.velocity);
        b.radius = *next_++;
        return b;
    }
    [[nodiscard]] graze::plane<N, T> plane() {
        graze::plane<N, T> p{};
        take(p.point);
        take(p.normal);
        return p;
    }
    [[nodiscard]] graze::wall<N, T> wall() {
        graze::wall<N, T> w{};
        take(w.corner);
        for (auto& e : w.edge) {
            take(e);
        }
        return w;
    }
    template <partner P>
    [[nodiscard]] auto other() {
        if constexpr (P == partner::ball) {
            return ball();
        } else if constexpr (P == partner::plane) {
            return plane();
        } else {
            return wall();
        }
    }

  private:
    void take(graze::vec<N, T>& v) {
        for (T& x : v.component) {
            x = *next_++;
        }
    }

    const T* next_;
};

// f(ball, ball or plane or wall).
template <partner P, int N, class T, class F>
auto with_shapes(const T* row, F f) {
    shapes_of_row<N, T> shapes(row);
    const auto a = shapes.ball();
    const auto b = shapes.template other<P>();
    return f(a, b);
}

} // namespace environments
