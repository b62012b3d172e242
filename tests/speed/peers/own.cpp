// graze, and the formulas in the machine's number types.
#include "contestant.hpp"

#include <graze/graze.hpp>
#include <graze/solve.hpp>
#ifdef GRAZE_PEERS_FLOAT128
#include <graze/number/adapter/float128.hpp>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace peers {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// A ball and the slab around a box's wall: everything within r of the wall's plane, which is across an axis. reached: a
// time not later than that at which the ball reaches the slab, and so touches the wall; roundings are below 2^-50 of
// `height`.
struct slab {
    double height, speed, reached;

    slab(double x, double plane, double u, double r) : height(std::fabs(x - plane)), speed(std::fabs(u)), reached(0) {
        const double gap = height * (1 - 0x1p-50) - r;
        if (gap > 0) {
            reached = (x < plane) == (u > 0) && speed > 0 ? gap / speed * (1 - 0x1p-50) : never;
        }
    }
};

// When a ball first touches a box: 2N walls across the axes, two for each axis.
//
// Nothing of the box is met before the last of the slabs is reached. Of that slab's walls, the one on the ball's side
// is asked first. If the centre is by then inside the box along some axis, the walls across that axis are not touched
// first. So a ball that comes down on a side takes one question. No wall is asked whose slab is reached after the
// earliest hit so far, and no later time is rounded.
template <int N>
class box_question {
  public:
    box_question(const graze::ball<N>& b, const std::vector<graze::wall<N>>& walls) : b_(b), walls_(walls) {}

    [[nodiscard]] std::optional<double> operator()() {
        int last = 0;
        std::array<std::size_t, N> near{};
        std::array<double, N> reached{};
        for (int i = 0; i < N; ++i) {
            const auto at = static_cast<std::size_t>(i);
            near[at] = 2 * at + (b_.position[i] > walls_[2 * at + 1].corner[i] ? 1 : 0);
            const bool is_beside = b_.position[i] < walls_[2 * at].corner[i] || near[at] % 2 == 1;
            reached[at] = is_beside ? slab_of(near[at]).reached : 0;
            last = reached[at] > reached[static_cast<std::size_t>(last)] ? i : last;
        }
        const double time = reached[static_cast<std::size_t>(last)];
        if (time == never) {
            return std::nullopt;
        }
        if (time > 0) {
            ask(near[static_cast<std::size_t>(last)]);
        }
        for (int i = 0; i < N; ++i) {
            if (time == 0 || (i != last && !is_inside(i, near[static_cast<std::size_t>(last)], time))) {
                ask(2 * static_cast<std::size_t>(i));
                ask(2 * static_cast<std::size_t>(i) + 1);
            }
        }
        return first_ < never ? std::optional(first_) : std::nullopt;
    }

  private:
    [[nodiscard]] slab slab_of(std::size_t wall) const {
        const int i = static_cast<int>(wall / 2);
        return {b_.position[i], walls_[wall].corner[i], b_.velocity[i], b_.radius};
    }
    // Whether the centre is certainly inside along axis i when the slab of a wall is reached, near `time`.
    [[nodiscard]] bool is_inside(int i, std::size_t wall, double time) const {
        const auto at = static_cast<std::size_t>(i);
        const double low = walls_[2 * at].corner[i], high = walls_[2 * at + 1].corner[i];
        const double x = b_.position[i], u = b_.velocity[i], there = x + u * time;
        const slab s = slab_of(wall);
        const double off =
            0x1p-40 * (std::fabs(x) + std::fabs(low) + std::fabs(high) + std::fabs(u) * (time + s.height / s.speed));
        return low + off < there && there < high - off;
    }
    void ask(std::size_t wall) {
        const double reached = slab_of(wall).reached;
        if (reached == never || reached > first_) {
            return;
        }
        const auto time = graze::time_of_impact(b_, walls_[wall]);
        if (time && time->enclosure().lower() <= first_) {
            first_ = std::min(first_, static_cast<double>(*time)); // rounding preserves the order of times
        }
    }

    const graze::ball<N>& b_;
    const std::vector<graze::wall<N>>& walls_;
    double first_ = never;
};

template <int N>
class graze_contestant final : public contestant {
  public:
    explicit graze_contestant(const scenes<N>& s) : scenes_(s) {}

