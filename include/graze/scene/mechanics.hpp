// What a run asks of a number type. The run is written once for all of them and compares no numbers itself: the
// mechanics makes every decision that can change the sequence of events.
#pragma once

#include <graze/formula/wall_encounter.hpp>
#include <graze/number/traits.hpp>
#include <graze/scene/period.hpp>
#include <graze/scene/scene_pair.hpp>
#include <graze/shape/flight.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace graze::inline v0_1 {

// Doubles that enclose a time: it is not before lower and not after upper. Infinite where it is beyond a double.
struct time_bounds {
    double lower;
    double upper;
};

// Thrown by a mechanics that cannot tell the sign of a comparison (intervals that overlap at their precision). The run
// adds who is compared, and is left as it was before the event.
class undecided : public std::runtime_error {
  public:
    // comparison: what is not known, for instance "the order of two times". about: when, in the scene's time.
    explicit undecided(const std::string& comparison, double about)
        : std::runtime_error(comparison + " is undecided"), about_(about) {}

    // About when.
    [[nodiscard]] double about() const noexcept { return about_; }
    // The pair in question; if the order of two events was asked, the first and the second.
    [[nodiscard]] const std::optional<scene_pair>& first() const noexcept { return first_; }
    [[nodiscard]] const std::optional<scene_pair>& second() const noexcept { return second_; }

    void between(const scene_pair& x) noexcept { first_ = x; }
    void between(const scene_pair& x, const scene_pair& y) noexcept {
        first_ = x;
        second_ = y;
    }

  private:
    double about_;
    std::optional<scene_pair> first_;
    std::optional<scene_pair> second_;
};

// The questions about a ball and something that stands, a plane, a wall or a triangle (S).
//   meet      as for two balls
//   bounce    as for two balls
//   side      the sign of (x - p)·n at the time since, n being the normal of the plane or the face
//   heading   the sign of u·n
//   reach     when a point that comes nearer to the plane, or to that of the face, is in it
//   turn_back the velocity reflected in the plane or the face; position and since stay
// The last four are asked for points alone. A point may be where several planes and walls are, and the rounding of its
// position may carry it across one.
template <class M, class S>
concept mechanics_of_standing = requires(const M& m, const typename M::state& a, typename M::state& changed, const S& s,
                                         const typename M::time& t) {
    { m.meet(a, s) } -> std::same_as<std::optional<typename M::time>>;
    { m.side(a, s) } -> std::same_as<int>;
    { m.heading(a, s) } -> std::same_as<int>;
    { m.reach(a, s) } -> std::same_as<typename M::time>;
    m.bounce(changed, s, t);
    m.turn_back(changed, s);
};

// dimension  N, 2 or 3
// number     what the scene's numbers are made of; has a total order <, used to number balls by what they are
// state      a ball in flight: flight<N, number>, or more
// rounds     whether a position after a bounce may differ from where the bounce was
// exact      numbers in which sums and products of the states' numbers are those that the mechanics answers for
// as_exact   a number as one of them
// time       of an event, counted from the scene's t = 0
// start      a ball as it is at t = 0
// meet       when two balls first touch or, if they overlap and approach, the later of the two times since; looked at
//            from the later of the two times since on; empty when they recede or miss. Depends on its arguments alone:
//            a run asks the same again, and takes the balls always in one order
// order      the sign of s - t; of two events, and of an event and a number
// bounds     doubles around a time
// now        the time since which a ball flies
// about      the state rounded to doubles: each component within 2^-50 of it, relatively
// immovable  whether a ball's mass is infinite
// is_point   whether its radius is 0
// bounce     both balls advanced to their contact and resolved (a graze leaves velocities as they are); since is then
//            the time of the contact. An immovable ball's state stays as it is, its since too. At most one is immovable
// Each may throw `undecided`, after which the run has not changed.
template <class M>
concept mechanics = requires(const M& m, const ball<M::dimension, typename M::number>& b, const typename M::state& a,
                             typename M::state& changed, const typename M::time& t, const typename M::number& x) {
    requires std::copyable<typename M::state>;
    requires std::copyable<typename M::time>;
    requires std::totally_ordered<typename M::number>;
    requires graze::number<typename M::exact>;
    { M::rounds } -> std::convertible_to<bool>;
    { m.as_exact(x) } -> std::same_as<typename M::exact>;
    { m.start(b) } -> std::same_as<typename M::state>;
    { m.meet(a, a) } -> std::same_as<std::optional<typename M::time>>;
    { m.order(t, t) } -> std::same_as<int>;
    { m.order(t, x) } -> std::same_as<int>;
    { m.bounds(t) } -> std::same_as<time_bounds>;
    { m.now(a) } -> std::same_as<typename M::time>;
    { m.about(a) } -> std::same_as<flight<M::dimension, double>>;
    { m.immovable(a) } -> std::same_as<bool>;
    { m.is_point(a) } -> std::same_as<bool>;
    m.bounce(changed, changed, t);
}
&&mechanics_of_standing<M, plane<M::dimension, typename M::number>>&&
    mechanics_of_standing<M, wall<M::dimension, typename M::number>>;

// A mechanics that knows triangles too: feature says which feature of a triangle a ball meets, if it meets it.
template <class M>
concept mechanics_of_triangles = M::dimension == 3 &&
                                 mechanics_of_standing<M, triangle<typename M::number>>&& requires(
                                     const M& m, const typename M::state& a, const triangle<typename M::number>& s) {
    { m.feature(a, s) } -> std::same_as<wall_encounter>;
};

// set_back: counts a ball's time since from `by` on. Returns false and changes nothing where the state's numbers cannot
// hold that.
template <class M>
concept mechanics_of_clocks = requires(const M& m, typename M::state& changed, const typename M::number& by) {
    { m.set_back(changed, by) } -> std::same_as<bool>;
};

// The questions of scenes that have a period. An image is that of the second ball, or of a wall. [image_shift]
//   wrap       brings a ball's position to within half a period of 0 along each axis of period L > 0, or near it, and
//              returns how many periods it has taken from it: these and the position add up to the old one, exactly
//   meet       when a meets b's image
//   bounce     as for two balls, a with b's image; each stays where it is itself
//   displaced  a wall's or a triangle's image
template <class M>
concept mechanics_of_periods = requires(const M& m, const typename M::state& a, typename M::state& changed,
                                        const typename M::time& t, const vec<M::dimension, typename M::number>& period,
                                        const image_shift<M::dimension, typename M::number>& image,
                                        const wall<M::dimension, typename M::number>& w) {
    { m.wrap(changed, period) } -> std::same_as<std::array<std::int32_t, 3>>;
    { m.meet(a, a, image) } -> std::same_as<std::optional<typename M::time>>;
    m.bounce(changed, changed, image, t);
    { m.displaced(w, image) } -> std::same_as<wall<M::dimension, typename M::number>>;
};

} // namespace graze::inline v0_1
