// graze-costs: nanoseconds for each pair. Prints a line for each figure: contestant, question, value.
#include "costs.hpp"

#include <families/families.hpp>

#include <graze/graze.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <iterator>

namespace {

constexpr std::size_t count = 2048;

costs::balls<> balls_of(const char* family, bool meeting) {
    costs::balls<> r;
    for (std::uint64_t i = 0; r.a.size() < count; ++i) {
        const auto pair = families::find_family(family)->draw<3>(1, i);
        if (pair.kind == families::pair_kind::ball_ball &&
            (!meeting || graze::classify(pair.a, pair.b) == graze::encounter::hit)) {
            r.a.push_back(pair.a);
            r.b.push_back(pair.b);
        }
    }
    return r;
}

costs::walls<> hit_walls() {
    costs::walls<> r;
    for (std::uint64_t i = 0; r.a.size() < count; ++i) {
        const auto pair = families::find_family("generic_wall")->draw<3>(1, i);
        if (pair.kind == families::pair_kind::ball_wall &&
            graze::classify(pair.a, pair.wall) == graze::encounter::hit) {
            r.a.push_back(pair.a);
            r.b.push_back(pair.wall);
        }
    }
    return r;
}

struct timed {
    const char* contestant;
    const char* question;
    std::function<double()> ask;
    double least = 1e99;
};

} // namespace

int main() {
    const costs::pairs all{balls_of("generic", false), balls_of("generic", true), balls_of("grazing", false),
                           hit_walls()};
    const auto right = costs::in_graze(all).encounters();
    std::vector<timed> asked;
    struct entry {
        const char* name;
        costs::contestant (*make)(const costs::pairs&);
    };
    for (const auto& [name, make] : {entry{"doubles", costs::in_doubles}, entry{"graze", costs::in_graze},
                                     entry{"digits", costs::in_digits}, entry{"rationals", costs::in_rationals}}) {
        const costs::contestant c = make(all);
        for (const auto& [question, ask] : {std::pair{"decide", c.decide},
                                            {"decide_grazing", c.decide_grazing},
                                            {"collide", c.collide},
                                            {"collide_wall", c.collide_wall}}) {
            if (ask) {
                asked.push_back({name, question, ask});
            }
        }
        const auto found = c.encounters();
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < right.size(); ++i) {
            wrong += found[i] != right[i] ? 1U : 0U;
        }
        std::printf("%s wrong %.0f\n", name, 100.0 * static_cast<double>(wrong) / static_cast<double>(right.size()));
    }
    double sum = 0;
    for (int round = 0; round < 20; ++round) { // in turns, so that a busy machine affects all alike
        for (timed& t : asked) {
            const auto start = std::chrono::steady_clock::now();
            sum += t.ask();
            const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
            t.least = std::min(t.least, took.count() / count);
        }
    }
    for (const timed& t : asked) {
        std::printf("%s %s %.*f\n", t.contestant, t.question, t.least < 10 ? 1 : 0, t.least);
    }
    return sum == 0 ? 1 : 0;
}
