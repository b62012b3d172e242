#include "fallback.hpp"

#include <families/families.hpp>
#include <report/picture.hpp>

#include <graze/contact/collide_balls.hpp>
#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_walls.hpp>

#include <array>
#include <cstdio>

namespace peers {

namespace {

template <int N>
fallback_rate rate_of(const families::family& f, std::uint64_t seed, std::size_t count) {
    fallback_rate rate{std::string(f.name), N, count, 0, 0, 0};
    const auto decide = [&](const auto& a, const auto& b) {
        static_cast<void>(
            graze::classify(a, b, [&](graze::stage s) { rate.decided_exactly += s == graze::stage::exact ? 1U : 0U; }));
    };
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto pair = f.draw<N>(seed, i);
        switch (pair.kind) {
        case families::pair_kind::ball_plane:
            decide(pair.a, pair.plane);
            break;
        case families::pair_kind::ball_wall:
            decide(pair.a, pair.wall);
            break;
        case families::pair_kind::ball_ball: {
            decide(pair.a, pair.b);
            auto by = graze::stage::filter;
            if (graze::collide(pair.a, pair.b, [&](graze::stage s) { by = s; })) {
                ++rate.contacts;
                rate.contacts_exactly += by == graze::stage::exact ? 1U : 0U;
            }
            break;
        }
        }
    }
    return rate;
}

double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string shown(std::size_t part, std::size_t whole) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), whole == 0 ? "–" : "%.1f", percent(part, whole));
    return text.data();
}

} // namespace

std::vector<fallback_rate> fallback_rates(std::uint64_t seed, std::size_t count) {
    std::vector<fallback_rate> rates;
    for (const families::family& f : families::all_families) {
        rates.push_back(rate_of<2>(f, seed, count));
        rates.push_back(rate_of<3>(f, seed, count));
    }
    return rates;
}

std::string table_of(const std::vector<fallback_rate>& rates) {
    std::string text = "\n## fallback rates of graze\n\n| family | in | decided by integers, % | contacts of balls "
                       "that took integers, % |\n|---|---|--:|--:|\n";
    for (const fallback_rate& r : rates) {
        text += "| " + r.family + " | " + std::to_string(r.dimension) + "D | " + shown(r.decided_exactly, r.pairs) +
                " | " + shown(r.contacts_exactly, r.contacts) + " |\n";
    }
    return text;
}

std::string picture_of(const std::vector<fallback_rate>& rates) {
    using namespace compare::report;
    constexpr double left = 200, right = 30, top = 56, bottom = 40, line = 22;
    const auto rows = static_cast<double>(rates.size() / 2);
    picture p("fallback", 1040, static_cast<int>(top + bottom + line * rows),
              "The share of decisions and of contacts that integers had to settle, by family; the table has the same "
              "figures.");
    p.margins(left, right, top, bottom);
    p.add("set xrange [-2:102]\nset yrange [" + exactly(rows - 0.4) + ":-0.6]");
    std::vector<std::pair<double, std::string>> names, shares;
    for (int share = 0; share <= 100; share += 20) {
        shares.emplace_back(share, std::to_string(share) + "%");
    }
    struct series {
        std::string name, rows;
        int dimension;
        bool contacts;
        int marker;
        ink colour;
    };
    std::array<series, 4> all = {{{"decisions in the plane", "", 2, false, 7, ink::one},
                                  {"decisions in space", "", 3, false, 6, ink::one},
                                  {"contacts of balls in the plane", "", 2, true, 5, ink::two},
                                  {"contacts of balls in space", "", 3, true, 4, ink::two}}};
    for (std::size_t i = 0; i < rates.size(); ++i) {
        const fallback_rate& r = rates[i];
        const auto y = static_cast<double>(i / 2);
        if (i % 2 == 0) {
            names.emplace_back(y, r.family);
        }
        for (series& s : all) {
            const std::size_t whole = s.contacts ? r.contacts : r.pairs;
            if (s.dimension == r.dimension && whole != 0) {
                const double share = percent(s.contacts ? r.contacts_exactly : r.decided_exactly, whole);
                const double offset = (s.contacts ? 0.14 : -0.14);
                s.rows += exactly(share) + " " + exactly(y + offset) + " " +
                          p.text(r.family + ", " + s.name + ": " + exactly(share) + "%") + "\n";
            }
        }
    }
    p.tics('x', shares);
    p.tics('y', names);
    std::string blocks, plots;
    double x = left;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string name = "$series" + std::to_string(i);
        blocks += name + " << END\n" + all[i].rows + "END\n";
        plots += (i == 0 ? "" : ", ") + name + " using 1:2:3 with labels hypertext point pt " +
                 std::to_string(all[i].marker) + " ps 0.9 lc " + picture::colour(all[i].colour);
        const std::string y = "screen " + exactly(1 - 16 / (top + bottom + line * rows));
        p.add("set label \"\" at screen " + exactly(x / 1040) + "," + y + " point pt " + std::to_string(all[i].marker) +
              " ps 0.9 lc " + picture::colour(all[i].colour) + " front");
        p.label(all[i].name, "screen " + exactly((x + 10) / 1040), y, "left", ink::muted);
        x += 205;
    }
    p.label("settled by integers →", "graph 1", "screen " + exactly(10 / (top + bottom + line * rows)), "right",
            ink::muted);
    p.add(blocks + "plot " + plots);
    return p.svg();
}

} // namespace peers
