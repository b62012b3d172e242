// The second opinion of the certified run on every event that it tells.
#pragma once

#include "clearance.hpp"
#include "event_images.hpp"
#include "scene_in.hpp"

#include <graze/scene/mechanics.hpp>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace compare::run {

// The check refutes what a run said: there is an error in the one or the other.
struct refuted_event : std::logic_error {
    refuted_event(const std::string& who, const std::string& what, double about)
        : std::logic_error("the certified run is wrong: " + who + " " + what +
                           ", at about t = " + std::to_string(about)) {}
};

// Follows a run from its start. Of each event it checks that the two touch there and then, coming closer; that they
// part by the laws (momentum, energy, nothing across the normal); and that on their ways to it neither had met anything
// else. A true number that an enclosure leaves open throws graze::undecided, one that contradicts throws refuted_event.
// By convention, and so not checked: the order of events that share a ball at one instant, what becomes of a point on a
// wall's border, and a touch at what may be an inner edge.
template <int N>
class event_check {
  public:
    using flight = graze::flight<N, certified>;
    using image = whole_image<N>;

    explicit event_check(const owned_scene<N, certified>& scene);

    // b: of two balls, the second one's flight from then on. Told in the order of time where events share a ball.
    void event(const graze::scene_pair& who, const certified& t, const flight& a, const flight* b);
    // That nothing else happened until then, or will ever happen.
    void end(const certified& t);
    void end_of_all();

  private:
    struct side {
        std::size_t standing;
        int sign;
    };
    struct mover {
        flight now, coarse; // the same in few bits
        std::optional<flight> before;
        std::optional<graze::scene_pair> last;
        std::vector<side> sides; // of a point: from which it came to where it is now
        bool immovable, at_rest;
    };

    const owned_scene<N, certified>& scene_;
    std::vector<mover> movers_;
    double size_ = 0; // the largest coordinate
    image_space<N> space_;

    // Planes, walls and triangles are numbered in this order.
    [[nodiscard]] std::size_t first_triangle() const { return scene_.planes.size() + scene_.walls.size(); }
    [[nodiscard]] std::size_t standing() const { return first_triangle() + scene_.triangles.size(); }
    [[nodiscard]] std::size_t standing_of(const graze::scene_pair& who) const;
    [[nodiscard]] graze::scene_pair named(int a, std::size_t standing) const;
    // f(what stands, or that image of it).
    template <class F>
    auto with_standing(std::size_t standing, F f, const image& periods = {}) const {
        if constexpr (N == 3) {
            if (standing >= first_triangle()) {
                return f(space_.image_of(scene_.triangles[standing - first_triangle()], periods));
            }
        }
        return standing < scene_.planes.size()
                   ? f(scene_.planes[standing])
                   : f(space_.image_of(scene_.walls[standing - scene_.planes.size()], periods));
    }
    // Of which image of the second one of an event that must be: one that is touched then, or the nearest to it.
    [[nodiscard]] image image_at(const graze::scene_pair& who, const certified& t) const;
    [[nodiscard]] bool is_point(const mover& m) const { return m.now.state.radius.certain_sign() == 0; }

    void check_place(const graze::scene_pair& who, const image& periods, const certified& t) const;
    void check_laws(const graze::scene_pair& who, const image& periods, const certified& t, const flight& a,
                    const flight* b) const;
    // met: that image is met at t.
    void check_way(int a, const certified& t, const graze::scene_pair* event, const image& periods = {});
    void check_pair(int a, int b, const certified* t, const image* met) const;
    void check_standing(int a, std::size_t b, const certified* t, const image* met) const;
    void check_point(int a, std::size_t b, const certified* t, bool meet) const;
    [[nodiscard]] bool may_touch_inner_edge(const mover& x, std::size_t b, const image& periods,
                                            const certified* t) const;
    [[nodiscard]] bool keeps_aside(const mover& x) const;
    [[nodiscard]] int side_along(const mover& x, const vector_of<N>& normal) const;
    void note_sides(int a, const certified& t, const graze::scene_pair& who);
    // Of others that have been told of already, though their events are not certainly earlier than t: their ways until
    // then beside a's from t on.
    void check_overtaken(int a, const certified& t, const graze::scene_pair& who) const;
    void start(int a, const flight& f, const certified& t, const graze::scene_pair& who);
};

} // namespace compare::run
