// Balls in flight as the bound of most pairs needs them: those of two that are certainly apart for a while.
#pragma once

#include <graze/machine/fetch.hpp>
#include <graze/machine/lanes.hpp>
#include <graze/scene/body.hpp>
#include <graze/scene/image_code.hpp>
#include <graze/time/bounds_until.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace graze::inline v0_1::detail {

// A ball in flight, or one around it, in one line of a cache. N = 2: the third component is 0. One that is too far or
// too fast for doubles to tell has a radius of 2^300.
struct alignas(64) outline {
    lanes x01{}, x2r{}; // position and radius
    lanes u01{}, u2s{}; // velocity and since
};

// One ball as all others are compared with it: whether they certainly don't meet until some time.
//
// All magnitudes are below 2^102, but for radii of 2^300, which make c negative. So nothing overflows, and what
// underflows or is flushed to zero takes less than 2^-600 from a result.
//
// From the later epoch on a pair's a t² + 2ht + c is at least c + 2ht: nothing is met until T where both c and c + 2hT
// are positive. They are computed as the formulas compute them, in the same order. Let V bound the speeds, w be the way
// between the epochs of the one with the earlier and P = |Δx|² at the later. The scales of error_until are |Δu| <= 2V
// and the distance when each is at its own epoch, at most √P + |w|, beside |w| and R: where c > 0, R² <= P and the sum
// of their squares is below 4 (P + |w|²). |w| <= V |lead|.
template <int N>
class glance {
  public:
    // fastest2: V².
    glance(const outline& a, double fastest2) noexcept
        : a_{a.x01, lanes{a.x2r[0], -a.x2r[1]}, a.u01, a.u2s}, fastest2_(fastest2) {}

    // latest: below 2^200, or none is told to be apart.
    void look_until(double latest) noexcept {
        if (latest != latest_) {
            latest_ = latest;
            error_ =
                latest < 0x1p200 ? error_until<constants>(4 * fastest2_, 0, latest - a_.u2s[1]) + 0x1p-500 : 0x1p1000;
        }
    }
    // Where it is, or where it is seen by those that are so far away.
    struct place {
        lanes x01, x2r;
    };
    [[nodiscard, gnu::always_inline]] place here() const noexcept { return {a_.x01, a_.x2r}; }
    [[nodiscard, gnu::always_inline]] place seen_from(const vec<N, double>& by) const noexcept {
        return {settled(lanes(a_.x01 - lanes{by[0], by[1]})),
                settled(lanes(a_.x2r - lanes{N == 3 ? by[N - 1] : 0, 0}))};
    }
    [[nodiscard, gnu::always_inline]] bool is_apart(const outline& b, const place& at) const noexcept {
        const lanes x01 = settled(lanes(at.x01 - b.x01)), x2R = settled(lanes(at.x2r - b.x2r));
        const lanes u01 = a_.u01 - b.u01, u2s = a_.u2s - b.u2s;
        const double lead = u2s[1];
        const outline& early = lead < 0 ? a_ : b;
        const lanes p01 = x01 - lead * early.u01;
        const double p2 = x2R[0] - lead * early.u2s[0], R = x2R[1];
        const lanes h01 = p01 * u01, c01 = p01 * p01;
        const double h = h01[0] + h01[1] + p2 * u2s[0];
        const double P = c01[0] + c01[1] + p2 * p2;
        const double c = P - R * R;
        const double left = latest_ - std::max(a_.u2s[1], b.u2s[1]);
        return std::min(c, c + 2 * h * left) > k * (P + fastest2_ * (lead * lead)) + error_;
    }

  private:
    using constants = filter_of<flight<N, double>>;
    static constexpr double k = 4 * (constants::c + constants::h + 0x1p-48);

    outline a_; // its radius negative
    double fastest2_;
    double latest_ = 0x1p1000, error_ = 0x1p1000;
};

// The outlines of a run's balls. In a space with periods each is where it is as seen from its shell, so that two on
// each other's lists are as far apart as their images, but for the periods that the list tells.
template <int N>
class outlines {
  public:
    outlines() = default;
    outlines(body balls, const vec<N, double>& period)
        : all_(balls), period_(period), is_periodic_(period != vec<N, double>{}) {
        for (int i = 0; i < N; ++i) {
            wider_ += 0x1p-40 * period[i];
        }
    }

    void set(body a, const flight<N, double>& f, const image_index& periods) noexcept {
        all_[a] = make(f, periods);
        fastest2_ = std::max(fastest2_, (1 + 0x1p-40) * square_of(all_[a]));
    }
    // periods: how many are to be added to the position, and later up to `most_shift` more. Sums and products are off
    // by less than 2^-51 of the position's magnitude and the period's times their number: the radius is larger by more.
    [[nodiscard]] outline make(const flight<N, double>& f, const image_index& periods) const noexcept {
        const vec<N, double>& u = f.state.velocity;
        vec<N, double> x = f.state.position;
        double places = 0, speeds = 0, most = 0;
#pragma GCC unroll 3
        for (int i = 0; i < N; ++i) {
            places += std::fabs(x[i]);
            speeds += std::fabs(u[i]);
        }
        const double radius = f.state.radius + (is_periodic_ ? 0x1p-40 * places + wider_ : 0);
        if (periods != image_index{}) {
            for (int i = 0; i < N; ++i) {
                const double count = periods[static_cast<std::size_t>(i)];
                x.component[i] += count * period_[i];
                most = std::max(most, std::fabs(count));
            }
        }
        const double magnitudes = std::fabs(f.since) + f.state.radius + places + speeds;
        if (!(magnitudes < 0x1p100 && most < most_shift)) {
            return {lanes{0, 0}, lanes{0, 0x1p300}, lanes{0, 0}, lanes{0, 0}};
        }
        return {lanes{x[0], x[1]}, lanes{third(x), radius}, lanes{u[0], u[1]}, lanes{third(u), f.since}};
    }
    [[nodiscard]] const outline& operator[](body a) const noexcept { return all_[a]; }
    // From memory.
    void fetch(body a) const noexcept { detail::fetch(all_[a]); }

    [[nodiscard]] glance<N> from(const outline& a) const noexcept { return glance<N>(a, fastest2_); }
    [[nodiscard]] vec<N, double> length_of(image_code periods) const noexcept {
        return make_vec<N>([&](int i) { return decoded_along(periods, static_cast<std::size_t>(i)) * period_[i]; });
    }

  private:
    static constexpr double most_shift = 400;
    [[nodiscard]] static double square_of(const outline& o) noexcept {
        const lanes squares = o.u01 * o.u01;
        return squares[0] + squares[1] + o.u2s[0] * o.u2s[0];
    }
    [[nodiscard]] static double third(const vec<N, double>& x) noexcept { return N == 3 ? x[N - 1] : 0; }

    std::vector<outline> all_;
    vec<N, double> period_{};
    double wider_ = 0; // added to each radius: what the roundings of periods may move
    bool is_periodic_ = false;
    double fastest2_ = 0; // at least the square of any of their speeds since the start
};

} // namespace graze::inline v0_1::detail
