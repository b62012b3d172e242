// graze's own results beside the formulas in number types: exact decisions, and correctly rounded times, positions and
// velocities, by graze::collide. Its single form is listed as lagrange/stable.
#include "../measure.hpp"
#include "types.hpp"

#include <graze/collide.hpp>
#include <graze/number/floating.hpp>

#include <limits>

namespace compare::types {

namespace {

// Where contacts go, out of the compiler's sight.
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
    reading_sink(answer& given, const truth& right) : given_(given), right_(right) {}
    void take(const graze::contact<N, T>& c) override {
        given_.time = reader<T>::read(c.time, right_.time);
        read_vector(given_.positions, c.position_a, right_.positions);
        read_vector(given_.positions, c.position_b, right_.positions);
        read_vector(given_.velocities, c.velocity_a, right_.velocities);
        read_vector(given_.velocities, c.velocity_b, right_.velocities);
    }
    void take(const graze::wall_contact<N, T>& c) override {
        given_.time = reader<T>::read(c.time, right_.time);
        read_vector(given_.positions, c.position, right_.positions);
        read_vector(given_.velocities, c.velocity, right_.velocities);
    }

  private:
    answer& given_;
    const truth& right_;
};

template <class T>
[[nodiscard]] T mass_of(const exact& inverse) {
    return inverse == 0 ? std::numeric_limits<T>::infinity() : convert<T>(exact(1 / inverse));
}

template <int N, class T>
class contact_solver final : public solver {
  public:
    explicit contact_solver(const std::vector<problem<N>>& problems) {
        for (const problem<N>& pair : problems) {
            inputs_.push_back(convert_pair<T>(pair));
            if (pair.kind == pair_kind::ball_ball) {
                inputs_.back().a.mass = mass_of<T>(pair.a.inverse_mass);
                inputs_.back().b.mass = mass_of<T>(pair.b.inverse_mass);
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
            } catch (const std::domain_error&) { // one that T cannot hold
            }
        }
    }

    [[nodiscard]] answer answer_to(std::size_t, std::size_t pair, const truth& right) override {
        answer given;
        try {
            decide(inputs_[pair], given);
            reading_sink<N, T> sink(given, right);
            if (same_decision(given, right)) {
                collide(inputs_[pair], sink);
            }
        } catch (const std::domain_error&) {
            given.how = outcome::failed;
        }
        return given;
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
        }
    }

    // The decisions that a contact does not contain: the encounter, and which edge or corner.
    static void decide(const input<N, T>& pair, answer& given) {
        switch (pair.kind) {
        case pair_kind::ball_ball:
            given.what = graze::classify(pair.a, pair.b);
            break;
        case pair_kind::ball_plane:
            given.what = graze::classify(pair.a, pair.plane);
            break;
        case pair_kind::ball_wall:
            const graze::wall_encounter met = graze::detail::decide_wall(pair.a, pair.wall, graze::ignore_stage{});
            given.what = met.what;
            given.where = met.where;
            given.index = met.index;
            break;
        }
    }

    std::vector<input<N, T>> inputs_;
    std::unique_ptr<contact_sink<N, T>> forgetting_ = std::make_unique<contact_sink<N, T>>();
};

} // namespace

measurable of_graze() {
    measurable m = measurable_type<double>("graze", false, "graze::collide: decisions exact, numbers rounded once");
    m.information.name = "graze";
    m.prepare = [](const group& pairs) -> std::unique_ptr<solver> {
        if (const auto* plane = std::get_if<group_pairs<2>>(&pairs.pairs)) {
            return std::make_unique<contact_solver<2, double>>(plane->problems);
        }
        return std::make_unique<contact_solver<3, double>>(std::get<group_pairs<3>>(pairs.pairs).problems);
    };
    return m;
}

} // namespace compare::types
