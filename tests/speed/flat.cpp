// Walls and triangles in space: the cost of triangles, floats and flights beside that of a ball and a wall in doubles.
#include "speed.hpp"

#include <graze/collide.hpp>

#include <cmath>

namespace speed {

namespace {

constexpr std::size_t count = 16384; // more than a branch predictor can remember

double uniform(families::random& r, double low, double high) {
    return low + (high - low) * std::fabs(std::ldexp(static_cast<double>(r.signed_bits(53)), -53));
}

// Balls that fly to a point in or near a wall from up to ten of its lengths; of walls, about two thirds are met.
struct aimed {
    std::vector<ball<3>> balls;
    std::vector<graze::wall<3>> walls;
};
const aimed& aimed_balls() {
    static const aimed result = [] {
        aimed x;
        for (std::size_t i = 0; i < count; ++i) {
            families::random r(20261130, i);
            const auto vector = [&r](double size) {
                return graze::make_vec<3>([&](int) { return uniform(r, -size, size); });
            };
            graze::wall<3> w{vector(1), {vector(2), vector(2)}};
            const double along = uniform(r, -0.5, 1.5), across = uniform(r, -0.5, 1.5);
            const auto target = w.corner + along * w.edge[0] + across * w.edge[1];
            const auto from = vector(30);
            x.balls.push_back({from, uniform(r, 0.05, 0.1) * (target - from), uniform(r, 0.1, 0.5)});
            x.walls.push_back(w);
        }
        return x;
    }();
    return result;
}

template <class T>
graze::vec<3, T> as_vector(const graze::vec<3, double>& x) {
    return graze::make_vec<3>([&](int i) { return static_cast<T>(x[i]); });
}

// Times f(ball, shape) for each pair, which make(i) makes.
template <class Make, class F>
void compare_pairs(const std::string& group, const std::string& name, Make make, F f) {
    using pair = decltype(make(std::size_t{}));
    const auto pairs = std::make_shared<std::vector<pair>>();
    for (std::size_t i = 0; i < count; ++i) {
        pairs->push_back(make(i));
    }
    compare(group, name, count, [pairs, f](std::size_t i) { return f((*pairs)[i].first, (*pairs)[i].second); });
}

template <class F>
void compare_question(const std::string& group, F f) {
    const aimed& x = aimed_balls();
    compare_pairs(
        group, "a ball and a wall", [&x](std::size_t i) { return std::pair(x.balls[i], x.walls[i]); }, f);
    compare_pairs(
        group, "graze, a triangle",
        [&x](std::size_t i) {
            return std::pair(x.balls[i], graze::triangle<double>{x.walls[i].corner, x.walls[i].edge});
        },
        f);
    compare_pairs(
        group, "graze, floats",
        [&x](std::size_t i) {
            const auto& [b, w] = std::pair(x.balls[i], x.walls[i]);
            return std::pair(ball<3, float>{as_vector<float>(b.position), as_vector<float>(b.velocity),
                                            static_cast<float>(b.radius)},
                             graze::wall<3, float>{as_vector<float>(w.corner),
                                                   {as_vector<float>(w.edge[0]), as_vector<float>(w.edge[1])}});
        },
        f);
    compare_pairs(
        group, "graze, a flight",
        [&x](std::size_t i) {
            families::random r(20261201, i);
            return std::pair(graze::flight<3>{x.balls[i], uniform(r, 90, 110)}, x.walls[i]);
        },
        f);
}

} // namespace

void register_flat() {
    compare_question("classify, walls",
                     [](const auto& b, const auto& w) { return graze::is_collision(graze::classify(b, w)); });
    compare_question("a time, rounded, walls", [](const auto& b, const auto& w) {
        const auto t = graze::time_of_impact(b, w);
        return t && static_cast<double>(static_cast<typename std::remove_cvref_t<decltype(*t)>::rounded_type>(*t)) < 9;
    });
    compare_question("a contact, rounded, walls", [](const auto& b, const auto& w) {
        auto c = graze::collide(b, w);
        benchmark::DoNotOptimize(c);
        return c.has_value();
    });
}

} // namespace speed
