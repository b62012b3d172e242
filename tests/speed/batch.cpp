// graze-batch-speed: what a pair costs in a batch, beside plain floating point over the same columns and beside the
// scalar functions. In nanoseconds, the least of many rounds in which all take turns. Plain is what one writes without
// a library: one pair after the other, not exact, in the same number type; once with the obvious branches, and once
// without any.
#include <families/families.hpp>

#include <graze/batch.hpp>
#include <graze/classify.hpp>
#include <graze/time_of_impact.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace {

using graze::encounter;

constexpr std::size_t count = 100'000;

template <int N, class T>
struct many {
    std::vector<graze::ball<N, T>> balls;
    std::array<std::vector<T>, 2 * N + 1> numbers;

    void add(const graze::ball<N, double>& b) {
        graze::ball<N, T> x{};
        for (int k = 0; k < N; ++k) {
            x.position[k] = static_cast<T>(b.position[k]);
            x.velocity[k] = static_cast<T>(b.velocity[k]);
            numbers[static_cast<std::size_t>(k)].push_back(x.position[k]);
            numbers[static_cast<std::size_t>(N + k)].push_back(x.velocity[k]);
        }
        x.radius = static_cast<T>(b.radius);
        numbers[2 * N].push_back(x.radius);
        balls.push_back(x);
    }
    [[nodiscard]] graze::columns<N, T> columns() const {
        graze::columns<N, T> c{};
        for (std::size_t k = 0; k < N; ++k) {
            c.position[k] = numbers[k].data();
            c.velocity[k] = numbers[N + k].data();
        }
        c.radius = numbers[2 * N].data();
        c.size = balls.size();
        return c;
    }
};

template <class T>
struct coefficients {
    T a = 0, h = 0, c = 0;
};
template <int N, class T>
[[gnu::always_inline]] inline coefficients<T> plain_coefficients(const graze::columns<N, T>& x,
                                                                 const graze::columns<N, T>& y, std::size_t i) {
    coefficients<T> q;
    for (std::size_t k = 0; k < N; ++k) {
        const T dx = x.position[k][i] - y.position[k][i], du = x.velocity[k][i] - y.velocity[k][i];
        q.a += du * du, q.h += dx * du, q.c += dx * dx;
    }
    const T R = x.radius[i] + y.radius[i];
    q.c -= R * R;
    return q;
}
template <int N, class T>
[[gnu::noinline]] void plain_with_branches(const graze::columns<N, T>& x, const graze::columns<N, T>& y,
                                           encounter* what) {
    for (std::size_t i = 0; i < x.size; ++i) {
        const auto q = plain_coefficients(x, y, i);
        if (q.h >= 0) {
            what[i] = encounter::recede;
        } else if (q.c < 0) {
            what[i] = encounter::overlap;
        } else {
            const T d = q.h * q.h - q.a * q.c;
            what[i] = d < 0 ? encounter::miss : d == 0 ? encounter::graze : encounter::hit;
        }
    }
}
template <int N, class T>
[[gnu::noinline]] void plain_without(const graze::columns<N, T>& x, const graze::columns<N, T>& y, encounter* what) {
    for (std::size_t i = 0; i < x.size; ++i) {
        const auto q = plain_coefficients(x, y, i);
        const T d = q.h * q.h - q.a * q.c;
        const int meets = 2 + static_cast<int>(d >= 0) + static_cast<int>(d > 0);
        const int closer = meets & -static_cast<int>(q.c >= 0);
        const int parting = -static_cast<int>(q.h >= 0);
        what[i] = static_cast<encounter>((closer & ~parting) | (1 & parting));
    }
}

