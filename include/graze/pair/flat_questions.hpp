// What a decision about a ball and a flat shape asks, by name: so the procedure is compiled once for all number types
// that are slow, and a number type compiles each formula once.
#pragma once

#include <graze/formula/flat_encounter.hpp>

#include <cstddef>
#include <cstdint>

namespace graze::inline v0_1::detail {

enum class flat_name : std::uint8_t {
    square,
    speed,
    height,
    clearance_of_plane,
    inside, // of a border
    inward,
    inside_now,
    inside_at_touch,
    start, // of a feature
    end,
    foot_from_start,
    foot_from_end,
    border_h,
    border_c,
    border_discriminant,
    corner_h,
    corner_c,
    corner_discriminant,
    direction_speed,
    along_from_start,
    along_from_end,
    outside,
    touch_inward,
    outside_norm,
    behind_norm,
    count
};

// That of a formula, `count` if it has none.
template <class F>
inline constexpr flat_name name_of_formula = flat_name::count;
template <>
inline constexpr flat_name name_of_formula<way_square> = flat_name::square;
template <>
inline constexpr flat_name name_of_formula<way_speed> = flat_name::speed;
template <>
inline constexpr flat_name name_of_formula<way_clearance> = flat_name::clearance_of_plane;
template <>
inline constexpr flat_name name_of_formula<way_height> = flat_name::height;
template <>
inline constexpr flat_name name_of_formula<nearest_from_start> = flat_name::start;
template <>
inline constexpr flat_name name_of_formula<nearest_from_end> = flat_name::end;
template <>
inline constexpr flat_name name_of_formula<graze::foot_from_start> = flat_name::foot_from_start;
template <>
inline constexpr flat_name name_of_formula<graze::foot_from_end> = flat_name::foot_from_end;
template <>
inline constexpr flat_name name_of_formula<graze::border_h> = flat_name::border_h;
template <>
inline constexpr flat_name name_of_formula<graze::border_c> = flat_name::border_c;
template <>
inline constexpr flat_name name_of_formula<graze::border_discriminant> = flat_name::border_discriminant;
template <>
inline constexpr flat_name name_of_formula<graze::corner_h> = flat_name::corner_h;
template <>
inline constexpr flat_name name_of_formula<graze::corner_c> = flat_name::corner_c;
template <>
inline constexpr flat_name name_of_formula<graze::corner_discriminant> = flat_name::corner_discriminant;
template <>
inline constexpr flat_name name_of_formula<graze::direction_speed> = flat_name::direction_speed;
template <>
inline constexpr flat_name name_of_formula<touch_along_norm<nearest_from_start>> = flat_name::along_from_start;
template <>
inline constexpr flat_name name_of_formula<touch_along_norm<nearest_from_end>> = flat_name::along_from_end;
template <>
inline constexpr flat_name name_of_formula<touch_outside> = flat_name::outside;
template <>
inline constexpr flat_name name_of_formula<graze::touch_inward> = flat_name::touch_inward;
template <>
inline constexpr flat_name name_of_formula<touch_outside_norm> = flat_name::outside_norm;
template <>
inline constexpr flat_name name_of_formula<touch_behind_norm> = flat_name::behind_norm;

// An edge: border >= 0 and corner < 0. A corner: with the border along which its numbers look, or -1.
struct flat_place_name {
    int border = -1, corner = -1;
    [[nodiscard]] friend constexpr bool operator==(const flat_place_name&, const flat_place_name&) = default;
};

// Answers what is asked by name, in some number type.
template <int N>
class flat_questions {
  public:
    [[nodiscard]] virtual constexpr int sign(flat_name which, flat_place_name of) = 0;
    bool is_triangle;

  protected:
    constexpr explicit flat_questions(bool triangle) noexcept : is_triangle(triangle) {}
    constexpr ~flat_questions() = default;
};

// The number type of a decision that asks by name: it has no numbers.
struct named {};

} // namespace graze::inline v0_1::detail

namespace graze::inline v0_1 {

template <int N>
class flat_view<N, detail::named, detail::flat_questions<N>> {
    using name = detail::flat_name;
    using place_name = detail::flat_place_name;

  public:
    constexpr explicit flat_view(detail::flat_questions<N>& q) noexcept : questions_(q) {}

    static constexpr bool sees_zero = true;

    [[nodiscard]] constexpr bool is_triangle() const { return questions_.is_triangle; }
    [[nodiscard]] constexpr auto scope() const { return nullptr; }

    template <class F>
    [[nodiscard]] constexpr int of_way(F) const {
        return ask(name_of<F>());
    }
    [[nodiscard]] constexpr int of_way(inside_border x) const { return ask(name::inside, {x.k}); }
    [[nodiscard]] constexpr int of_way(inward_speed x) const { return ask(name::inward, {x.k}); }
    [[nodiscard]] constexpr int clearance_of_plane() const { return ask(name::clearance_of_plane); }

    [[nodiscard]] constexpr auto place() const { return nullptr; }
    [[nodiscard]] constexpr int inside_of(std::nullptr_t, int k) const { return ask(name::inside_now, {k}); }
    [[nodiscard]] constexpr auto touch(int) const { return nullptr; }
    [[nodiscard]] static constexpr bool is_known(std::nullptr_t) { return true; }
    [[nodiscard]] constexpr int inside_at_touch(int k, std::nullptr_t) const { return ask(name::inside_at_touch, {k}); }

    template <class F>
    [[nodiscard]] constexpr int of_feature(F, place_name of) const {
        return ask(name_of<F>(), of);
    }
    [[nodiscard]] constexpr place_name seen_from_border(int k) const { return {k, -1}; }
    [[nodiscard]] constexpr place_name seen_from_corner(int corner, int k = -1) const { return {k, corner}; }

  private:
    template <class F>
    [[nodiscard]] static consteval name name_of() {
        static_assert(detail::name_of_formula<F> != name::count, "this formula has no name");
        return detail::name_of_formula<F>;
    }
    [[nodiscard, gnu::noinline]] constexpr int ask(name which, place_name of = {}) const {
        return questions_.sign(which, of);
    }

    detail::flat_questions<N>& questions_;
};

} // namespace graze::inline v0_1
