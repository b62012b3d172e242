// Contacts in double words, compared with the oracle: what they decide is right, and no component or time is farther
// from the exact one than its bound, with fused products and without.
#include "bounds.hpp"

#include <graze/contact/collide_balls.hpp>
#include <graze/time/time_of_shapes.hpp>

#include <families/families.hpp>

#include <doctest/doctest.h>

namespace word_contact_test {

using namespace bounds;

namespace {

// Keeps the bounded components, by number, and their units.
struct kept {
    graze::detail::bounded<double> found[16];
    graze::detail::component_set known = 0;
    int what = graze::detail::undecided;
    int length = 0, velocity = 0;

    void operator()(const graze::detail::bounded<double>& x, int number) {
        found[number] = x;
        known |= 1U << number;
    }
    void operator()(const graze::detail::bounded<graze::detail::lanes>& x, int first, int second) {
        (*this)(graze::detail::bounded<double>{x.high[0], x.low[0], x.error[0]}, first);
        (*this)(graze::detail::bounded<double>{x.high[1], x.low[1], x.error[1]}, second);
    }
};

// For balls that overlap: of each velocity the narrower bound.
template <int N>
void take_exchanged(kept& k, const graze::ball<N>& a, const graze::ball<N>& b, double mass_a, double mass_b) {
    if (k.known == 0 || mass_a != mass_b) {
        return;
    }
    const auto exchanged = graze::detail::exchange_of_overlap(a, b);
    for (int i = 0; i < N; ++i) {
        for (const auto& [x, number] : {std::pair(exchanged.a[i], 10 + i), std::pair(exchanged.b[i], 13 + i)}) {
            if (x.error < k.found[number].error) {
                k(x, number);
            }
        }
    }
}

// In words, with or without fused products, scaled if necessary.
template <bool Fused, class B>
kept in_words(const B& a, const B& b, double mass_a, double mass_b) {
    kept k;
    const auto run = [&](const B& x, const B& y) {
        const auto& first = graze::detail::as_flight(x);
        const auto& second = graze::detail::as_flight(y);
        const graze::detail::contact_in_words<kept, graze::detail::dimension_of<B>> task{k, first, second, mass_a,
                                                                                         mass_b};
        const auto answer = [&] {
            if constexpr (Fused) {
                return graze::detail::with_best_products(task);
            } else {
                return task(std::false_type{});
            }
        }();
        k.what = answer.what;
        if (k.what == static_cast<int>(graze::encounter::overlap)) {
            (void)graze::detail::overlap_by_doubles<kept, B>{k, x, y, mass_a, mass_b}(std::bool_constant<Fused>{});
            if constexpr (std::is_same_v<B, graze::ball<graze::detail::dimension_of<B>>>) {
                take_exchanged(k, x, y, mass_a, mass_b);
            }
        }
        return answer.in_range;
    };
    if (!graze::detail::has_usual_size(a, b) || !run(a, b)) {
        const auto s = graze::detail::scaled(a, b);
        k.length = s.length;
        k.velocity = s.velocity;
        if (!s.known || !run(s.a, s.b)) {
            k.what = graze::detail::undecided;
        }
    }
    return k;
}

struct seen {
    int pairs = 0, decided = 0, meet = 0, bounded = 0, narrow = 0, velocities = 0, wrong = 0, wrong_bounds = 0;
};

// 2^power, exactly.
mpq_class power_of_two(int power) {
    mpz_class z;
    mpz_ui_pow_ui(z.get_mpz_t(), 2, static_cast<unsigned long>(std::abs(power)));
    return power < 0 ? mpq_class(1) / mpq_class(z) : mpq_class(z);
}
bool holds(const graze::detail::bounded<double>& x, int scale, const oracle::surd& truth) {
    if (!std::isfinite(x.high) || !std::isfinite(x.low) || !std::isfinite(x.error)) {
        return true; // an infinite bound, which is never certain
    }
    const mpq_class unit = power_of_two(scale);
    const mpq_class middle = (exact(x.high) + exact(x.low)) * unit, off = exact(x.error) * unit;
    return oracle::compare(truth, mpq_class(middle + off)) <= 0 && oracle::compare(truth, mpq_class(middle - off)) >= 0;
}

template <int N>
void judge(seen& s, const kept& r, const oracle::answer& met, const std::array<oracle::surd, components>& truth) {
    if (r.what == graze::detail::undecided) {
        return;
    }
    ++s.decided;
    s.wrong += r.what == static_cast<int>(met.what) ? 0 : 1;
    const bool hit = met.what == oracle::encounter::hit;
    if (!hit && met.what != oracle::encounter::overlap) {
        return;
    }
    s.bounded += r.known != 0 ? 1 : 0;
    bool narrow = true, velocities = true; // whether bounds are narrow
    for (int number = 0; number < static_cast<int>(components); ++number) {
        const bool is_component = number == 0 || (number - 1) % 3 < N;
        if (is_component && (r.known >> number & 1U) != 0) {
            const auto& x = r.found[number];
            const int scale = number == 0   ? r.length - r.velocity
                              : number < 7  ? r.length
                              : number < 10 ? 0
                                            : r.velocity;
            s.wrong_bounds += holds(x, scale, truth[static_cast<std::size_t>(number)]) ? 0 : 1;
            narrow = narrow && (number > 9 || number < 7 || x.error < 0x1p-70);
            velocities = velocities && (number <= 9 || x.error < 0x1p-64 * std::fabs(x.high));
        }
    }
    s.narrow += r.known != 0 && narrow ? 1 : 0;
    s.velocities += r.known != 0 && velocities ? 1 : 0;
}

template <int N>
void look(seen& s, const graze::ball<N, double>& a, const graze::ball<N, double>& b) {
    if (!is_finite(a) || !is_finite(b) || (std::isinf(a.mass) && std::isinf(b.mass)) || !(a.radius >= 0) ||
        !(b.radius >= 0)) {
        return;
    }
    ++s.pairs;
    const auto met = oracle::meet(a, b);
    const bool meet = met.what == oracle::encounter::hit || met.what == oracle::encounter::overlap;
    std::array<oracle::surd, components> truth{};
    if (meet) {
        ++s.meet;
        const auto inverse = [](double mass) {
            return std::isinf(mass) ? mpq_class(0) : mpq_class(1) / mpq_class(mass);
        };
        truth = listed(oracle::contact(a, b, inverse(a.mass), inverse(b.mass), met));
    }
    const bool heavy_a = std::isinf(a.mass), heavy_b = std::isinf(b.mass);
    const double mass_a = heavy_a ? 1 : heavy_b ? 0 : a.mass, mass_b = heavy_b ? 1 : heavy_a ? 0 : b.mass;
    const kept r = in_words<true>(a, b, mass_a, mass_b);
    judge<N>(s, r, met, truth);
    judge<N>(s, in_words<false>(a, b, mass_a, mass_b), met, truth);
    const graze::detail::further_time t = graze::detail::find_further_time(a, b, graze::detail::tried::step);
    const bool by_filter = r.what == graze::detail::undecided && t.what == static_cast<int>(met.what);
    s.wrong += t.what == r.what || by_filter ? 0 : 1;
    if (t.what == static_cast<int>(graze::encounter::hit) && t.good) {
        s.wrong_bounds += holds(t.time, t.unit, truth[0]) ? 0 : 1;
    }
}

} // namespace

TEST_CASE("bounds hold in double words") {
    for (const families::family& f : families::all_families) {
        CAPTURE(f.name);
        seen s;
        for (std::uint64_t i = 0; i < 300; ++i) {
            if (const auto flat = f.draw<2>(13, i); flat.kind == families::pair_kind::ball_ball) {
                look(s, flat.a, flat.b);
            }
            if (const auto solid = f.draw<3>(13, i); solid.kind == families::pair_kind::ball_ball) {
                look(s, solid.a, solid.b);
            }
        }
        CHECK(s.wrong == 0);
        CHECK(s.wrong_bounds == 0);
        if (graze::detail::has_error_free_doubles &&
            (f.name == "far" || f.name == "near_contact" || f.name == "generic")) {
            CHECK(s.decided == 2 * s.pairs);
            CHECK(s.bounded == 2 * s.meet);
            CHECK(s.narrow > s.bounded * 9 / 10);
        }
        MESSAGE(f.name << ": " << s.pairs << " pairs twice, " << s.decided << " decided, " << s.bounded << " of "
                       << 2 * s.meet << " bounded, " << s.narrow << " narrowly");
    }
}

// Steps from where balls from far away are closest, and from where balls that nearly touch start: what they decide is
// right, and no time is further off than its bound.
template <bool Fused, int N>
void look_at_place(seen& s, const graze::ball<N>& a, const graze::ball<N>& b, bool far) {
    const auto m = graze::detail::lane_motion_of(a, b);
    const double length2 = graze::detail::squared_length(m);
    const auto found = far ? graze::detail::approach_from_afar<Fused, N>(m, length2)
                           : graze::detail::approach_from_near<Fused>(m, length2);
    ++s.pairs;
    if (found.what != graze::detail::undecided) {
        const auto truth = oracle::meet(a, b);
        ++s.decided;
        s.wrong += found.what == static_cast<int>(truth.what) ? 0 : 1;
        if (found.is_hit() && truth.time) {
            ++s.meet;
            s.wrong_bounds += holds(found.time(), 0, *truth.time) ? 0 : 1;
            s.narrow += found.error < 0x1p-58 * found.t0 ? 1 : 0;
            const auto kept = graze::time_of_impact(a, b)->enclosure();
            s.wrong_bounds += holds({kept.near, 0, kept.error}, 0, *truth.time) ? 0 : 1;
        }
    }
}
template <int N>
void look_at_places(seen& far, seen& near, families::random& r) {
    const auto unit = [&] { return std::ldexp(static_cast<double>(r.in(-(1LL << 52), 1LL << 52)), -52); };
    graze::ball<N> a{{}, {}, 0.6 + 0.5 * unit()}, b{{}, {}, 0.6 + 0.5 * unit()};
    const double R = a.radius + b.radius;
    double along[3] = {unit(), unit(), N == 3 ? unit() : 0}, across[3] = {unit(), unit(), N == 3 ? unit() : 0};
    const auto cut_to_unit = [](double* x) {
        const double size = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        for (int i = 0; i < 3; ++i) {
            x[i] /= size;
        }
    };
    cut_to_unit(along);
    const double shared = along[0] * across[0] + along[1] * across[1] + along[2] * across[2];
    for (int i = 0; i < 3; ++i) {
        across[i] -= shared * along[i];
    }
    cut_to_unit(across);
    const double way = std::ldexp(1.5 + 0.5 * unit(), static_cast<int>(r.in(7, 56)));
    const double beside = R * (r.one_in(3) ? 1 + std::ldexp(unit(), -static_cast<int>(r.in(0, 60))) : unit());
    for (int i = 0; i < N; ++i) {
        b.position[i] = r.one_in(2) ? 0.0 : unit();
        b.velocity[i] = r.one_in(2) ? 0.0 : unit();
        a.position[i] = b.position[i] + (across[i] * beside - along[i] * way);
        a.velocity[i] = b.velocity[i] + along[i];
    }
    look_at_place<true>(far, a, b, true);
    look_at_place<false>(far, a, b, true);
    const double gap = std::ldexp(unit(), -static_cast<int>(r.in(26, 62)));
    const double turn = 1.5 * unit();
    for (int i = 0; i < N; ++i) {
        a.position[i] = b.position[i] - R * (1 + gap) * (std::cos(turn) * along[i] + std::sin(turn) * across[i]);
    }
    look_at_place<true>(near, a, b, false);
    look_at_place<false>(near, a, b, false);
}
TEST_CASE("bounds hold for balls from far away and for balls that nearly touch") {
    families::random r(7, 1);
    seen far, near;
    for (int i = 0; i < 1500; ++i) {
        look_at_places<2>(far, near, r);
        look_at_places<3>(far, near, r);
    }
    for (const seen& s : {far, near}) {
        CHECK(s.wrong == 0);
        CHECK(s.wrong_bounds == 0);
        CHECK(s.decided > s.pairs * 3 / 4);
        CHECK(s.narrow > s.meet * 3 / 4);
    }
    MESSAGE(far.decided << " of " << far.pairs << ", " << far.narrow << " of " << far.meet << "; " << near.decided
                        << " of " << near.pairs << ", " << near.narrow << " of " << near.meet);
}

// Balls that slide past each other, nearly touching: the terms of h cancel, and so do those of c.
TEST_CASE("bounds hold where all coefficients cancel") {
    seen s;
    families::random r(5, 0);
    const auto unit = [&] { return (static_cast<double>(r.in(0, 1 << 20)) + 0.5) * 0x1p-20; };
    for (int i = 0; i < 2000; ++i) {
        const double turn = 6.28 * unit(), x = std::cos(turn), y = std::sin(turn);
        const int k = static_cast<int>(r.in(4, 24));
        const double gap = std::ldexp(unit(), -2 * k), inward = std::ldexp(1 + unit(), -k);
        const double away = (1 + gap) * (r.one_in(4) ? std::ldexp(1.0, static_cast<int>(r.in(0, 20))) : 1.0);
        const graze::ball<2> a{{x * away, y * away}, {-y - x * inward, x - y * inward}, 0.25, 1},
            b{{0, 0}, {0, 0}, 0.75, 2};
        look(s, a, b);
        const graze::ball<3> c{{x * away, y * away, 0}, {-y - x * inward, x - y * inward, unit()}, 0.25, 1};
        look(s, c, graze::ball<3>{{0, 0, 0}, {0, 0, 0}, 0.75, 2});
    }
    CHECK(s.wrong == 0);
    CHECK(s.wrong_bounds == 0);
    CHECK(s.meet > 1000);
}

// Lagrange's D in words of a motion whose centres pass each other at R (1 + gap), compared with rational numbers.
template <int N>
void look_at_discriminant(families::random& r, int& narrow) {
    const auto unit = [&] { return std::ldexp(static_cast<double>(r.in(-(1LL << 52), 1LL << 52)), -52); };
    const auto word = [&](double value) {
        return graze::exact_pair<double>{value, r.one_in(3) ? 0.0 : 0x1p-54 * value * unit()};
    };
    const auto exact = [](const graze::exact_pair<double>& x) {
        return mpq_class(mpq_class(x.value) + mpq_class(x.error));
    };
    graze::detail::motion_in_words<N> m;
    const double R = 0.5 + std::fabs(unit()), way = std::ldexp(1 + unit(), static_cast<int>(r.in(0, 30)));
    const double turn = 3 * unit(), gap = std::ldexp(unit(), -static_cast<int>(r.in(5, 50)));
    const double u[2] = {std::cos(turn), std::sin(turn)};
    m.R = word(R);
    for (int i = 0; i < N; ++i) {
        const double across = i == 0 ? -u[1] : i == 1 ? u[0] : 0;
        m.du[i] = word(i < 2 ? u[i] : 0.0);
        m.dx[i] = word(across * R * (1 + gap) - (i < 2 ? u[i] : 0.0) * way);
    }
    mpq_class speed2 = 0, cross2 = 0;
    for (int i = 0; i < N; ++i) {
        speed2 += exact(m.du[i]) * exact(m.du[i]);
        for (int j = 0; j < i; ++j) {
            const mpq_class cross = exact(m.dx[i]) * exact(m.du[j]) - exact(m.dx[j]) * exact(m.du[i]);
            cross2 += cross * cross;
        }
    }
    const mpq_class truth = exact(m.R) * exact(m.R) * speed2 - cross2;
    const graze::detail::sharp_discriminant<N> task{&m};
    for (const auto& d : {task(std::true_type{}), task(std::false_type{})}) {
        CHECK(abs(exact(d.value) - truth) <= mpq_class(d.error));
        CHECK(d.value.value + d.value.error == d.value.value); // a root is taken of it
        narrow += d.error < 0x1p-80 * std::fabs(d.value.value) ? 1 : 0;
    }
}
TEST_CASE("D of near-grazes is right to three times a double's precision") {
    families::random r(3, 1);
    int narrow = 0;
    for (int i = 0; i < 500; ++i) {
        look_at_discriminant<2>(r, narrow);
        look_at_discriminant<3>(r, narrow);
    }
    CHECK(narrow > 1500); // of 2000: balls that come from 2^30 away leave fewer bits
}

// Balls of equal masses exchange velocities that are of very different sizes.
template <int N>
void look_at_exchange(seen& s, families::random& r) {
    const auto unit = [&] { return std::ldexp(static_cast<double>(r.in(-(1LL << 52), 1LL << 52)), -52); };
    const int spread = static_cast<int>(r.in(0, 290));
    const auto number = [&] { return std::ldexp(unit(), static_cast<int>(r.in(-spread, spread))); };
    graze::ball<N> a, b;
    for (int i = 0; i < N; ++i) {
        a.position[i] = number();
        b.position[i] = number();
        a.velocity[i] = number();
        b.velocity[i] = number();
    }
    a.radius = std::fabs(number());
    b.radius = std::fabs(number());
    a.mass = b.mass = 1.5 + 0.5 * unit();
    if (r.one_in(2)) { // they aim at each other
        const double time = std::fabs(number()), off = r.one_in(2) ? a.radius : 0x1p-30 * a.radius;
        for (int i = 0; i < N; ++i) {
            a.position[i] = b.position[i] - time * (a.velocity[i] - b.velocity[i]) + off * unit();
        }
    }
    look(s, a, b);
}
TEST_CASE("bounds hold for equal masses with velocities of different sizes") {
    families::random r(11, 1);
    seen s;
    for (int i = 0; i < 1000; ++i) {
        look_at_exchange<2>(s, r);
        look_at_exchange<3>(s, r);
    }
    CHECK(s.wrong == 0);
    CHECK(s.wrong_bounds == 0);
    CHECK(s.meet > 600);
    CHECK(s.velocities > s.bounded * 3 / 4);
    MESSAGE(s.meet << " meet, " << s.bounded << " bounded, velocities " << s.velocities);
}

// D is 2^-84 and 2^-80 of its terms, and two of its three parts overlap.
TEST_CASE("bounds hold where D cancels nearly all of a double word") {
    seen s;
    look(s,
         graze::ball<2>{{-0x1.39155e98d9a9cp+0, -0x1.747dcc1ccc99ep+57},
                        {0, 0x1.9523ce20303d5p+110},
                        0x1.283235308a7ccp-33,
                        0x1.bc3e136550caap+20},
         graze::ball<2>{{-0x1.96b44e4883e4ep+86, 0x1.f88a5d7179fa1p-41},
                        {0x1.3ea885acef9c9p+48, 0x1.051a183065f18p+109},
                        0x1.96b44e4883e4ep+86,
                        0x1.550577bf6912p-4});
    look(s,
         graze::ball<3>{{0x1.6c59f006c9102p+221, -0x1.7dff5456151aep-165, -0x1.6fe95767d99f4p-288},
                        {-0x1.68e5dd54a82dap-36, 0, 0},
                        0x1.5f8ada5bfd899p+221,
                        0x1.7966121871aadp-14},
         graze::ball<3>{{-0x1.e8b42fb5232fcp+122, 0, 0x1.5f118cf9e02cep-180},
                        {0x1.20a7d373826c4p+237, -0x1.afd49cfa29476p-254, 0x1.e31612a017976p+277},
                        0x1.99e2b55970d2p+216,
                        0x1.ee5644f074c8p+9});
    CHECK(s.meet == 2);
    CHECK(s.wrong == 0);
    CHECK(s.wrong_bounds == 0);
}

TEST_CASE("the widest stage of a time and of a contact") {
    using graze::stage;
    const auto at = [](double x, double y, double u, double unit = 1) {
        return graze::ball<2>{{x * unit, y * unit}, {u, 0}, unit};
    };
    const auto expect = [](stage of_time, stage of_contact, const graze::ball<2>& a, const graze::ball<2>& b) {
        int told = 0;
        auto by = stage::exact;
        const auto tell = [&](stage s) {
            by = s;
            ++told;
        };
        (void)graze::time_of_impact(a, b, tell);
        CHECK(by == of_time);
        (void)graze::collide(a, b, tell);
        CHECK(by == of_contact);
        CHECK(told == 2); // once for each call
    };
    const auto rest = at(0, 0, 0);
    expect(stage::filter, stage::filter, at(5, 0.3, -1), rest);
    expect(stage::filter, stage::filter, at(5, 0.3, 1), rest);                 // parting
    expect(stage::double_word, stage::double_word, at(0x1p40, 1.1, -1), rest); // far: L²V² is 2^80
    expect(stage::double_word, stage::double_word, at(0x1p40, 2.1, -1), rest);
    expect(stage::double_word, stage::double_word, at(0x1p20, 2 - 0x1p-20, -1), rest);
    expect(stage::double_word, stage::double_word, at(0x1p20, 2 + 0x1p-20, -1), rest);
    expect(stage::double_word, stage::double_word, at(0x1p49, 2 - 0x1p-6, -1), rest); // beyond doubles
    expect(stage::double_word, stage::double_word, at(5.3, 2 - 0x1p-48, -1.1), rest); // D is 2^-49 of its terms
    expect(stage::filter, stage::filter, at(5, 0.3, -1, 0x1p-600), at(0, 0, 0, 0x1p-600));
    expect(stage::double_word, stage::double_word, at(0x1p20, 2 - 0x1p-20, -1, 0x1p-600), at(0, 0, 0, 0x1p-600));
    expect(stage::exact, stage::exact, at(5, 2, -1), rest); // a tie
    expect(stage::exact, stage::exact, at(5, 2, -1, 0x1p-600), at(0, 0, 0, 0x1p-600));
}

} // namespace word_contact_test
