// graze, and the formulas in the number types of the machine.
#include "contestant.hpp"

#include <graze/graze.hpp>
#include <graze/solve.hpp>
#ifdef GRAZE_PEERS_FLOAT128
#include <graze/number/adapter/float128.hpp>
#endif

#include <algorithm>

namespace peers {

namespace {

// A box or an edge is met when the first of its walls is.
template <int N>
class graze_contestant final : public contestant {
  public:
    explicit graze_contestant(const scenes<N>& s) : scenes_(s) {}

    [[nodiscard]] std::optional<double> answer(std::size_t i) const override {
        const scene<N>& s = scenes_.all[i];
        if (s.walls.empty()) {
            const auto time = graze::time_of_impact(s.a, s.b);
            return time ? std::optional(static_cast<double>(*time)) : std::nullopt;
        }
        std::optional<double> first; // rounding keeps the order: the first of the rounded times is the rounded first
        for (const auto& w : s.walls) {
            const auto time = graze::time_of_impact(s.a, w);
            if (time && !(first && time->enclosure().lower() > *first)) {
                const auto rounded = static_cast<double>(*time);
                first = first ? std::min(*first, rounded) : rounded;
            }
        }
        return first;
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

// The same in double against walls.
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

// The first and the last that a programmer would write.
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
