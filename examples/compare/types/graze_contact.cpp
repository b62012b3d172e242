// graze's own results beside the formulas in number types: exact decisions and correctly rounded times, positions and
// velocities, by graze::collide. They are listed as the single form lagrange/stable.
#include "../measure.hpp"
#include "types.hpp"

#include <graze/collide.hpp>
#include <graze/number/floating.hpp>

#include <limits>

namespace compare::types {

namespace {

// Receives contacts in a way that the compiler cannot see through, so that none is optimised away.
template <int N, class T>
class contact_sink {
  public:
    virtual ~contact_sink() = default;
    virtual void take(const graze::contact<N, T>&) {}
    virtual void take(const graze::wall_contact<N, T>&) {}
};

template <int N, class T>
class reading_sink final : public contact_sink<N, T> {
  public:
    explicit reading_sink(answer_sink& to) : to_(to) {}
    void take(const graze::contact<N, T>& c) override {
        reader<T>::read(c.time, to_.time());
        read_position(c.position_a, to_);
        read_position(c.position_b, to_);
        read_velocity(c.velocity_a, to_);
        read_velocity(c.velocity_b, to_);
    }
    void take(const graze::wall_contact<N, T>& c) override {
        reader<T>::read(c.time, to_.time());
        read_position(c.position, to_);
        read_velocity(c.velocity, to_);
    }

  private:
    answer_sink& to_;
};

template <class T>
[[nodiscard]] T mass_of(const exact_view& inverse) {
    return inverse.is_zero() ? std::numeric_limits<T>::infinity()
                             : value_of<T>(inverse.inverse_rounded(format_of<T>()));
}

template <int N, class T>
class contact_solver final : public solver {
  public:
    explicit contact_solver(const pair_list& list) {
        for (const pair_numbers& pair : list.pairs) {
            inputs_.push_back(convert_pair<T, N>(pair));
            if (pair.kind == pair_kind::ball_ball) {
                inputs_.back().a.mass = mass_of<T>(pair.numbers[2 * N + 1]);
                inputs_.back().b.mass = mass_of<T>(pair.numbers[4 * N + 3]);
            }
        }
    }

    [[nodiscard]] std::vector<method> methods() const override {
        return {{graze::variant::lagrange, graze::root_form::stable}};
    }

    void run(std::size_t, std::size_t count) override {
        for (std::size_t i = 0; i < count; ++i) {
            try {
                collide(inputs_[i], *forgetting_);
            } catch (const std::domain_error&) { // a number that T cannot hold
            }
        }
    }

    outcome answer_to(std::size_t, std::size_t pair, answer_sink& to) override {
        try {
            if (decide(inputs_[pair], to)) {
                reading_sink<N, T> sink(to);
                collide(inputs_[pair], sink);
            }
        } catch (const std::domain_error&) {
            return outcome::failed;
        }
        return outcome::answered;
    }

  private:
    static void collide(const input<N, T>& pair, contact_sink<N, T>& sink) {
        const auto give = [&](const auto& contact) {
            if (contact) {
                sink.take(*contact);
            }
        };
        switch (pair.kind) {
        case pair_kind::ball_ball:
            give(graze::collide(pair.a, pair.b));
            break;
        case pair_kind::ball_plane:
            give(graze::collide(pair.a, pair.plane));
            break;
        case pair_kind::ball_wall:
            give(graze::collide(pair.a, pair.wall));
            break;
        case pair_kind::ball_triangle:
            if constexpr (N == 3) {
                give(graze::collide(pair.a, pair.triangle));
            }
            break;
        }
    }

    // Decides what a contact does not say: the encounter, and the edge or corner.
    static bool decide(const input<N, T>& pair, answer_sink& to) {
        switch (pair.kind) {
        case pair_kind::ball_ball:
            return to.decided(graze::classify(pair.a, pair.b));
        case pair_kind::ball_plane:
            return to.decided(graze::classify(pair.a, pair.plane));
        case pair_kind::ball_wall:
            return decide(graze::classify_feature(pair.a, pair.wall), to);
        case pair_kind::ball_triangle:
            if constexpr (N == 3) {
                return decide(graze::classify_feature(pair.a, pair.triangle), to);
            }
        }
        return false;
    }
    static bool decide(const graze::wall_encounter& met, answer_sink& to) {
        return to.decided(met.what, met.where, met.index);
    }

    std::vector<input<N, T>> inputs_;
    std::unique_ptr<contact_sink<N, T>> forgetting_ = std::make_unique<contact_sink<N, T>>();
};

} // namespace

measurable of_graze() {
    measurable m = measurable_type<double>("graze", false, "graze::collide: decisions exact, numbers rounded once");
    m.information.name = "graze";
    m.prepare = &prepare_with<contact_solver, double>;
    return m;
}

} // namespace compare::types
