// The fast path of contacts with planes, walls and triangles, compared with the oracle: no component is farther from
// the exact one than its bound, for pairs of every family, and however bad the first time was.
#include "../soak/soak.hpp"
#include "bounds.hpp"

#include <graze/contact/flat_contact.hpp>

#include <doctest/doctest.h>

#include <bit>

namespace flat_contact_test {

using namespace bounds;

namespace {

struct seen {
    int contacts = 0, answered = 0, wrong = 0;
    std::array<int, 5> of_kind{}; // answered; event_kind::balls stands for overlaps
};

// Compares what it is given with the exact components.
class compared {
  public:
    compared(seen& s, const std::array<oracle::surd, components>& truth) : seen_(&s), truth_(&truth) {}

    void operator()(const graze::detail::bounded<double>& x, int number, double&) const {
        const double error = x.error + graze::detail::underflow;
        look(holds(graze::detail::bounded<double>{x.high, x.low, error}, 0, of(number)));
    }
    void sum(double x, double y, int number, double&) const {
        look(oracle::compare(of(number), mpq_class(exact_number(x) + exact_number(y))) == 0);
    }
    void exact(double x, int number, double&) const { look(oracle::compare(of(number), exact_number(x)) == 0); }
    [[nodiscard]] graze::detail::component_set open_components() const { return 0; }

  private:
    static mpq_class exact_number(double x) { return bounds::exact(x); }
    [[nodiscard]] const oracle::surd& of(int number) const { return (*truth_)[static_cast<std::size_t>(number)]; }
    void look(bool right) const { seen_->wrong += right ? 0 : 1; }

    seen* seen_;
    const std::array<oracle::surd, components>* truth_;
};

struct same_clock {
    graze::detail::bounded<double> operator()(const graze::detail::bounded<double>& time) const { return time; }
};

// At this feature: a wall's, or a plane's face.
template <int N>
void compare(seen& s, families::random& r, const double* row, graze::detail::event_kind kind, int index,
             const oracle::answer& met, const oracle::wall_contact<N>& contact) {
    const auto truth = listed(contact);
    graze::wall_contact<N> unused;
    const same_clock clock;
    const bool overlap = met.what == oracle::encounter::overlap;
    const double time = overlap ? 0 : rough_time(r, truth[0]);
    const graze::detail::flat_contact_near<N, double, same_clock> near{&unused, kind, index, row, time, &clock};
    ++s.contacts;
    const bool fused = near.template given_to<true>(compared(s, truth)) == 0;
    const bool dekker = near.template given_to<false>(compared(s, truth)) == 0;
    if (fused && dekker) {
        ++s.answered;
        ++s.of_kind[static_cast<std::size_t>(overlap ? graze::detail::event_kind::balls : kind)];
    }
}

// Whether the fast path is asked about it.
bool is_asked(const oracle::answer& met) {
    return met.what == oracle::encounter::hit || (met.what == oracle::encounter::overlap && met.face);
}

template <int N>
void look(seen& s, families::random& r, const graze::ball<N>& b, const graze::plane<N>& p) {
    const auto met = oracle::meet(b, p);
    if (is_asked(met)) {
        double row[graze::detail::event<N, double>::capacity];
        graze::detail::ball_and_plane<N>::pack(row, b, p);
        compare<N>(s, r, row, graze::detail::event_kind::plane, 0, met, oracle::contact(b, p, met));
    }
}

// A wall or a triangle.
template <int N, class Shape>
void look(seen& s, families::random& r, const graze::ball<N>& b, const Shape& shape) {
    const auto met = oracle::meet(b, shape);
    if (is_asked(met)) {
        const oracle::feature where = met.where();
        const int index = met.face ? 0 : std::countr_zero(met.edges != 0 ? met.edges : met.corners);
        const auto at = static_cast<graze::feature>(where);
        double row[graze::detail::event<N, double>::capacity];
        graze::detail::ball_and_wall<N>::pack(row, b, shape);
        compare<N>(s, r, row, graze::detail::kind_of<N>(at),
                   graze::feature_number(at, index, std::is_same_v<Shape, graze::triangle<>>), met,
                   oracle::contact(b, shape, met, where, index));
    }
}

template <int N>
void look(seen& s, families::random& r, const families::pair_of_doubles<N>& pair) {
    if (pair.kind == families::pair_kind::ball_plane) {
        look(s, r, pair.a, pair.plane);
    } else if (pair.kind == families::pair_kind::ball_wall) {
        look(s, r, pair.a, pair.wall);
        if constexpr (N == 3) {
            look(s, r, pair.a, graze::triangle<>{pair.wall.corner, pair.wall.edge});
        }
    }
}

seen look_at(const families::family& f) {
    seen s;
    for (std::uint64_t i = 0; i < 200; ++i) {
        families::random r(7, i);
        look(s, r, f.draw<2>(17, i));
        look(s, r, f.draw<3>(17, i));
    }
    return s;
}

} // namespace

TEST_CASE("bounds of contacts with planes, walls and triangles hold") {
    std::array<int, 5> of_kind{};
    for (const families::family& f : soak::families_drawn) {
        CAPTURE(f.name);
        const seen s = look_at(f);
        CHECK(s.wrong == 0);
        if (f.name == "long_edges" || f.name == "generic_wall") {
            CHECK(s.contacts > 100);
            CHECK(s.answered > s.contacts / 3); // for the others the time was too rough
        }
        for (std::size_t k = 0; k < of_kind.size(); ++k) {
            of_kind[k] += s.of_kind[k];
        }
        MESSAGE(f.name << ": " << s.contacts << " contacts, " << s.answered << " bounded");
    }
    for (const int answered : of_kind) {
        CHECK(answered > 50);
    }
}

} // namespace flat_contact_test