// Each of them takes its turn in every round.
class turns {
  public:
    explicit turns(std::size_t pairs = count) : pairs_(static_cast<double>(pairs)) {}
    void add(std::function<void()> f) { asked_.push_back({std::move(f), 1e99}); }
    void measure(int rounds) {
        for (int r = 0; r < rounds; ++r) {
            for (auto& [f, least] : asked_) {
                const auto start = std::chrono::steady_clock::now();
                f();
                const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
                least = std::min(least, took.count() / pairs_);
            }
        }
    }
    [[nodiscard]] double operator[](std::size_t i) const { return asked_[i].second; }

  private:
    std::vector<std::pair<std::function<void()>, double>> asked_;
    double pairs_;
};

template <class T>
constexpr const char* name_of = sizeof(T) == 4 ? "float" : "double";

// Pairs of the family, until there are enough of two balls.
template <int N, class T>
std::array<many<N, T>, 2> balls_of(const families::family& family, std::size_t size) {
    std::array<many<N, T>, 2> r;
    for (std::uint64_t i = 0; r[0].balls.size() < size; ++i) {
        const auto pair = family.draw<N>(1, i);
        if (pair.kind == families::pair_kind::ball_ball) {
            r[0].add(pair.a);
            r[1].add(pair.b);
        }
    }
    return r;
}

template <int N, class T>
void measure_balls() {
    const auto [a, b] = balls_of<N, T>(families::all_families[0], count);
    const auto x = a.columns(), y = b.columns();
    std::vector<encounter> what(count);
    turns t;
    t.add([&, &p = a, &q = b] { plain_with_branches(x, y, what.data()); });
    t.add([&] { plain_without(x, y, what.data()); });
    t.add([&, &p = a.balls, &q = b.balls] {
        for (std::size_t i = 0; i < count; ++i) {
            what[i] = graze::classify(p[i], q[i]);
        }
    });
    t.add([&] { graze::batch::classify(x, y, what); });
    t.add([&, &p = a.balls, &q = b.balls] { graze::batch::classify(p, q, what); });
    t.add([&, &one = b.balls[0]] { graze::batch::classify(x, one, what); });
    t.measure(60);
    std::printf("| %dD, %s | %.1f | %.1f | %.1f | %.1f (%.2f, %.2f) | %.1f (%.2f, %.2f) | %.1f |\n", N, name_of<T>,
                t[0], t[1], t[2], t[3], t[3] / t[0], t[3] / t[1], t[4], t[4] / t[0], t[4] / t[1], t[5]);
}

// Times rounded to nearest: one by one, and in a batch.
template <int N, class T>
void measure_times() {
    const auto pairs = balls_of<N, T>(families::all_families[0], count);
    std::vector<T> time(count);
    turns t;
    t.add([&, &p = pairs[0].balls, &q = pairs[1].balls] {
        for (std::size_t i = 0; i < count; ++i) {
            const auto impact = graze::time_of_impact(p[i], q[i]);
            time[i] = impact ? static_cast<T>(*impact) : std::numeric_limits<T>::infinity();
        }
    });
    t.add([&, x = pairs[0].columns(), y = pairs[1].columns()] { graze::batch::time_of_impact(x, y, time); });
    t.add([&, &p = pairs[0].balls, &q = pairs[1].balls] { graze::batch::time_of_impact(p, q, time); });
    t.measure(15);
    std::printf("| %dD, %s | %.1f | %.1f (%.2f) | %.1f (%.2f) |\n", N, name_of<T>, t[0], t[1], t[1] / t[0], t[2],
                t[2] / t[0]);
}

