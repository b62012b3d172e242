// Runs by brute force: at every event it looks at every pair and every image of it, in numbers of 1024 bits, and rounds
// each state once. It shares only the shapes of a scene with the library: it uses textbook formulas and no lists.
#pragma once

#include <graze/scene/scene.hpp>
#include <graze/scene/scene_pair.hpp>
#include <graze/shape/flight.hpp>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

namespace brute_force {

using real = mpf_class;

inline real exactly(double x) { return real(x, 1024); }
inline real root_of(const real& x) { return real(sqrt(x)); }

// To nearest, ties to even. A number from a division counts as halfway if it is so to 800 bits.
inline double rounded(const real& x) {
    const double toward_zero = x.get_d();
    const double beyond = std::nextafter(toward_zero, sgn(x) < 0 ? -INFINITY : INFINITY);
    const real below = abs(x - toward_zero), above = abs(x - beyond);
    const real gap = below - above, ulp = below + above;
    if (abs(gap) * exactly(0x1p400) * exactly(0x1p400) < ulp) {
        return (std::bit_cast<std::uint64_t>(toward_zero) & 1U) == 0 ? toward_zero : beyond;
    }
    return gap < 0 ? toward_zero : beyond;
}

template <int N>
using point = std::array<real, N>;

template <int N>
real dot(const point<N>& x, const point<N>& y) {
    real sum = exactly(0);
    for (std::size_t i = 0; i < N; ++i) {
        sum += x[i] * y[i];
    }
    return sum;
}
// x + t u.
template <int N>
point<N> moved(const point<N>& x, const point<N>& u, const real& t) {
    point<N> result;
    for (std::size_t i = 0; i < N; ++i) {
        result[i] = x[i] + t * u[i];
    }
    return result;
}
template <int N>
point<N> exactly(const graze::vec<N, double>& x) {
    point<N> result;
    for (std::size_t i = 0; i < N; ++i) {
        result[i] = exactly(x[static_cast<int>(i)]);
    }
    return result;
}
template <int N>
graze::vec<N, double> rounded(const point<N>& x) {
    return graze::make_vec<N>([&](int i) { return rounded(x[static_cast<std::size_t>(i)]); });
}

// When something at x that moves by u is first at a distance r from 0; now, if it is nearer and approaches.
template <int N>
std::optional<real> time_to(const point<N>& x, const point<N>& u, const real& r) {
    const real h = dot<N>(x, u), c = dot<N>(x, x) - r * r;
    if (h >= 0) {
        return std::nullopt;
    }
    if (c < 0) {
        return exactly(0);
    }
    const real d = h * h - dot<N>(u, u) * c;
    return d < 0 ? std::nullopt : std::optional(real(c / (root_of(d) - h)));
}

// The next event. with: its partner; image: a meets b moved by this many periods; n: the direction from there to a.
template <int N>
struct event {
    real time;
    graze::scene_pair who;
    std::array<int, N> image{};
    point<N> n{};
};

template <int N>
class simulator {
  public:
    explicit simulator(const graze::scene<N>& s) : scene_(s) {
        for (const auto& b : s.balls) {
            flights_.push_back({b, 0});
            bring_back(flights_.back().state.position);
        }
        last_.resize(flights_.size());
    }

    [[nodiscard]] const graze::flight<N>& operator[](int ball) const {
        return flights_[static_cast<std::size_t>(ball)];
    }

    // From now on times count from `by`.
    void set_clock_back(double by) {
        for (auto& f : flights_) {
            const real since = exactly(f.since) - by;
            f.since = since.get_d();
            if (since != f.since) {
                throw std::runtime_error("a clock was set back that cannot be, exactly");
            }
        }
    }

    // Does the next event before `end`, if there is one. is_clear: whether no other event is nearly as early.
    std::optional<event<N>> next(double end, bool& is_clear) {
        std::optional<event<N>> first;
        real second = exactly(end);
        const auto offer = [&](const std::optional<event<N>>& e) {
            if (!e || e->time > end) {
                return;
            }
            if (!first || e->time < first->time) {
                second = first ? first->time : second;
                first = e;
            } else if (e->time < second) {
                second = e->time;
            }
        };
        const int count = static_cast<int>(flights_.size());
        for (int a = 0; a < count; ++a) {
            for (int b = a + 1; b < count; ++b) {
                offer_images(a, b, end, offer);
            }
            for (int i = 0; i < static_cast<int>(scene_.planes.size()); ++i) {
                offer(meet_plane(a, i));
            }
            for (int i = 0; i < static_cast<int>(scene_.walls.size()); ++i) {
                offer(meet_wall(a, i));
            }
        }
        is_clear = !first || second - first->time > 1e-30;
        if (first) {
            perform(*first);
        }
        return first;
    }

