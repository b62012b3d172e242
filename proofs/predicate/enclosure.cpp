// Two enclosures of times are apart only if no number is in both.
#include <graze/time/enclosure.hpp>

namespace {

using graze::detail::enclosure;

constexpr bool apart(const enclosure& x, const enclosure& y) { return x.is_apart_from(y) && y.is_apart_from(x); }
constexpr bool together(const enclosure& x, const enclosure& y) { return !x.is_apart_from(y) && !y.is_apart_from(x); }

constexpr enclosure now{0, 0}; // a touch or an overlap

static_assert(apart({1, 0.25}, {1.75, 0.25}) && together({1, 0.25}, {1.25, 0.25}));
static_assert(together({1, 0.25}, {1.5, 0.25}), "they share an end");
static_assert(apart({1, 0.5}, {2, 0.25}) && apart({1, 0.25}, {2, 0.5}), "both errors count");
static_assert(together({1, 0.875}, {2, 0.25}) && together({1, 0.25}, {2, 0.875}), "both errors count");

static_assert(together(now, now) && apart(now, {0.5, 0.25}) && together(now, {0.25, 0.25}));
static_assert(now.is_point() && enclosure{1, 0}.is_point() && !enclosure{0, 0x1p-1074}.is_point());

// An enclosure with an unknown error is apart from none.
static_assert(!enclosure{}.is_known() && now.is_known());
static_assert(together({}, now) && together({}, {}) && together({}, {enclosure::unknown, 0}));

} // namespace
