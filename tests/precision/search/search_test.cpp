// The search on small formulas: no find is lost, and all shards together are one search.
#include "../../property.hpp"
#include "float_order.hpp"
#include "run.hpp"

#include <graze/number/floating.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

namespace {

using graze::precision::answer;
using graze::precision::quantity;

// Two balls' a: an error of at most one or two units, with many maxima.
struct square_of_speed {
    static inline std::uint64_t calls = 0, stop_at = 0;
    static inline std::atomic<bool> stop = false;
    static constexpr const char* name = "square";
    static constexpr quantity measures = quantity::coefficient_a;
    template <int N, class T>
    answer operator()(const graze::ball<N, T>& a, const graze::ball<N, T>& b) const {
        stop = stop || ++calls == stop_at;
        return graze::precision::answered(quantity::coefficient_a, graze::squared_norm(a.velocity - b.velocity));
    }
};

// Decides by rounded coefficients: wrong if balls graze. Does not answer about walls.
struct plain_decision {
    static constexpr const char* name = "plain";
    static constexpr quantity measures = quantity::encounter;
    template <int N, class T>
    answer operator()(const graze::ball<N, T>& a, const graze::ball<N, T>& b) const {
        const auto dx = a.position - b.position, du = a.velocity - b.velocity;
        const T R = a.radius + b.radius, h = graze::dot(dx, du), c = graze::dot(dx, dx) - R * R;
        const T d = h * h - graze::dot(du, du) * c;
        using graze::encounter;
        return graze::precision::answered(h >= 0   ? encounter::recede
                                          : c < 0  ? encounter::overlap
                                          : d < 0  ? encounter::miss
                                          : d == 0 ? encounter::graze
                                                   : encounter::hit);
    }
};

// Orders by rounded times: wrong if both are nearly equal.
struct plain_order {
    static constexpr const char* name = "plain";
    static constexpr quantity measures = quantity::order;
    template <int N, class T>
    answer operator()(const graze::ball<N, T>& a, const graze::ball<N, T>& b, const graze::ball<N, T>& c,
                      const graze::ball<N, T>& d) const {
        const T t = time(a, b), u = time(c, d);
        answer found;
        found.order = t < u ? -1 : t > u ? 1 : 0;
        return found;
    }

