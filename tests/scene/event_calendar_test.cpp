// The calendar names the earliest ball, wherever its instant was kept, and loses none.
#include "../property.hpp"

#include <graze/run/event_calendar.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <map>
#include <random>

TEST_CASE("the earliest ball is one of the earliest instant, after any changes") {
    int seen_ahead = 0;
    CHECK(property::check([&seen_ahead] {
        std::mt19937_64 random(property::any<std::uint64_t>());
        const auto instants = property::one_of<std::uint64_t>(1, 20, 1U << 30); // few values make many ties
        const auto balls = property::one_of<graze::detail::body>(1, 2, 70, 400);
        const double never = std::numeric_limits<double>::max();
        graze::detail::event_calendar calendar(balls);
        std::map<graze::detail::body, double> expected;
        double now = 0;
        const auto schedule = [&](graze::detail::body a, double when) {
            calendar.schedule(a, when);
            if (when < never) {
                expected[a] = when;
            } else {
                expected.erase(a);
            }
        };
        for (int round = 0; round < 3000; ++round) {
            const auto a = static_cast<graze::detail::body>(random() % balls);
            const auto kind = random() % 16;
            const double unit = kind == 0 ? 1e9 : kind == 1 ? -1 : 1;
            schedule(a, kind == 2 ? never : now + unit * static_cast<double>(random() % instants));
            if (random() % 4 == 0) {
                const auto first = calendar.earliest();
                PROPERTY_ASSERT((first == graze::detail::no_body) == expected.empty());
                if (!expected.empty()) {
                    double least = never;
                    for (const auto& e : expected) {
                        least = std::min(least, e.second);
                    }
                    PROPERTY_ASSERT(expected.count(first) == 1);
                    PROPERTY_ASSERT(expected[first] == least);
                    PROPERTY_ASSERT(calendar.when(first) == least);
                    double last = least; // of the bucket before
                    for (std::uint32_t later = 1; later < 4; ++later) {
                        double latest = last;
                        calendar.for_each_in(later, [&](graze::detail::body b) {
                            PROPERTY_ASSERT(expected.count(b) == 1);
                            PROPERTY_ASSERT(expected[b] >= last);
                            latest = std::max(latest, expected[b]);
                            ++seen_ahead;
                        });
                        last = latest;
                    }
                    now = std::max(now, least);
                    schedule(first, random() % 2 == 0 ? never : now + static_cast<double>(random() % instants));
                }
            }
        }
        while (!expected.empty()) {
            const auto first = calendar.earliest();
            PROPERTY_ASSERT(expected.count(first) == 1);
            for (const auto& e : expected) {
                PROPERTY_ASSERT(expected[first] <= e.second);
            }
            calendar.remove(first);
            expected.erase(first);
        }
        PROPERTY_ASSERT(calendar.earliest() == graze::detail::no_body);
    }));
    CHECK(seen_ahead > 0);
}
