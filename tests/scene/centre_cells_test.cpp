// Cells find the same points near a given one, and their images, as a search through all points does: with few points,
// and with so many that the lists of cells are followed side by side.
#include <graze/scene/centre_cells.hpp>
#include <graze/scene/home_place.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <tuple>
#include <vector>

namespace {

using graze::detail::body;
using point = graze::vec<2, double>;
using found_image = std::tuple<body, int, int>;

struct drawn_points {
    std::vector<point> at;
    std::vector<double> reach;
    point period;
};

// Points in [-1/2, 1/2] along each axis, some at its ends; their reaches belong to several levels.
drawn_points draw(std::size_t count, const point& period, double usual) {
    std::mt19937_64 random(count);
    const auto any = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
    drawn_points all{{}, {}, period};
    for (std::size_t i = 0; i < count; ++i) {
        const double x = i % 17 == 0 ? 0.5 : i % 19 == 0 ? -0.5 : any();
        all.at.push_back({x, any()});
        all.reach.push_back(usual * (i % 50 == 0 ? 3.5 : i % 3 == 0 ? 0.1 : 1 + any()));
    }
    return all;
}

std::vector<found_image> by_looking_at_all(const drawn_points& all, const point& x, double reach) {
    std::vector<found_image> found;
    const int most = static_cast<int>(reach) + 2;
    const int along_x = all.period[0] > 0 ? most : 0, along_y = all.period[1] > 0 ? most : 0;
    for (body b = 0; b < all.at.size(); ++b) {
        for (int i = -along_x; i <= along_x; ++i) {
            for (int k = -along_y; k <= along_y; ++k) {
                const double dx = all.at[b][0] - x[0] + i * all.period[0];
                const double dy = all.at[b][1] - x[1] + k * all.period[1];
                const double near = reach + all.reach[b];
                if (dx * dx + dy * dy <= near * near) {
                    found.emplace_back(b, i, k);
                }
            }
        }
    }
    return found;
}

void compare(std::size_t count, const point& period, double usual, double own) {
    const drawn_points all = draw(count, period, usual);
    graze::detail::centre_cells<2> cells(count, usual, period);
    for (body b = 0; b < count; ++b) {
        if (b == count / 2) {
            cells.make_level(own); // has the points of finer levels as well, those before and those to come
        }
        cells.make_level(all.reach[b]);
        cells.enter(b, all.at[b], all.reach[b]);
        if (b % 7 == 0) {
            const double other = all.reach[b / 2];
            cells.make_level(other);
            cells.leave(b);
            cells.enter(b, all.at[b], other);
            cells.leave(b);
            cells.make_level(all.reach[b]);
            cells.enter(b, all.at[b], all.reach[b]);
        }
    }
    int wrong = 0;
    std::size_t images = 0;
    for (std::size_t i = 0; i < 40; ++i) {
        const point& x = all.at[i * (count / 40)];
        std::vector<found_image> found;
        cells.around(x, own, false, [&](body b, graze::detail::image_code code) {
            const graze::detail::image_index image = graze::detail::decoded(code);
            found.emplace_back(b, image[0], image[1]);
            images += image == graze::detail::image_index{} ? 0 : 1;
        });
        std::sort(found.begin(), found.end());
        wrong += found == by_looking_at_all(all, x, own) ? 0 : 1;
    }
    CHECK(wrong == 0);
    CHECK((images > 0) == (period[0] > 0 || period[1] > 0));
}

} // namespace

TEST_CASE("cells find what looking at all points finds") {
    for (const std::size_t count : {std::size_t{200}, graze::detail::fit_into_cache + 1000}) {
        const double usual = 0.5 / std::sqrt(static_cast<double>(count));
        for (const double own : {usual, 8 * usual, 0.6}) {
            compare(count, {0, 0}, usual, own);
            compare(count, {1, 0}, usual, own);
            compare(count, {1, 1}, usual, own);
        }
    }
}

TEST_CASE("cells find all images where a reach is many periods") {
    for (const double own : {3.0, 4.0, 11.0}) {
        compare(80, {1, 0}, 0.05, own);
        compare(80, {1, 1}, 0.05, own);
    }
}

TEST_CASE("cells find points at the very end of the reach, in all directions") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> part(-0.5, 0.5);
    const double usual = 0.04, own = 0.03, reach = 0.035;
    int found = 0, searches = 0;
    for (const point& period : {point{0, 0}, point{1, 1}}) {
        for (int round = 0; round < 20'000; ++round) {
            const double angle = 7 * part(random), far = (own + reach) * (1 - 0x1p-40);
            const point x{part(random), part(random)}, at{x[0] + far * std::cos(angle), x[1] + far * std::sin(angle)};
            graze::detail::centre_cells<2> cells(64, usual, period); // with so many, cells are worth their cost
            cells.make_level(reach);
            cells.enter(0, graze::detail::home_place<2>(at, period).at, reach);
            cells.around(x, own, false, [&](body, graze::detail::image_code) { ++found; });
            ++searches;
        }
    }
    CHECK(found == searches);
}
