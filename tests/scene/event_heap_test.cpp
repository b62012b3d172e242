// The heap returns the predictions that still hold in the order of time, wherever they waited, and loses none.
#include <graze/scene/event_heap.hpp>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <random>
#include <set>

namespace {

using graze::detail::event_heap;
using graze::detail::foreseen;

} // namespace

TEST_CASE("what comes to the top is the earliest of all that is in it") {
    CHECK(rc::check([] {
        std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
        const auto instants = *rc::gen::element<std::uint64_t>(1, 20, 1U << 30); // few: ties everywhere
        const auto stale_from = *rc::gen::inRange<std::uint32_t>(1, 9);
        const auto is_stale = [&](const foreseen& f) { return f.count_a >= stale_from; };
        event_heap heap;
        std::multiset<double> expected;
        double now = 0;
        for (int round = 0; round < 40; ++round) {
            for (auto pushes = random() % 400; pushes > 0; --pushes) {
                const double when = now + static_cast<double>(random() % instants);
                const foreseen f{when, 0, 1, static_cast<std::uint32_t>(random() % 8), 0};
                heap.make_room(1);
                heap.push(f);
                if (!is_stale(f)) {
                    expected.insert(when);
                }
            }
            if (random() % 8 == 0) {
                heap.purge(is_stale);
                RC_ASSERT(heap.size() == expected.size());
            }
            for (auto pops = random() % 400; pops > 0 && heap.has_top(is_stale); --pops) {
                if (!is_stale(heap.top())) {
                    now = heap.top().lower;
                    RC_ASSERT(now == *expected.begin());
                    expected.erase(expected.begin());
                }
                heap.pop();
            }
        }
        while (heap.has_top(is_stale)) {
            if (!is_stale(heap.top())) {
                RC_ASSERT(heap.top().lower == *expected.begin());
                expected.erase(expected.begin());
            }
            heap.pop();
        }
        RC_ASSERT(expected.empty());
        RC_ASSERT(heap.size() == 0);
    }));
}
