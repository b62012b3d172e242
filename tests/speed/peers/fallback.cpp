#include "fallback.hpp"

#include <families/families.hpp>
#include <report/picture.hpp>

#include <graze/contact/collide_balls.hpp>
#include <graze/predicate/classify_balls.hpp>
#include <graze/predicate/classify_walls.hpp>

#include <array>
#include <cstdio>
#include <numeric>

namespace peers {

namespace {

template <int N>
fallback_rate rate_of(const families::family& f, std::uint64_t seed, std::size_t count) {
    fallback_rate rate{std::string(f.name), N, {}, {}};
    const auto decide = [&](const auto& a, const auto& b) {
        static_cast<void>(
            graze::classify(a, b, [&](graze::stage s) { ++rate.decisions[static_cast<std::size_t>(s)]; }));
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
                ++rate.contacts[static_cast<std::size_t>(by)];
            }
            break;
        }
        }
    }
    return rate;
}

constexpr std::array<const char*, 4> stage_names = {"filter", "refined", "double words", "integers"};

// In percent; all 0 if there are no counts.
std::array<double, 4> shares_of(const stage_counts& counts) {
    const auto all = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
    std::array<double, 4> shares{};
    for (std::size_t i = 0; i < shares.size() && all > 0; ++i) {
        shares[i] = 100 * static_cast<double>(counts[i]) / all;
    }
    return shares;
}

std::string cells_of(const stage_counts& counts) {
    std::string text;
    for (const double share : shares_of(counts)) {
        std::array<char, 32> cell{};
        std::snprintf(cell.data(), cell.size(), " %.1f |", share);
        text += cell.data();
    }
    return text;
}

stage_counts sum_of(stage_counts x, const stage_counts& y) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] += y[i];
    }
    return x;
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
    std::string text = "\n## stages of graze\n\nPer cent of decisions, and of contacts of balls, that the filter, the "
                       "refined stage, double words and integers settled.\n\n| family | in | filter | refined | words "
                       "| integers | contacts: filter | refined | words | integers |\n"
                       "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (const fallback_rate& r : rates) {
        text += "| " + r.family + " | " + std::to_string(r.dimension) + "D |" + cells_of(r.decisions) +
                cells_of(r.contacts) + "\n";
    }
    return text;
}

std::string picture_of(const std::vector<fallback_rate>& rates) {
    using namespace compare::report;
    constexpr double left = 200, right = 30, top = 56, bottom = 40, line = 24;
    constexpr std::array<ink, 4> colours = {ink::grid, ink::one, ink::three, ink::two};
    const auto rows = static_cast<double>(rates.size() / 2);
    const double height = top + bottom + line * rows;
    picture p("fallback", 1040, static_cast<int>(height),
              "The share of decisions and of contacts that each of four stages settled, by family; the table has the "
              "same figures.");
    p.margins(left, right, top, bottom);
    p.add("set xrange [0:100]\nset yrange [" + exactly(rows) + ":0]");
    std::vector<std::pair<double, std::string>> names, marks;
    for (int share = 0; share <= 100; share += 20) {
        marks.emplace_back(share, std::to_string(share) + "%");
    }
    const auto bar = [&](const stage_counts& counts, double upper, double lower) {
        double from = 0;
        const std::array<double, 4> shares = shares_of(counts);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            if (shares[i] > 0) {
                p.add("set object rectangle from " + exactly(from) + "," + exactly(upper) + " to " +
                      exactly(from + shares[i]) + "," + exactly(lower) + " fc " + picture::colour(colours[i]) +
                      " fs solid noborder");
            }
            from += shares[i];
        }
    };
    for (std::size_t i = 0; i + 1 < rates.size(); i += 2) { // one in the plane, one in space
        const auto y = static_cast<double>(i / 2);
        names.emplace_back(y + 0.5, rates[i].family);
        bar(sum_of(rates[i].decisions, rates[i + 1].decisions), y + 0.14, y + 0.5);
        bar(sum_of(rates[i].contacts, rates[i + 1].contacts), y + 0.56, y + 0.8);
    }
    p.tics('x', marks);
    p.tics('y', names);
    double x = left;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const auto corner = [&](double dx, double y) {
            return "screen " + exactly((x + dx) / 1040) + ",screen " + exactly(1 - y / height);
        };
        p.add("set object rectangle from " + corner(0, 10) + " to " + corner(12, 22) + " fc " +
              picture::colour(colours[i]) + " fs solid noborder");
        p.label(stage_names[i], "screen " + exactly((x + 18) / 1040), "screen " + exactly(1 - 16 / height), "left",
                ink::muted);
        x += 130;
    }
    p.label("upper bar: decisions; lower: contacts of balls", "graph 1", "screen " + exactly(1 - 16 / height), "right",
            ink::muted);
    p.label("settled by these stages →", "graph 1", "screen " + exactly(10 / height), "right", ink::muted);
    p.add("$ends << END\n0 0\nEND\nplot $ends using 1:2 with points pt 7 ps 0 lc " + picture::colour(ink::paper));
    return p.svg();
}

} // namespace peers
