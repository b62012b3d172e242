// The five answers, for every combination of the three signs, written out.
#include <graze/formula/encounter.hpp>

namespace {

using namespace graze;

constexpr encounter of(int h, int c, int d) {
    return encounter_of([=] { return h; }, [=] { return c; }, [=] { return d; });
}

// h >= 0: recede, whatever c and D are.
constexpr bool recedes(int h) {
    for (int c = -1; c <= 1; ++c) {
        for (int d = -1; d <= 1; ++d) {
            if (of(h, c, d) != encounter::recede) {
                return false;
            }
        }
    }
    return true;
}
static_assert(recedes(0) && recedes(1));

// h < 0 and c < 0: overlap, whatever D is; c = 0, touching, is apart.
static_assert(of(-1, -1, -1) == encounter::overlap && of(-1, -1, 0) == encounter::overlap &&
              of(-1, -1, 1) == encounter::overlap);
static_assert(of(-1, 0, -1) == encounter::miss && of(-1, 1, -1) == encounter::miss);
static_assert(of(-1, 0, 0) == encounter::graze && of(-1, 1, 0) == encounter::graze);
static_assert(of(-1, 0, 1) == encounter::hit && of(-1, 1, 1) == encounter::hit);

// A sign is not asked for if the signs before it decide: otherwise these constant expressions would throw.
constexpr auto unasked = []() -> int { throw 0; };
static_assert(encounter_of([] { return 1; }, unasked, unasked) == encounter::recede);
static_assert(encounter_of([] { return -1; }, [] { return -1; }, unasked) == encounter::overlap);

static_assert(is_collision(encounter::overlap) && is_collision(encounter::graze) && is_collision(encounter::hit));
static_assert(!is_collision(encounter::recede) && !is_collision(encounter::miss));

} // namespace