  private:
    struct met {
        graze::partner with = graze::partner::ball;
        int what = -1;
        std::array<int, N> image{};
        bool operator==(const met&) const = default;
    };

    [[nodiscard]] graze::flight<N>& at(int i) { return flights_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] const graze::flight<N>& at(int i) const { return flights_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] static point<N> place(const graze::flight<N>& f, const real& t) {
        return moved<N>(exactly<N>(f.state.position), exactly<N>(f.state.velocity), real(t - f.since));
    }
    [[nodiscard]] static std::array<int, N> negative(std::array<int, N> image) {
        for (int& k : image) {
            k = -k;
        }
        return image;
    }
    // Moves x to within half a period of 0. Returns by how many periods.
    std::array<int, N> bring_back(graze::vec<N, double>& x) const {
        std::array<int, N> gone{};
        for (int i = 0; i < N; ++i) {
            if (const double length = scene_.period[i]; length > 0) {
                const int k = static_cast<int>(std::floor(x[i] / length + 0.5));
                x.component[i] = real(exactly(x[i]) - k * exactly(length)).get_d(); // exact
                gone[static_cast<std::size_t>(i)] = k;
            }
        }
        return gone;
    }

    // f(event) for each image of b that a may meet before the end.
    template <class F>
    void offer_images(int a, int b, double end, F f) const {
        const graze::flight<N>&x = at(a), &y = at(b);
        const real start = exactly(std::max(x.since, y.since));
        const point<N> p = place(x, start), q = place(y, start);
        const real r = exactly(x.state.radius) + y.state.radius;
        std::array<int, N> low{}, high{};
        for (int i = 0; i < N; ++i) {
            const auto k = static_cast<std::size_t>(i);
            if (const double length = scene_.period[i]; length > 0) { // all images that the way passes
                const double from = real(p[k] - q[k]).get_d();
                const double to = from + (x.state.velocity[i] - y.state.velocity[i]) * (end - start.get_d());
                low[k] = static_cast<int>(std::floor((std::min(from, to) - r.get_d()) / length - 0.01));
                high[k] = static_cast<int>(std::ceil((std::max(from, to) + r.get_d()) / length + 0.01));
            }
        }
        std::array<int, N> image = low;
        while (true) {
            offer_image(a, b, image, start, p, q, r, f);
            std::size_t axis = 0;
            while (axis < N && image[axis] == high[axis]) {
                image[axis] = low[axis];
                ++axis;
            }
            if (axis == N) {
                return;
            }
            ++image[axis];
        }
    }
    template <class F>
    void offer_image(int a, int b, const std::array<int, N>& image, const real& start, const point<N>& p,
                     const point<N>& q, const real& r, F f) const {
        if (last_[static_cast<std::size_t>(a)] == met{graze::partner::ball, b, image} &&
            last_[static_cast<std::size_t>(b)] == met{graze::partner::ball, a, negative(image)}) {
            return;
        }
        point<N> x, u;
        for (int i = 0; i < N; ++i) {
            const auto k = static_cast<std::size_t>(i);
            x[k] = p[k] - q[k] - image[k] * exactly(scene_.period[i]);
            u[k] = exactly(at(a).state.velocity[i]) - at(b).state.velocity[i];
        }
        if (const auto t = time_to<N>(x, u, r)) {
            f(event<N>{real(start + *t), {graze::partner::ball, a, b}, image, moved<N>(x, u, *t)});
        }
    }
    [[nodiscard]] bool has_just_met(int a, graze::partner with, int what) const {
        return last_[static_cast<std::size_t>(a)] == met{with, what, {}};
    }
    // A face: the part of the plane n·x = 0 where inside(place) is true.
    template <class Inside>
    [[nodiscard]] std::optional<real> time_to_face(const point<N>& x, const point<N>& u, point<N> n, double radius,
                                                   point<N>& towards, Inside inside) const {
        const real height = dot<N>(x, n), speed = dot<N>(u, n);
        if (height * speed >= 0) {
            return std::nullopt;
        }
        const real length = root_of(dot<N>(n, n));
        const real gap = abs(height) - radius * length;
        const real t = gap < 0 ? exactly(0) : real(gap / abs(speed));
        towards = n;
        return inside(moved<N>(x, u, t)) ? std::optional(t) : std::nullopt;
    }
    [[nodiscard]] std::optional<event<N>> meet_plane(int a, int i) const {
        if (has_just_met(a, graze::partner::plane, i)) {
            return std::nullopt;
        }
        const graze::flight<N>& f = at(a);
        const auto& plane = scene_.planes[static_cast<std::size_t>(i)];
        event<N> e{{}, {graze::partner::plane, a, i}, {}, {}};
        const auto x = moved<N>(exactly<N>(f.state.position), exactly<N>(plane.point), exactly(-1));
        const auto t = time_to_face(x, exactly<N>(f.state.velocity), exactly<N>(plane.normal), f.state.radius, e.n,
                                    [](const auto&) { return true; });
        e.time = t ? real(f.since + *t) : exactly(0);
        return t ? std::optional(e) : std::nullopt;
    }
    // In the plane: the first of the face and the ends.
    [[nodiscard]] std::optional<event<N>> meet_wall(int a, int i) const {
        if (N != 2 || has_just_met(a, graze::partner::wall, i)) {
            return std::nullopt;
        }
        const graze::flight<N>& f = at(a);
        const auto& wall = scene_.walls[static_cast<std::size_t>(i)];
        const auto edge = exactly<N>(wall.edge[0]), u = exactly<N>(f.state.velocity);
        const auto x = moved<N>(exactly<N>(f.state.position), exactly<N>(wall.corner), exactly(-1));
        const auto beyond = moved<N>(x, edge, exactly(-1));
        const real whole = dot<N>(edge, edge), along = dot<N>(x, edge);
        const auto is_beside = [&](const real& s) { return s > 0 && s < whole; };
        const auto now = is_beside(along) ? moved<N>(x, edge, real(-along / whole)) : along <= 0 ? x : beyond;
        event<N> e{{}, {graze::partner::wall, a, i}, {}, {}};
        if (dot<N>(now, now) < exactly(f.state.radius) * f.state.radius) { // the ball cuts it
            if (dot<N>(now, u) >= 0) {
                return std::nullopt;
            }
            e.time = exactly(f.since);
            e.n = now;
            return e;
        }
        std::optional<real> first;
        point<N> n;
        n[0] = -edge[1];
        n[1] = edge[0];
        const auto offer = [&](const std::optional<real>& t, const point<N>& towards) {
            if (t && (!first || *t < *first)) {
                first = t;
                e.n = towards;
            }
        };
        point<N> towards{};
        const auto face = time_to_face(x, u, n, f.state.radius, towards,
                                       [&](const point<N>& there) { return is_beside(dot<N>(there, edge)); });
        offer(face, towards);
        for (const auto& corner : {x, beyond}) {
            if (const auto t = time_to<N>(corner, u, exactly(f.state.radius))) {
                offer(t, moved<N>(corner, u, *t));
            }
        }
        e.time = first ? real(f.since + *first) : exactly(0);
        return first ? std::optional(e) : std::nullopt;
    }

