// In a scene with a period: which images of a thing a flight may come to. These are all images that boxes around its
// way reach, independently of what the run looked at.
#pragma once

#include "clearance.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace compare::run {

// The number of periods along each axis.
template <int N>
using whole_image = std::array<int, N>;

template <int N>
class image_space {
  public:
    using flight = graze::flight<N, certified>;

    explicit image_space(const vector_of<N>& period) : period_(period) {
        for (int i = 0; i < N; ++i) {
            length_[static_cast<std::size_t>(i)] = near_double(period[i]);
        }
    }

    // The image of a ball, a wall or a triangle. A plane is its own image.
    template <class S>
    [[nodiscard]] S image_of(S s, const whole_image<N>& image) const {
        if (image == whole_image<N>{}) {
            return s;
        }
        if constexpr (requires { s.edge; }) {
            s.corner = s.corner + distance(image);
        } else if constexpr (requires { s.state; }) {
            s.state.position = s.state.position + distance(image);
        }
        return s;
    }

    // x moved by the whole number of periods that brings it nearest to `to`.
    [[nodiscard]] vector_of<N> brought_to(const vector_of<N>& x, const vector_of<N>& to) const {
        whole_image<N> image{};
        for (int i = 0; i < N; ++i) {
            const auto k = static_cast<std::size_t>(i);
            image[k] = length_[k] > 0 ? static_cast<int>(std::lround(near_double(to[i] - x[i]) / length_[k])) : 0;
        }
        return image == whole_image<N>{} ? x : x + distance(image);
    }

    // f(image) for all images of s that a may touch between two times; null: no end. False if there are too many, or
    // their number is unknown.
    template <class S, class F>
    [[nodiscard]] bool for_each(const flight& a, const S& s, const certified& from, const certified* to, F f) const {
        whole_image<N> low{}, high{};
        for (int i = 0; i < N; ++i) {
            const auto k = static_cast<std::size_t>(i);
            if (!(length_[k] > 0)) {
                continue;
            }
            double first = std::numeric_limits<double>::infinity(), last = -first;
            const auto reaches = [&](const certified& x) {
                first = std::min(first, x.bounds().lower);
                last = std::max(last, x.bounds().upper);
            };
            for (const certified* t : {&from, to}) {
                if (t != nullptr) {
                    for_each_corner(s, *t, i, [&](const certified& x) { reaches(place_at<N>(a, *t)[i] - x); });
                } else if (velocity_along(a, s, i).certain_sign() != 0) {
                    return false;
                }
            }
            const double reach = near_double(a.state.radius + radius_of(s));
            // The range of whole periods k with x within reach of k lengths; 0.01 is far above the rounding errors.
            const double least = std::floor((first - reach) / length_[k] - 0.01),
                         most = std::ceil((last + reach) / length_[k] + 0.01);
            if (!(most - least < 1000 && least > -0x1p30 && most < 0x1p30)) {
                return false;
            }
            low[k] = static_cast<int>(least);
            high[k] = static_cast<int>(most);
        }
        for (whole_image<N> image = low;;) {
            f(image);
            std::size_t axis = 0;
            for (; axis < N && image[axis] == high[axis]; ++axis) {
                image[axis] = low[axis];
            }
            if (axis == N) {
                return true;
            }
            ++image[axis];
        }
    }

  private:
    vector_of<N> period_;
    std::array<double, N> length_{};

    [[nodiscard]] vector_of<N> distance(const whole_image<N>& image) const {
        return graze::make_vec<N>([&](int i) { return certified(image[static_cast<std::size_t>(i)]) * period_[i]; });
    }
    template <class S>
    [[nodiscard]] static certified radius_of(const S& s) {
        if constexpr (requires { s.state; }) {
            return s.state.radius;
        } else {
            return 0;
        }
    }
    template <class S>
    [[nodiscard]] static certified velocity_along(const flight& a, const S& s, int axis) {
        if constexpr (requires { s.state; }) {
            return a.state.velocity[axis] - s.state.velocity[axis];
        } else {
            return a.state.velocity[axis];
        }
    }
    // f(coordinate) for each corner of s, or its centre, at that time.
    template <class S, class F>
    static void for_each_corner(const S& s, const certified& t, int axis, F f) {
        if constexpr (requires { s.state; }) {
            f(place_at<N>(s, t)[axis]);
        } else if constexpr (requires { s.edge; }) {
            for (unsigned corner = 0; corner < 1U << s.edge.size(); ++corner) {
                certified x = s.corner[axis];
                for (std::size_t e = 0; e < s.edge.size(); ++e) {
                    x = (corner >> e & 1U) != 0 ? x + s.edge[e][axis] : x;
                }
                f(x);
            }
        } else {
            f(s.point[axis]); // a plane, for which any coordinate will do
        }
    }
};

} // namespace compare::run