    [[nodiscard]] std::optional<double> answer(std::size_t i) const override {
        const scene<N>& s = scenes_.all[i];
        const auto rounded = [](const auto& time) {
            return time ? std::optional(static_cast<double>(*time)) : std::nullopt;
        };
        return s.walls.empty()       ? rounded(graze::time_of_impact(s.a, s.b))
               : s.walls.size() == 1 ? rounded(graze::time_of_impact(s.a, s.walls.front()))
                                     : box_question<N>(s.a, s.walls)();
    }

  private:
    scenes<N> scenes_;
};

template <class T, int N>
graze::vec<N, T> as(const graze::vec<N, double>& x) {
    return graze::make_vec<N>([&](int i) { return T(x[i]); });
}

// graze::solve in T, for two balls.
template <class T, graze::variant V, graze::root_form F, int N>
class formula_contestant final : public contestant {
  public:
    explicit formula_contestant(const scenes<N>& s) {
        for (const auto& x : s.all) {
            a_.push_back({as<T, N>(x.a.position), as<T, N>(x.a.velocity), T(x.a.radius), T(1)});
            b_.push_back({as<T, N>(x.b.position), as<T, N>(x.b.velocity), T(x.b.radius), T(1)});
        }
    }

    [[nodiscard]] std::optional<double> answer(std::size_t i) const override {
        const auto s = graze::solve<V, F>(a_[i], b_[i]);
        return graze::is_collision(s.what) ? std::optional(static_cast<double>(s.time)) : std::nullopt;
    }

  private:
    std::vector<graze::ball<N, T>> a_, b_;
};

// The same in double for walls.
template <graze::variant V, graze::root_form F, int N>
class wall_contestant final : public contestant {
  public:
    explicit wall_contestant(const scenes<N>& s) : scenes_(s) {}

    [[nodiscard]] std::optional<double> answer(std::size_t i) const override {
        std::optional<double> first;
        for (const auto& w : scenes_.all[i].walls) {
            const auto s = graze::solve<V, F>(scenes_.all[i].a, w);
            if (graze::is_collision(s.what) && (!first || s.time < *first)) {
                first = s.time;
            }
        }
        return first;
    }

  private:
    scenes<N> scenes_;
};

// The first and the last version that a programmer would write.
template <class T, graze::variant V>
inline constexpr bool takes_walls = std::is_same_v<T, double> &&
                                    (V == graze::variant::textbook || V == graze::variant::lagrange);

template <class T, graze::variant V, graze::root_form F>
std::unique_ptr<contestant> prepare_formula(const trial& t) {
    return std::visit(
        [&]<int N>(const scenes<N>& s) -> std::unique_ptr<contestant> {
            if constexpr (takes_walls<T, V>) {
                if (t.what != thing::ball) {
                    return std::make_unique<wall_contestant<V, F, N>>(s);
                }
            }
            return std::make_unique<formula_contestant<T, V, F, N>>(s);
        },
        t.exactly);
}

constexpr const char* formula_promise = "nothing but the formulas as they are";

template <class T>
void add_formulas(std::vector<entry>& all) {
    using graze::root_form;
    using graze::variant;
    const auto add = [&]<variant V, root_form F>(const char* v, const char* f) {
        all.push_back({graze::number_traits<T>::name, "", "graze::solve, one type for everything", formula_promise,
                       prepare_formula<T, V, F>, graze::number_traits<T>::digits, true, takes_walls<T, V>, v, f});
    };
    add.template operator()<variant::textbook, root_form::printed>("textbook", "printed");
    add.template operator()<variant::halved, root_form::stable>("halved", "stable");
    if constexpr (graze::has_variant<variant::kahan, T>) {
        add.template operator()<variant::kahan, root_form::stable>("kahan", "stable");
    }
    add.template operator()<variant::lagrange, root_form::stable>("lagrange", "stable");
}

} // namespace

std::vector<entry> own_entries() {
    std::vector<entry> all;
    all.push_back({"graze", "", "time_of_impact and its conversion to double; boxes and edges as their walls",
                   "the decision exact, the time correctly rounded", [](const trial& t) -> std::unique_ptr<contestant> {
                       return std::visit(
                           []<int N>(const scenes<N>& s) -> std::unique_ptr<contestant> {
                               return std::make_unique<graze_contestant<N>>(s);
                           },
                           t.exactly);
                   }});
    add_formulas<double>(all);
    add_formulas<float>(all);
    add_formulas<long double>(all);
#ifdef GRAZE_PEERS_FLOAT128
    add_formulas<__float128>(all);
#endif
    return all;
}

} // namespace peers