    void perform(const event<N>& e) {
        const int a = e.who.a, b = e.who.b;
        const bool two = e.who.with == graze::partner::ball;
        const graze::flight<N> x = at(a), y = two ? at(b) : x;
        point<N> u = exactly<N>(x.state.velocity);
        real share = exactly(1), other = exactly(0);
        if (two) {
            u = moved<N>(u, exactly<N>(y.state.velocity), exactly(-1));
            const real sum = exactly(x.state.mass) + y.state.mass;
            share = y.state.mass / sum;
            other = x.state.mass / sum;
        }
        const real turn = -2 * dot<N>(u, e.n) / dot<N>(e.n, e.n);
        const auto leave = [&](int i, const graze::flight<N>& from, const real& part) {
            at(i).state.velocity = rounded<N>(moved<N>(exactly<N>(from.state.velocity), e.n, real(part * turn)));
            at(i).state.position = rounded<N>(place(from, e.time));
            at(i).since = rounded(e.time);
            return bring_back(at(i).state.position);
        };
        const auto gone = leave(a, x, share);
        std::array<int, N> image = e.image;
        if (two) {
            const auto gone_b = leave(b, y, real(-other));
            for (std::size_t k = 0; k < N; ++k) {
                image[k] += gone_b[k] - gone[k];
            }
            last_[static_cast<std::size_t>(b)] = {graze::partner::ball, a, negative(image)};
        }
        last_[static_cast<std::size_t>(a)] = {e.who.with, b, image};
    }

    graze::scene<N> scene_;
    std::vector<graze::flight<N>> flights_;
    std::vector<met> last_;
};

} // namespace brute_force
