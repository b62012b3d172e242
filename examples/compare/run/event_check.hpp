// The certified run's second way: checks every event that the run reports.
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

// The check contradicts the run: one of the two has a bug.
struct refuted_event : std::logic_error {
    refuted_event(const std::string& who, const std::string& what, double about)
        : std::logic_error("the certified run is wrong: " + who + " " + what +
                           ", at about t = " + std::to_string(about)) {}
};

// Follows a run from its start. It checks of each event that the two touch at that time and place and come closer; that
// they part by the laws (momentum, energy, no change across the normal); and that neither had met anything else on its
// way there. It throws graze::undecided if an enclosure leaves a check open, and refuted_event if a check fails. Three
// things are conventions and not checked: the order of simultaneous events that share a ball, what a point does at a
// wall's border, and a touch at a possible inner edge.
template <int N>
class event_check {
  public:
    using flight = graze::flight<N, certified>;
    using image = whole_image<N>;

    explicit event_check(const owned_scene<N, certified>& scene);

    // b: the second ball's flight from then on; null if a ball meets something else. Events that share a ball come in
    // the order of time.
    void event(const graze::scene_pair& who, const certified& t, const flight& a, const flight* b);
    // Checks that nothing else happens until t, or ever after.
    void end(const certified& t);
    void end_of_all();

  private:
    struct side {
        std::size_t standing;
        int sign;
    };
    struct mover {
        flight now, coarse; // coarse: the same flight in few bits
        std::optional<flight> before;
        std::optional<graze::scene_pair> last;
        std::vector<side> sides; // for a point: on which sides of what it touches it was before
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
    // f(what has this number, or its image).
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
    // Which image of the event's second partner is met: one that is touched at t or, without any, the nearest.
    [[nodiscard]] image image_at(const graze::scene_pair& who, const certified& t) const;
    [[nodiscard]] bool is_point(const mover& m) const { return m.now.state.radius.certain_sign() == 0; }

    void check_place(const graze::scene_pair& who, const image& periods, const certified& t) const;
    void check_laws(const graze::scene_pair& who, const image& periods, const certified& t, const flight& a,
                    const flight* b) const;
    // event, periods: the image of the event's second partner is met at t.
    void check_way(int a, const certified& t, const graze::scene_pair* event, const image& periods = {});
    void check_pair(int a, int b, const certified* t, const image* met) const;
    void check_standing(int a, std::size_t b, const certified* t, const image* met) const;
    void check_point(int a, std::size_t b, const certified* t, bool meet) const;
    [[nodiscard]] bool may_touch_inner_edge(const mover& x, std::size_t b, const image& periods,
                                            const certified* t) const;
    [[nodiscard]] bool keeps_aside(const mover& x) const;
    [[nodiscard]] int side_along(const mover& x, const vector_of<N>& normal) const;
    void note_sides(int a, const certified& t, const graze::scene_pair& who);
    // Compares a's way from t on with the ways of balls whose later events have already been checked: each until its
    // event, unless that is certainly not after t.
    void check_overtaken(int a, const certified& t, const graze::scene_pair& who) const;
    void start(int a, const flight& f, const certified& t, const graze::scene_pair& who);
};

} // namespace compare::run
