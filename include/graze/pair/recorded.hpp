// A number type in which a formula yields the steps that compute it, for number types that are slow: these run the
// steps, and so compile no formula.
#pragma once

#include <graze/linear/vec.hpp>
#include <graze/number/traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>

namespace graze::inline v0_1::detail {

// One step writes the next place in a row of numbers, from places before it.
struct recorded_step {
    enum kind : std::uint8_t { negation, sum, difference, product, two_products, three_products, determinant };
    kind what = negation;
    std::array<std::uint8_t, 6> from{};
};

// The steps of a formula, while it is recorded. Its inputs stand in the first places.
template <int Capacity>
struct recording {
    std::array<recorded_step, Capacity> step{};
    int inputs = 0;
    int count = 0;
};
using open_recording = recording<96>;

// The number in a place of a row.
class recorded {
  public:
    constexpr recorded() = default;
    constexpr explicit(false) recorded(int) noexcept : place_(-1) {} // constants have no place, and none is needed
    constexpr recorded(open_recording& r, int place) noexcept : to_(&r), place_(place) {}

    [[nodiscard]] constexpr int place() const noexcept { return place_; }

    [[nodiscard]] constexpr recorded then(recorded_step::kind what, std::array<int, 6> from) const {
        recorded_step& s = to_->step[static_cast<std::size_t>(to_->count)];
        s.what = what;
        for (std::size_t i = 0; i < from.size(); ++i) {
            s.from[i] = place_in_step(from[i]);
        }
        return {*to_, to_->inputs + to_->count++};
    }
    [[nodiscard]] constexpr recorded operator-() const { return then(recorded_step::negation, {place_}); }
    [[nodiscard]] friend constexpr recorded operator+(const recorded& x, const recorded& y) {
        return x.then(recorded_step::sum, {x.place_, y.place_});
    }
    [[nodiscard]] friend constexpr recorded operator-(const recorded& x, const recorded& y) {
        return x.then(recorded_step::difference, {x.place_, y.place_});
    }
    [[nodiscard]] friend constexpr recorded operator*(const recorded& x, const recorded& y) {
        return x.then(recorded_step::product, {x.place_, y.place_});
    }

  private:
    // In a recording, anything else does not compile.
    [[nodiscard]] static constexpr std::uint8_t place_in_step(int place) {
        if (place < 0 || place > 255) {
            std::terminate();
        }
        return static_cast<std::uint8_t>(place);
    }

    open_recording* to_ = nullptr;
    int place_ = 0;
};

// Runs steps over a row whose first numbers are the inputs.
template <class T>
[[gnu::noinline]] constexpr void run_steps(T* row, const recorded_step* step, int inputs, int count) {
    for (int i = 0; i < count; ++i) {
        const auto at = [&](std::size_t k) -> const T& { return row[step[i].from[k]]; };
        T& to = row[inputs + i];
        switch (step[i].what) {
        case recorded_step::negation:
            to = -at(0);
            break;
        case recorded_step::sum:
            to = at(0) + at(1);
            break;
        case recorded_step::difference:
            to = at(0) - at(1);
            break;
        case recorded_step::product:
            to = at(0) * at(1);
            break;
        case recorded_step::two_products:
            to = graze::dot(vec<2, T>{at(0), at(2)}, vec<2, T>{at(1), at(3)});
            break;
        case recorded_step::three_products:
            to = graze::dot(vec<3, T>{at(0), at(2), at(4)}, vec<3, T>{at(1), at(3), at(5)});
            break;
        case recorded_step::determinant:
            to = graze::cross(vec<2, T>{at(0), at(2)}, vec<2, T>{at(3), at(1)});
            break;
        }
    }
}

} // namespace graze::inline v0_1::detail

template <>
struct graze::number_traits<graze::detail::recorded> {
    static constexpr const char* name = "recorded";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0;

    template <class V>
    static constexpr detail::recorded dot(const V& x, const V& y) {
        if constexpr (requires { x.z(); }) {
            return x[0].then(detail::recorded_step::three_products,
                             {x[0].place(), y[0].place(), x[1].place(), y[1].place(), x[2].place(), y[2].place()});
        } else {
            return x[0].then(detail::recorded_step::two_products,
                             {x[0].place(), y[0].place(), x[1].place(), y[1].place()});
        }
    }
    template <class V>
    static constexpr auto cross(const V& x, const V& y) {
        const auto determinant = [&](int i, int j) { // x_i y_j - x_j y_i
            return x[0].then(detail::recorded_step::determinant,
                             {x[i].place(), y[j].place(), x[j].place(), y[i].place()});
        };
        if constexpr (requires { x.z(); }) {
            return V{{determinant(1, 2), determinant(2, 0), determinant(0, 1)}};
        } else {
            return determinant(0, 1);
        }
    }
};