// Against one thing: one by one, and in a batch of columns.
template <int N, class T, class Shape>
void measure_shape(const char* name, const Shape& shape) {
    const auto balls = balls_of<N, T>(families::all_families[0], count)[0];
    std::vector<encounter> what(count);
    std::vector<T> times(count);
    turns t;
    t.add([&] {
        for (std::size_t i = 0; i < count; ++i) {
            what[i] = graze::classify(balls.balls[i], shape);
        }
    });
    t.add([&, x = balls.columns()] { graze::batch::classify(x, shape, what); });
    t.measure(15);
    std::printf("| %dD, %s, %s | %.1f | %.1f (%.2f) |\n", N, name_of<T>, name, t[0], t[1], t[1] / t[0]);
}
template <int N, class T>
void measure_shapes() {
    graze::plane<N, T> p{};
    graze::wall<N, T> w{};
    for (int k = 0; k < N; ++k) {
        p.point[k] = static_cast<T>(0.1 * k);
        p.normal[k] = static_cast<T>(1 - 0.6 * k);
        w.corner[k] = static_cast<T>(-0.5);
        for (std::size_t e = 0; e < w.edge.size(); ++e) {
            w.edge[e][k] = static_cast<T>(static_cast<int>(e) == k ? 1 : 0.125);
        }
    }
    measure_shape<N, T>("plane", p);
    measure_shape<N, T>("wall", w);
}

// A family of hard pairs: one by one, and in a batch.
template <int N>
void measure_family(const families::family& family) {
    constexpr std::size_t size = 4'096;
    const auto pairs = balls_of<N, double>(family, size);
    std::vector<encounter> what(size);
    turns t(size);
    t.add([&, &p = pairs[0].balls, &q = pairs[1].balls] {
        for (std::size_t i = 0; i < size; ++i) {
            what[i] = graze::classify(p[i], q[i]);
        }
    });
    t.add([&, &p = pairs[0].balls, &q = pairs[1].balls] { graze::batch::classify(p, q, what); });
    t.measure(15);
    std::printf("| %.*s, %dD | %.1f | %.1f (%.2f) |\n", static_cast<int>(family.name.size()), family.name.data(), N,
                t[0], t[1], t[1] / t[0]);
}

// The same batch in one thread and in two.
template <int N, class T>
void measure_threads() {
    const auto pairs = balls_of<N, T>(families::all_families[0], 8 * count);
    const auto x = pairs[0].columns(), y = pairs[1].columns();
    std::vector<encounter> what(x.size);
    turns t(x.size);
    t.add([&] { graze::batch::classify(x, y, what); });
    t.add([&] {
        const std::size_t half = x.size / 2;
        const std::jthread other(
            [&] { graze::batch::classify(x.part(half, half), y.part(half, half), std::span(what).subspan(half)); });
        graze::batch::classify(x.part(0, half), y.part(0, half), std::span(what).first(half));
    });
    t.measure(30);
    std::printf("| %dD, %s | %.1f | %.1f (%.1f times as fast) |\n", N, name_of<T>, t[0], t[1], t[0] / t[1]);
}

} // namespace

int main() {
    std::puts("ns a pair, classify, 10^5 generic pairs; in brackets, times plain with and without branches\n\n"
              "| | plain | plain, no branches | one by one | batch: columns | batch: spans | one against columns |\n"
              "|---|--:|--:|--:|--:|--:|--:|");
    measure_balls<2, double>();
    measure_balls<3, double>();
    measure_balls<2, float>();
    measure_balls<3, float>();
    std::puts("\nTimes, rounded to nearest\n\n| | one by one | batch: columns | batch: spans |\n|---|--:|--:|--:|");
    measure_times<2, double>();
    measure_times<3, double>();
    measure_times<2, float>();
    measure_times<3, float>();
    std::puts("\nAgainst one thing\n\n| | one by one | batch: columns |\n|---|--:|--:|");
    measure_shapes<2, double>();
    measure_shapes<3, double>();
    measure_shapes<3, float>();
    std::puts("\nHard pairs, in double\n\n| family | one by one | batch: spans |\n|---|--:|--:|");
    for (const char* name : {"grazing", "tangent", "far", "near_contact", "own_exponents"}) {
        measure_family<2>(*families::find_family(name));
        measure_family<3>(*families::find_family(name));
    }
    std::puts("\nTwo threads, 8 10^5 pairs in columns\n\n| | one thread | two |\n|---|--:|--:|");
    measure_threads<3, double>();
    measure_threads<3, float>();
}
