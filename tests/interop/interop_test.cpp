// Shapes with the vectors of Eigen, glm, Bullet and others: what is known of a few pairs, and the same bits as for
// graze's own shapes for many.
#include <graze/batch.hpp>
#include <graze/graze.hpp>

#if __has_include(<Eigen/Core>)
#include <graze/linear/adapter/eigen.hpp>
#define HAS_EIGEN
#endif
#if __has_include(<glm/vec3.hpp>)
#include <graze/linear/adapter/glm.hpp>
#define HAS_GLM
#endif
#if __has_include(<LinearMath/btVector3.h>)
#include <graze/linear/adapter/bullet.hpp>
#define HAS_BULLET
#endif

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

template <class V, class T>
struct particle {
    V position, velocity;
    T radius, mass;
};
template <class V>
struct half_space {
    V point, normal;
};
template <class V>
struct quad {
    V origin, along, across;
};

struct by_member {
    double x, y, z;
};
class by_call {
  public:
    by_call(float x, float y) : x_(x), y_(y) {}
    float x() const { return x_; }
    float y() const { return y_; }

  private:
    float x_, y_;
};

} // namespace

template <class V>
struct graze::wall_access<quad<V>> {
    static const V& corner(const quad<V>& q) { return q.origin; }
    static const V& edge(const quad<V>& q, int i) { return i == 0 ? q.along : q.across; }
};

namespace {

// A ball of radius 1 from (-4, 0, 3) with velocity (1, 0, 0) meets one of radius 4 at the origin at t = 0: R = 5, and
// at a height of 3 the contact is 4 before the origin. From (-9, 0, 3) it does so at t = 5. The normal is (-4, 0, 3)/5,
// and the ball keeps u - 2 (u·n) n m_b/(m_a + m_b).
template <class V, class T>
void check_in_space() {
    using P = particle<V, T>;
    const P a{V{T(-9), T(0), T(3)}, V{T(1), T(0), T(0)}, T(1), T(1)};
    const P b{V{T(0), T(0), T(0)}, V{T(0), T(0), T(0)}, T(4), T(1)};
    CHECK(graze::classify(a, b) == graze::encounter::hit);
    CHECK(graze::time_of_impact(a, b) == T(5));
    CHECK(!graze::overlaps(a, b));
    const auto c = graze::collide(a, b);
    REQUIRE(c);
    CHECK(c->time == 5);
    CHECK(c->normal == graze::vec<3, T>{T(-0.8L), T(0), T(0.6L)});
    CHECK(c->velocity_a == graze::vec<3, T>{T(0.36L), T(0), T(0.48L)});
    CHECK(c->velocity_b == graze::vec<3, T>{T(0.64L), T(0), T(-0.48L)});
    CHECK(graze::solve(a, b).what == graze::encounter::hit);

    const half_space<V> floor{V{T(0), T(0), T(-1)}, V{T(0), T(0), T(2)}};
    const P falls{V{T(0), T(0), T(4)}, V{T(0), T(0), T(-2)}, T(1), T(1)};
    CHECK(graze::time_of_impact(falls, floor) == T(2));
    const quad<V> table{V{T(-1), T(-1), T(0)}, V{T(2), T(0), T(0)}, V{T(0), T(2), T(0)}};
    CHECK(graze::classify(falls, table) == graze::encounter::hit);
    CHECK(graze::time_of_impact(falls, table) == T(1.5L));
}

// Gives the same bits as graze's own shapes.
template <class V, class T, class Make>
void check_bits(Make vector) {
    std::mt19937 random(1);
    const auto number = [&] { return static_cast<T>(static_cast<int>(random() % 2001) - 1000) / T(64); };
    int met = 0;
    for (int i = 0; i < 300; ++i) {
        const auto draw = [&] { return graze::vec<3, T>{number(), number(), number()}; };
        const graze::ball<3, T> a{draw(), draw(), T(2), T(3)}, b{draw(), draw(), T(5)};
        const auto foreign = [&](const graze::ball<3, T>& x) {
            return particle<V, T>{vector(x.position), vector(x.velocity), x.radius, x.mass};
        };
        REQUIRE(graze::classify(foreign(a), foreign(b)) == graze::classify(a, b));
        REQUIRE(graze::classify(a, foreign(b)) == graze::classify(a, b));
        const auto c = graze::collide(foreign(a), foreign(b)), d = graze::collide(a, b);
        REQUIRE(c.has_value() == d.has_value());
        if (c) {
            ++met;
            REQUIRE(c->time == d->time);
            REQUIRE(c->velocity_a == d->velocity_a);
            REQUIRE(c->position_b == d->position_b);
        }
    }
    CHECK(met > 10);
}

} // namespace

TEST_CASE("members, calls, arrays") {
    check_in_space<by_member, double>();
    check_in_space<std::array<float, 3>, float>();
    check_bits<by_member, double>([](const auto& v) { return by_member{v[0], v[1], v[2]}; });

    // A graze in the plane: the ball passes at a distance of exactly 3 + 2.
    const particle<by_call, float> a{{-8, 5}, {1, 0}, 3, 1};
    const particle<by_call, float> b{{0, 0}, {0, 0}, 2, 1};
    CHECK(graze::classify(a, b) == graze::encounter::graze);
    CHECK(graze::time_of_impact(a, b) == 8.F);
}

