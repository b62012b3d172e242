#include "callers.hpp"

#include <graze/predicate/classify_walls.hpp>
#include <graze/predicate/overlaps_of_shapes.hpp>
#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

#include <bit>
#include <cmath>
#include <cstdint>

namespace environments {
namespace {

template <class T>
[[nodiscard]] T stored(T x) {
    volatile T memory = x;
    return memory;
}

// x is near 1/epsilon, where p + d, p - d and p d lose what they add. q is a few units away, and the radius r is such
// that the lost part decides.
template <class T>
struct sample {
    T p, d, q, r;
};

template <class T>
[[nodiscard]] graze::ball<2, T> at(T x, T y, T u, T r) {
    return {{{x, y}}, {{u, T(0)}}, r};
}

struct sum {
    template <class T>
    T operator()(const sample<T>& s) const {
        return s.p + s.d;
    }
};
struct difference_of_products {
    template <class T>
    T operator()(const sample<T>& s) const {
        return s.p * s.d - s.p * (s.d - T(1));
    }
};
struct product {
    template <class T>
    T operator()(const sample<T>& s) const {
        return (s.p + T(1)) * (s.d / T(4) + T(1));
    }
};
struct quotient {
    template <class T>
    T operator()(const sample<T>& s) const {
        return s.p / (T(1) + s.d / T(8));
    }
};

// Questions about a ball at x. Each is a function of its own, in which x is an expression.
template <class T>
[[nodiscard]] graze::ball<2, T> other(const sample<T>& s) {
    return at(s.q, T(0), T(0), s.r / T(2));
}
template <class T>
[[nodiscard]] graze::plane<2, T> plane(const sample<T>& s) {
    return {{{s.q, T(0)}}, {{T(1), T(0)}}};
}
template <class T>
[[nodiscard]] graze::wall<2, T> wall(const sample<T>& s) {
    return {{{s.q, T(-8)}}, {{{{T(0), T(16)}}}}};
}
struct decision {
    template <class T>
    int operator()(T x, const sample<T>& s) const {
        return static_cast<int>(graze::classify(at(x, T(1), T(-1), s.r), other(s)));
    }
};
struct overlap {
    template <class T>
    int operator()(T x, const sample<T>& s) const {
        return graze::overlaps(at(x, T(1), T(-1), s.r), other(s)) ? 1 : 0;
    }
};
struct plane_decision {
    template <class T>
    int operator()(T x, const sample<T>& s) const {
        return static_cast<int>(graze::classify(at(x, T(1), T(-1), s.r), plane(s)));
    }
};
struct wall_decision {
    template <class T>
    int operator()(T x, const sample<T>& s) const {
        return static_cast<int>(graze::classify(at(x, T(1), T(-1), s.r), wall(s)));
    }
};
struct time_against_expression { // the time q of a ball, compared with x
    template <class T>
    int operator()(T x, const sample<T>& s) const {
        const auto time = graze::time_of_impact(at(s.q, T(0), T(-1), T(0)), at(T(0), T(0), T(0), T(0)));
        return !time ? 0 : *time < x ? 1 : *time == x ? 2 : 3;
    }
};

template <class Question, class F, class T>
[[nodiscard, gnu::noinline]] int in_place(const sample<T>& s) {
    return Question{}(F{}(s), s);
}
template <class Question, class T>
[[nodiscard, gnu::noinline]] int from_memory(const T& x, const sample<T>& s) {
    return Question{}(x, s);
}

template <class F, class T>
void ask(caller_tally& t) {
    std::uint64_t state = 1;
    const auto next = [&state](unsigned below) { // a linear congruence; its upper bits
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<T>(static_cast<int>((state >> 40) % below));
    };
    const T large = std::is_same_v<T, double> ? T(0x1p53) : T(0x1p24);
    for (int i = 0; i < 500; ++i) {
        sample<T> s{stored(large + T(2) * next(64)), stored(next(16) / T(8)), T(0), stored(next(48) / T(8))};
        s.q = stored(stored(F{}(s)) - T(2) * next(6));
        const T x = stored(F{}(s));
        const auto compare = [&]<class Question>(Question) {
            ++t.asked;
            t.different += in_place<Question, F>(s) == from_memory<Question>(x, s) ? 0U : 1U;
        };
        compare(decision{});
        compare(overlap{});
        compare(plane_decision{});
        compare(wall_decision{});
        compare(time_against_expression{});
    }
}

// τ = 2^-140 against subnormal floats in registers: how they compare is known. The numbers are made from bits, so that
// no mode changes them.
[[nodiscard, gnu::noinline]] int against(const graze::impact_time<2>& time, float m) {
    const auto order = time <=> m;
    return order < 0 ? -1 : order > 0 ? 1 : time == m ? 0 : 2;
}
void ask_subnormals(caller_tally& t) {
    const auto time =
        graze::time_of_impact(graze::ball<2>{{-0x1p-140, 0}, {1, 0}, 0}, graze::ball<2>{{0, 0}, {0, 0}, 0});
    const auto ask_one = [&](std::uint32_t bits, int right) {
        ++t.asked;
        t.different += time && against(*time, std::bit_cast<float>(stored(bits))) == right ? 0U : 1U;
    };
    ask_one(0, 1);
    ask_one(1, 1);               // 2^-149
    ask_one(1U << 9, 0);         // 2^-140
    ask_one((1U << 9) + 1, -1);  // the next number
    ask_one(1U << 19, -1);       // 2^-130
    ask_one((1U << 23) - 1, -1); // the largest subnormal number
    ask_one(1U << 23, -1);       // the smallest normal one
    ask_one((1U << 31) + 1, 1);  // -2^-149
}

// Rows of doubles that a caller narrows to floats where the predicate is inlined: position, velocity and radius of a
// ball, corner and edge of a wall. From the family edges_and_corners.
constexpr double to_be_narrowed[][9] = {
    {-0x1.6424ba7c04bap-1, -0x1.85f3bf63330bp-2, 0x1.02b11366889p-2, -0x1.2fcae519405fp+0, 0x1.da9aa7cd5107ap-3,
     -0x1.99ab98a88adf8p-1, -0x1.18a7c0caf364p+0, 0x1.5cp-6, -0x1.936p-8},
    {-0x1.7b7af6f977d8p-2, -0x1.72be2b408118p-4, -0x1.fbe0e917198p-1, -0x1.7471bbffdf8p-3, 0x1.04e09f1012714p-3,
     -0x1.351ef19aacb6cp+0, -0x1.d4c2d4c47ae4p-4, -0x1.6c8p-7, 0x1.188cp-6},
    {0x1.838caab3fbc4p-3, 0x1.279644b4133ep-2, -0x1.eda21825ff4p-4, 0x1.ce4453f28419p+0, 0x1.9268c4094783bp-3,
     0x1.846ed258379bp-2, 0x1.3432dd0f8e924p+0, -0x1.b822p-5, -0x1.0298p-7},
    {-0x1.67b1e7ea4ae1p-1, -0x1.56f8807eff2e8p-1, -0x1.b7f4b7377668p-2, -0x1.1022abbddcab4p+0, 0x1.1a195e26190b1p-3,
     -0x1.5ecf89a78fe68p-1, -0x1.2989544a5ef24p+0, -0x1.a63ep-5, 0x1.4954p-5},
};

template <class X>
[[nodiscard, gnu::always_inline]] inline int met(const X* x) {
    const auto narrowed = [x](int from) {
        return graze::make_vec<2>([&](int i) { return static_cast<float>(x[from + i]); });
    };
    const graze::ball<2, float> b{narrowed(0), narrowed(2), static_cast<float>(x[4])};
    const graze::wall<2, float> w{narrowed(5), {{narrowed(7)}}};
    auto decided_by = graze::stage::exact;
    const auto what = graze::classify(b, w, [&](graze::stage s) { decided_by = s; });
    return 2 * static_cast<int>(what) + (decided_by == graze::stage::exact ? 1 : 0);
}
[[nodiscard, gnu::noinline]] int met_narrowed(const double* x) { return met(x); }
[[nodiscard, gnu::noinline]] int met_as_stored(const float* x) { return met(x); }

void ask_narrowed(caller_tally& t) {
    for (const auto& row : to_be_narrowed) {
        double wide[9];
        float narrow[9];
        for (int i = 0; i < 9; ++i) {
            wide[i] = stored(row[i]);
            narrow[i] = stored(static_cast<float>(wide[i]));
        }
        ++t.asked;
        t.different += met_narrowed(wide) == met_as_stored(narrow) ? 0U : 1U;
    }
}

// Overlapping balls that part about as fast as the filter can just tell, double by double. If it computes in registers
// of more bits and stores some results, one comparison may decide what another leaves open.
void ask_barely_parting(caller_tally& t) {
    constexpr double tells = graze::detail::ball_filter<2, double>::discriminant;
    for (int i = 0; i < 200; ++i) {
        const double x = 1 + i / 256.0 + 0x1p-50;
        const double across = 2 - i / 512.0 - 0x1p-51;
        const double radius = 5 + i / 128.0 + 0x1p-49;
        const double length2 = x * x + radius * radius;
        const double slow = tells * length2 * across * across / (x * x); // border² without the speed's part
        const double border = std::sqrt(tells * length2 * (across * across + slow)) / x;
        for (int k = -8; k <= 8; ++k) {
            const double away = stored(std::bit_cast<double>(std::bit_cast<std::int64_t>(stored(border)) + k));
            const graze::ball<2> a{{x, 0}, {away, across}, radius};
            const graze::ball<2> b{{0, 0}, {0, 0}, 0};
            ++t.asked;
            t.different += graze::time_of_impact(a, b) ? 1U : 0U;
        }
    }
}

} // namespace

caller_tally ask_callers() {
    caller_tally t;
    ask<sum, double>(t);
    ask<difference_of_products, double>(t);
    ask<product, double>(t);
    ask<quotient, double>(t);
    ask<sum, float>(t);
    ask<product, float>(t);
    ask_subnormals(t);
    ask_narrowed(t);
    ask_barely_parting(t);
    return t;
}

} // namespace environments
