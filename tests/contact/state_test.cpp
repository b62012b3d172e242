// Contacts and rounded times have the same bits in every rounding direction, whether or not subnormals are flushed.
#include "../environments/state.hpp"
#include "../soak/soak.hpp"
#include "answers.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace contact_state_test {

using namespace environments;

namespace {

// The bits of every number of a contact.
class bits {
  public:
    void add(double x) { bits_.push_back(std::bit_cast<std::uint64_t>(x)); }
    void add(float x) { bits_.push_back(std::bit_cast<std::uint32_t>(x)); }
    template <int N, class T>
    void add(const graze::vec<N, T>& x) {
        for (int i = 0; i < N; ++i) {
            add(x.component[i]);
        }
    }
    template <int N, class T>
    void add(const graze::contact<N, T>& c) {
        add(c.time);
        add(c.position_a);
        add(c.position_b);
        add(c.normal);
        add(c.velocity_a);
        add(c.velocity_b);
    }
    template <int N, class T>
    void add(const graze::wall_contact<N, T>& c) {
        add(c.time);
        add(c.position);
        add(c.point);
        add(c.normal);
        add(c.velocity);
    }
    friend bool operator==(const bits&, const bits&) = default;

  private:
    std::vector<std::uint64_t> bits_;
};

struct seen {
    bits values;
    int contacts = 0;
    int by_doubles = 0; // answers without integers
};

template <int N, class T, class X, class Y>
void ask(seen& s, const X& x, const Y& y) {
    const auto answer = answers::of(x, y);
    if (answer.contact) {
        s.values.add(*answer.contact);
        s.values.add(static_cast<T>(*answer.time));
        s.values.add(answer.time->lower());
        s.values.add(answer.time->upper());
        ++s.contacts;
        s.by_doubles += answer.given_by == graze::stage::filter ? 1 : 0;
    }
}

template <int N>
void ask_every_family(seen& s) {
    for (const families::family& family : soak::families_drawn) {
        for (std::uint64_t index = 0; index < 40; ++index) {
            const auto pair = family.draw<N>(9, index);
            if (pair.kind == families::pair_kind::ball_ball) {
                ask<N, double>(s, pair.a, pair.b);
            } else if (pair.kind == families::pair_kind::ball_plane) {
                ask<N, double>(s, pair.a, pair.plane);
            } else {
                ask<N, double>(s, pair.a, pair.wall);
            }
        }
    }
}

seen ask_all() {
    seen s;
    ask_every_family<2>(s);
    ask_every_family<3>(s);
    return s;
}

} // namespace

TEST_CASE("contacts do not depend on the state of the floating-point unit") {
    save_state();
    const seen expected = ask_all();
    CHECK(expected.contacts > 1000);
    CHECK(expected.by_doubles > 200);
    for (const rounding direction : {rounding::nearest, rounding::upward, rounding::downward, rounding::towards_zero}) {
        for (const bool flush : {false, true}) {
            if (flush && !can_flush()) {
                continue;
            }
            const bool set = set_state(direction, flush);
            const seen found = ask_all();
            restore_state();
            REQUIRE(set);
            CAPTURE(name_of(direction));
            CAPTURE(flush);
            CHECK(found.contacts == expected.contacts);
            CHECK(found.values == expected.values);
        }
    }
}

// τ = x - y - R with a subnormal y, just below the middle between two floats. If y were read as 0, τ would round to the
// later one.
TEST_CASE("a subnormal float takes part in a time where subnormals count as zero") {
    const graze::ball<2, float> a{{0x1p-90F + 0x1p-103F, 0}, {-1, 0}, 0x1p-90F, 1};
    const graze::ball<2, float> b{{0x1p-128F + 0x1p-149F, 0}, {0, 0}, 0, 1};
    for (const bool flush : {false, true}) {
        if (flush && !can_flush()) {
            continue;
        }
        save_state();
        const bool set = set_state(rounding::nearest, flush);
        const auto time = static_cast<float>(answers::of(a, b).time.value());
        restore_state();
        REQUIRE(set);
        CAPTURE(flush);
        CHECK(time == 0x1.fffffep-104F);
    }
}

// Along y the balls differ by a subnormal, and so does the normal from 0: R is 1.
TEST_CASE("a subnormal double takes part in a contact where subnormals count as zero") {
    const graze::ball<2> a{{4, 0x3p-1074}, {-1, 0}, 0.5, 1};
    const graze::ball<2> b{{0, 0}, {0, 0}, 0.5, 1};
    for (const bool flush : {false, true}) {
        if (flush && !can_flush()) {
            continue;
        }
        save_state();
        const bool set = set_state(rounding::nearest, flush);
        const auto contact = answers::of(a, b).contact.value();
        restore_state();
        REQUIRE(set);
        CAPTURE(flush);
        CHECK(contact.normal[1] == 0x3p-1074);
        CHECK(contact.velocity_a[1] == 0x3p-1074);
    }
}

} // namespace contact_state_test