TEST_CASE("batches of foreign balls, and of one foreign thing, answer as those of graze's own") {
    std::mt19937 random(2);
    const auto number = [&] { return static_cast<double>(static_cast<int>(random() % 2001) - 1000) / 64; };
    std::vector<particle<by_member, double>> a, b;
    std::vector<graze::ball<3>> own_a, own_b;
    for (int i = 0; i < 300; ++i) {
        const auto draw = [&] {
            return particle<by_member, double>{{number(), number(), number()}, {number(), number(), number()}, 2, 1};
        };
        a.push_back(draw());
        b.push_back(i % 7 == 0 ? a.back() : draw());
        own_a.push_back(graze::shape_of(a.back()));
        own_b.push_back(graze::shape_of(b.back()));
    }
    const half_space<by_member> floor{{0, 0, -1}, {1, 2, 3}};
    const quad<by_member> pane{{-9, -9, 0}, {18, 0, 1}, {0, 18, 2}};
    const auto agree = [&](const auto& x, const auto& y, const auto& own_x, const auto& own_y) {
        std::array<graze::encounter, 300> what, expected;
        std::array<double, 300> time, expected_time;
        graze::batch::classify(x, y, what);
        graze::batch::classify(own_x, own_y, expected);
        graze::batch::time_of_impact(x, y, time);
        graze::batch::time_of_impact(own_x, own_y, expected_time);
        return what == expected && time == expected_time && what[3] == graze::classify(x[3], [&] {
                                                                if constexpr (requires { y.size(); }) {
                                                                    return y[3];
                                                                } else {
                                                                    return y;
                                                                }
                                                            }());
    };
    CHECK(agree(a, b, own_a, own_b));
    CHECK(agree(a, floor, own_a, graze::shape_of(floor)));
    CHECK(agree(own_a, pane, own_a, graze::shape_of(pane)));
    b[17].radius = -1;
    std::array<graze::encounter, 300> what;
    CHECK_THROWS_WITH(graze::batch::classify(a, b, what), "pair 17: ball b: radius is negative");
}

namespace {
struct fragile {
    by_member position, velocity;
};
} // namespace
template <>
struct graze::ball_access<fragile> {
    static const by_member& position(const fragile& b) { return b.position; }
    static const by_member& velocity(const fragile& b) { return b.velocity; }
    static double radius(const fragile& b) {
        return b.position.x < 0 ? throw std::length_error("no radius") : 1; // an exception that is not graze's
    }
};
TEST_CASE("what a user's type throws leaves a batch") {
    const fragile good{{0, 0, 0}, {1, 0, 0}}, bad{{-1, 0, 0}, {1, 0, 0}};
    const std::vector<fragile> balls{good, good, good, bad, good, good, good, good};
    std::array<graze::encounter, 8> what;
    CHECK_THROWS_WITH_AS(graze::batch::classify(balls, balls, what), "no radius", std::length_error);
    std::array<double, 8> time;
    CHECK_THROWS_WITH_AS(graze::batch::time_of_impact(balls, balls, time), "no radius", std::length_error);
}

TEST_CASE("a flight") {
    struct launched {
        by_member position, velocity;
        double radius, since;
    };
    const launched a{{0, 0, 0}, {1, 0, 0}, 1, 10};
    const launched b{{9, 0, 0}, {0, 0, 0}, 1, 0};
    const auto time = graze::time_of_impact(a, b);
    REQUIRE(time);
    CHECK(static_cast<double>(*time) == 17);
}

TEST_CASE("bad input is named") {
    const particle<by_member, double> a{{0, 0, 0}, {1, 0, 0}, -1, 1}, b{{9, 0, 0}, {0, 0, 0}, 1, 1};
    CHECK_THROWS_WITH((void)graze::classify(a, b), "ball a: radius is negative");
}

#ifdef HAS_EIGEN
TEST_CASE("Eigen") {
    check_in_space<Eigen::Vector3d, double>();
    check_bits<Eigen::Vector3f, float>([](const auto& v) { return Eigen::Vector3f(v[0], v[1], v[2]); });
    const Eigen::Vector2d x(1, 2), y(3, 4);
    CHECK(graze::vec_of(x + 2 * y) == graze::vec<2, double>{7, 10});
    CHECK(graze::vec_of((Eigen::Matrix2d::Identity() * y).eval()) == graze::vec<2, double>{3, 4});
    CHECK(graze::vector_as<Eigen::Vector2d>(graze::vec<2, double>{5, 6}) == Eigen::Vector2d(5, 6));
}
#endif
#ifdef HAS_GLM
TEST_CASE("glm") {
    check_in_space<glm::dvec3, double>();
    check_bits<glm::vec3, float>([](const auto& v) { return glm::vec3(v[0], v[1], v[2]); });
    CHECK(graze::vector_like<glm::vec2>);
    CHECK(graze::vector_as<glm::vec2>(graze::vec<2, float>{5, 6}) == glm::vec2(5, 6));
}
#endif
#ifdef HAS_BULLET
TEST_CASE("Bullet") {
    check_in_space<btVector3, btScalar>();
    CHECK(graze::vector_as<btVector3>(graze::vec<3, btScalar>{5, 6, 7}) == btVector3(5, 6, 7));
}
#endif
