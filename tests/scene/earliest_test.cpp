// Candidates for the next event are put in canonical order, and each is kept once: few, and many.
#include <graze/run/earliest.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <tuple>
#include <vector>

TEST_CASE("candidates are sorted by bodies and image, without duplicates") {
    using graze::detail::body;
    using key = std::tuple<body, body, int>;
    std::mt19937_64 random(3);
    for (const std::size_t count : {0U, 1U, 2U, 7U, 32U, 33U, 300U}) {
        for (int round = 0; round < 20; ++round) {
            std::vector<graze::detail::timed_event<double>> events;
            std::vector<key> expected;
            for (std::size_t i = 0; i < count; ++i) {
                const auto a = static_cast<body>(random() % 9), b = static_cast<body>(random() % 9);
                const auto along = static_cast<std::int32_t>(random() % 3) - 1;
                events.push_back({{0, a, b, 0, 0, graze::detail::whole_periods{along, 0, 0}}, 0});
                expected.emplace_back(a, b, along);
            }
            std::sort(expected.begin(), expected.end());
            expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
            graze::detail::put_in_order(events);
            std::vector<key> found;
            for (const auto& e : events) {
                found.emplace_back(e.what.a, e.what.b, e.what.image[0]);
            }
            CHECK(found == expected);
        }
    }
}