  private:
    template <int N, class T>
    static T time(const graze::ball<N, T>& a, const graze::ball<N, T>& b) {
        const auto dx = a.position - b.position, du = a.velocity - b.velocity;
        const T R = a.radius + b.radius, q = graze::dot(du, du), h = graze::dot(dx, du);
        return (-h - std::sqrt(h * h - q * (graze::dot(dx, dx) - R * R))) / q;
    }
};

const graze::precision::subjects& formulas() {
    static const graze::precision::subjects list = [] {
        graze::precision::subjects all;
        graze::precision::add<square_of_speed, float>(all);
        graze::precision::add<plain_decision, double>(all);
        graze::precision::add<plain_order, double>(all);
        return all;
    }();
    return list;
}

search::terms terms_of(const char* aim, const char* figure, std::vector<std::string> families) {
    search::terms t{aim, figure, std::move(families)};
    t.evaluations = 3000;
    return t;
}
const search::terms of_error = terms_of("error", "coefficient_a/square/float", {"generic"});

std::string searched(search::terms t, std::uint64_t tries) {
    const auto g = search::goal_of(t, formulas());
    search::kept_file file;
    file.of = t;
    CHECK(search::go_on(file, g, search::families_of(t), {tries, nullptr, {}, {}}));
    return search::text_of(file, g);
}

std::filesystem::path scratch(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("graze-search-test-" + name);
}

std::string text_in(const std::filesystem::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("places are in the order of the floats, neighbours one apart") {
    CHECK(property::check([] {
        const auto place = property::in_range(-search::last_place, search::last_place);
        const double x = search::at_place(place);
        PROPERTY_ASSERT(std::isfinite(x));
        PROPERTY_ASSERT(search::place_of(x) == place);
        PROPERTY_ASSERT(search::at_place(place + 1) == std::nextafter(x, INFINITY));
    }));
    CHECK(search::place_of(-0.0) == 0);
}

TEST_CASE("a try ends where no flipped bit is worse, above what random pairs show") {
    const auto g = search::goal_of(of_error, formulas());
    const auto families = search::families_of(of_error);
    double random = 0;
    for (const auto& p : families.front().pairs) {
        random = std::max(random, g.score(p).value_or(0));
    }
    double best = 0;
    int tops = 0;
    for (std::uint64_t attempt = 0; attempt < 3; ++attempt) {
        const auto f = search::repeat(g, families, of_error, attempt, 8);
        REQUIRE(f);
        best = std::max(best, f->score);
        if (!f->climbing && ++tops == 1) {
            auto pair = f->pair;
            auto numbers = std::visit([](const auto& p) { return precision::numbers_of(p); }, pair);
            for (double& x : numbers) {
                for (int bit = 0; bit < 62; ++bit) {
                    const double before = x;
                    x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ std::uint64_t{1} << bit);
                    if (std::isfinite(x)) {
                        std::visit([&](auto& p) { precision::set_numbers(p, numbers); }, pair);
                        CHECK(g.score(pair).value_or(0) <= f->score);
                    }
                    x = before;
                }
            }
        }
    }
    CHECK(tops > 0);
    CHECK(best > random);
}

TEST_CASE("wrong decisions are found, nearer to the border and farther from it") {
    for (const char* aim : {"nearest", "farthest"}) {
        const auto t = terms_of(aim, "encounter/plain/double", {"grazing"});
        const auto g = search::goal_of(t, formulas());
        const auto families = search::families_of(t);
        std::optional<search::found> best;
        for (std::uint64_t attempt = 0; attempt < 4; ++attempt) {
            const auto f = search::repeat(g, families, t, attempt, 1);
            if (f && (!best || f->score > best->score)) {
                best = f;
            }
        }
        REQUIRE(best);
        REQUIRE(g.is_found(best->score));
        const auto shrunk = search::shrink(g, *best);
        CHECK(g.is_found(shrunk.score));
        CHECK(shrunk.score >= best->score - 1);
        CHECK(precision::to_line(shrunk.pair).size() <= precision::to_line(best->pair).size());
        const auto judged = precision::judge_one(*g.formulas.front(), quantity::encounter, shrunk.pair);
        REQUIRE(judged);
        CHECK(judged->wrong);
        CHECK(g.tell(shrunk.score).starts_with("wrong at 2^-"));
        const std::string told = g.tell(best->score);
        const double bits = std::stod(told.substr(told.find("2^") + 2));
        CHECK((*aim == 'n' ? bits < -60 : bits > -60));
    }
}

TEST_CASE("wrong orders of two pairs are found, kept, shrunk and read by the suite") {
    const auto t = terms_of("farthest", "order/plain/double", {"equal_times"});
    const auto g = search::goal_of(t, formulas());
    search::kept_file file;
    file.of = t;
    CHECK(search::go_on(file, g, search::families_of(t), {3, nullptr, {}, {}}));
    REQUIRE_FALSE(file.pairs.empty());
    const auto& worst = file.pairs.front();
    REQUIRE(worst.at.other);
    CHECK(g.tell(worst.at.score).starts_with("wrong at 2^-"));
    const auto judged = precision::judge_one(*g.formulas.front(), quantity::order, worst.at.pair, &*worst.at.other);
    REQUIRE(judged);
    CHECK(judged->wrong);
    CHECK_FALSE(worst.shrunk.empty());
    const auto path = scratch("orders.txt");
    search::write(path, file, g);
    CHECK(search::text_of(search::read_kept(path), g) == text_in(path));
    search::check(search::read_kept(path), g);
    const auto read = precision::read_inputs(path).pairs; // pairs 2i and 2i + 1 are an order there
    std::filesystem::remove(path);
    REQUIRE(read.size() % 2 == 0);
    CHECK(precision::to_line(read[0]) + "\n" + precision::to_line(read[1]) == worst.at.lines());
    CHECK_THROWS_AS(static_cast<void>(search::goal_of(terms_of("error", "order/plain/double", {}), formulas())),
                    std::invalid_argument);
}

TEST_CASE("shards make different tries, and merged they are the whole search") {
    const std::string whole = searched(of_error, 6);
    std::set<std::uint64_t> tries;
    std::vector<search::kept_file> parts;
    for (std::uint64_t shard = 0; shard < 3; ++shard) {
        search::terms t = of_error;
        t.shard = shard;
        t.shards = 3;
        const auto path = scratch("shard");
        std::ofstream(path) << searched(t, 6);
        parts.push_back(search::read_kept(path));
        std::filesystem::remove(path);
        for (const auto& p : parts.back().pairs) {
            CHECK(p.attempt % 3 == shard);
            CHECK(tries.insert(p.attempt).second);
        }
    }
    auto merged = search::merged(parts);
    const auto path = scratch("whole");
    std::ofstream(path) << whole;
    const auto at_once = search::read_kept(path);
    std::filesystem::remove(path);
    REQUIRE(merged.pairs.size() == at_once.pairs.size());
    for (std::size_t i = 0; i < merged.pairs.size(); ++i) {
        CHECK(precision::to_line(merged.pairs[i].at.pair) == precision::to_line(at_once.pairs[i].at.pair));
        CHECK(merged.pairs[i].origin == at_once.pairs[i].origin);
    }
    search::kept_file other = parts[0];
    other.of.seed = 2;
    CHECK_THROWS_WITH_AS(static_cast<void>(search::merged({parts[0], other})), doctest::Contains("another search"),
                         std::runtime_error);
}

TEST_CASE("stopped and gone on with, a search finds what it would have found, and so does climbing on") {
    const auto g = search::goal_of(of_error, formulas());
    const auto families = search::families_of(of_error);
    search::kept_file whole;
    whole.of = of_error;
    CHECK(search::go_on(whole, g, families, {5, nullptr, {}, {}}));
    const std::string after_tries = search::text_of(whole, g);
    CHECK(search::go_on(whole, g, families, {5, nullptr, {}, {}}));
    const std::string after_climbs = search::text_of(whole, g);
    CHECK(after_climbs != after_tries);
    const auto path = scratch("stopped");
    search::kept_file file;
    file.of = of_error;
    search::write(path, file, g);
    for (const std::string& expected : {after_tries, after_climbs}) {
        int stops = 0;
        bool within = false;
        for (bool done = false; !done; ++stops) { // stops whenever the calls are used up, mostly within a try or climb
            REQUIRE(stops < 20);
            file = search::read_kept(path);
            const double before = file.pairs.empty() ? 0 : file.pairs.front().at.score;
            square_of_speed::stop = false;
            square_of_speed::stop_at = square_of_speed::calls + 8000;
            search::plan p{5, &square_of_speed::stop, {}, {}};
            p.saved = [&](const search::kept_file& f) { search::write(path, f, g); };
            done = search::go_on(file, g, families, p);
            file = search::read_kept(path);
            CHECK((file.pairs.empty() ? 0 : file.pairs.front().at.score) >= before); // nothing is lost
            within = within || std::ranges::any_of(file.pairs, &search::kept_pair::partial);
        }
        CHECK(stops > 1);
        CHECK(within);
        CHECK(search::text_of(search::read_kept(path), g) == expected);
    }
    std::filesystem::remove(path);
}

TEST_CASE("pairs of a stopped try stand beside what is there until the try is made again") {
    std::vector<search::kept_pair> pairs;
    const auto families = search::families_of(of_error);
    const auto& drawn = families.front().pairs;
    for (std::uint64_t i = 0; i < search::most_kept; ++i) {
        search::keep(pairs, {{drawn[i], 10.0 + static_cast<double>(i), false}, i, 1, false, "", "made"});
    }
    search::keep(pairs, {{drawn[20], 50, true}, 3, 2, true, "", "stopped"});
    CHECK(pairs.size() == search::most_kept + 1);
    CHECK(pairs.front().origin == "stopped");
    search::keep(pairs, {{drawn[21], 60, true}, 3, 2, false, "", "made again"});
    CHECK(pairs.size() == search::most_kept);
    CHECK(pairs.front().origin == "made again");
    CHECK(pairs.back().at.score == 10);
}

TEST_CASE("the precision suite reads what is kept, and a file that is none is refused") {
    const auto path = scratch("kept.txt");
    std::ofstream(path) << searched(of_error, 2);
    CHECK(precision::read_inputs(path).pairs.size() >= search::read_kept(path).pairs.size());
    std::ofstream(path) << "ball-ball 2 0x0p+0\n";
    CHECK_THROWS_WITH_AS(static_cast<void>(search::read_kept(path)), doctest::Contains(":1: no line"),
                         std::runtime_error);
    std::ofstream(path) << "# nothing\n";
    CHECK_THROWS_WITH_AS(static_cast<void>(search::read_kept(path)), doctest::Contains("not a search's"),
                         std::runtime_error);
    std::filesystem::remove(path);
    CHECK(text_in(path).empty());
}
