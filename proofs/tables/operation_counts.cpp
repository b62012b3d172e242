// Prints the table of docs/reference/operation-counts.md: what each formula costs, counted from the formula itself.
#include <graze/analysis/operation_count.hpp>
#include <graze/formula/contact.hpp>
#include <graze/formula/discriminant.hpp>
#include <graze/formula/flat_way.hpp>
#include <graze/formula/impulse.hpp>
#include <graze/formula/plane_crossing.hpp>
#include <graze/formula/root_order.hpp>
#include <graze/formula/roots.hpp>

#include <array>
#include <iostream>

namespace {

using namespace graze;

template <int N>
constexpr vec<N, counted_number> vector(const counted_number& x) {
    return make_vec<N>([&](int) { return x; });
}
template <int N>
constexpr relative_motion<N, counted_number, counted_number, counted_number> balls(const counted_number& x) {
    return {vector<N>(x), vector<N>(x), x};
}
template <int N>
constexpr auto plane_of(const counted_number& x) {
    return plane_motion{vector<N>(x), vector<N>(x), vector<N>(x), x};
}
template <int N, class X>
constexpr std::array<X, N - 1> each(const X& x) {
    if constexpr (N == 2) {
        return {x};
    } else {
        return {x, x};
    }
}
template <int N>
constexpr auto wall_of(const counted_number& x) {
    return flat_motion<N, counted_number>{vector<N>(x), vector<N>(x), each<N>(vector<N>(x)), x, false};
}
constexpr quadratic<counted_number, counted_number, counted_number> coefficients(const counted_number& x) {
    return {x, x, x};
}

template <int N, class F>
constexpr auto of_balls(F f) {
    return operations_of([&](const counted_number& x) { return f(balls<N>(x)); });
}

void cells(const operation_count& c) {
    std::cout << ' ' << c.sums << " | " << c.products << " | " << c.fused << " | " << c.quotients << " | " << c.roots
              << " |";
}

// One row: the same generic count in 2D and in 3D.
template <class Count>
void row(const char* name, Count count) {
    std::cout << "| " << name << " |";
    cells(count.template operator()<2>());
    cells(count.template operator()<3>());
    std::cout << '\n';
}

} // namespace

int main() {
    std::cout
        << "| | 2D: sums | products | fused | quotients | roots | 3D: sums | products | fused | quotients | roots "
           "|\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    row("Δx, Δu, R from two balls", []<int N> {
        return operations_of([](const counted_number& x) {
            const ball<N, counted_number> b{vector<N>(x), vector<N>(x), x, x};
            return relative_motion_of(b, b);
        });
    });
    row("a", []<int N> { return of_balls<N>(coefficient_a{}); });
    row("h", []<int N> { return of_balls<N>(coefficient_h{}); });
    row("c", []<int N> { return of_balls<N>(coefficient_c{}); });
    row("4D, textbook, with a, h and c",
        []<int N> { return of_balls<N>([](const auto& m) { return discriminant_textbook{}(quadratic_of(m)); }); });
    row("D halved, with a, h and c",
        []<int N> { return of_balls<N>([](const auto& m) { return discriminant_halved{}(quadratic_of(m)); }); });
    row("D by Kahan, with a, h and c",
        []<int N> { return of_balls<N>([](const auto& m) { return discriminant_kahan{}(quadratic_of(m)); }); });
    row("D by Lagrange", []<int N> { return of_balls<N>(discriminant_lagrange{}); });
    row("D by Lagrange, with h and c, which a decision needs too", []<int N> {
        return of_balls<N>([](const auto& m) {
            (void)coefficient_h{}(m);
            (void)coefficient_c{}(m);
            return discriminant_lagrange{}(m);
        });
    });
    row("τ as printed, from a, h and 4D", []<int> {
        return operations_of([](const counted_number& x) { return root_printed{}(x, twice(x), square_root(x)); });
    });
    row("τ without cancellation, from c, h and D",
        []<int> { return operations_of([](const counted_number& x) { return root_stable{}(x, x, square_root(x)); }); });
    row("which of two τ is first, on the longest path", []<int> {
        return operations_of([](const counted_number& x) { return root_order{}(coefficients(x), coefficients(x)); });
    });
    row("a contact position", []<int N> {
        return operations_of([](const counted_number& x) { return position_at(vector<N>(x), vector<N>(x), x); });
    });
    row("X̂, from Δx, Δu, τ and R", []<int N> {
        return operations_of(
            [](const counted_number& x) { return contact_normal(position_at(vector<N>(x), vector<N>(x), x), x); });
    });
    row("μ and α, from X̂, Δu and the inverse masses", []<int N> {
        return operations_of(
            [](const counted_number& x) { return impulse(reduced_mass(x, x), vector<N>(x), vector<N>(x)); });
    });
    row("a velocity after the impact, from α", []<int N> {
        return operations_of([](const counted_number& x) { return velocity_after(vector<N>(x), x, x, vector<N>(x)); });
    });
    row("a reflection, unit normal", []<int N> {
        return operations_of([](const counted_number& x) { return reflected(vector<N>(x), vector<N>(x)); });
    });
    row("a reflection, any normal", []<int N> {
        return operations_of(
            [](const counted_number& x) { return reflected_unnormalised(vector<N>(x), vector<N>(x)); });
    });
    row("height over a plane",
        []<int N> { return operations_of([](const counted_number& x) { return plane_height{}(plane_of<N>(x)); }); });
    row("clearance of a plane",
        []<int N> { return operations_of([](const counted_number& x) { return plane_clearance{}(plane_of<N>(x)); }); });
    row("when a plane is touched, with height and speed", []<int N> {
        return operations_of([](const counted_number& x) {
            const auto m = plane_of<N>(x);
            return plane_touch_time{}(plane_height{}(m), plane_speed{}(m), m.r * square_root(squared_norm(m.n)));
        });
    });
    row("where a ball's way crosses a wall's plane, and how fast",
        []<int N> { return operations_of([](const counted_number& x) { return way_of(wall_of<N>(x)); }); });
    row("one side of the rectangle test (O² n·n − r² I²), after that", []<int N> {
        return operations_of([](const counted_number& x) {
            return touch_inside_norm{0, false}(flat_way<N, counted_number>{x, x, x, x, x, each<N>(x), each<N>(x)});
        });
    });
}
