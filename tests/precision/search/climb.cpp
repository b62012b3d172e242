#include "climb.hpp"

#include "float_order.hpp"

#include "../shrink.hpp"

#include "../../../examples/families/random.hpp"

#include <algorithm>
#include <cmath>

namespace search {

namespace {

using families::random;
using row = std::vector<double>;

// Lengths and velocities beyond these occur only if the family that a try starts from has them.
constexpr std::int64_t widest = place_of(0x1p64), narrowest = place_of(0x1p-64);

struct range {
    std::int64_t low, high;
};

row numbers_of(const any_pair& p) {
    return std::visit([](const auto& q) { return precision::numbers_of(q); }, p);
}

// The numbers of both pairs, one after the other.
row numbers_of(const found& f) {
    row all = numbers_of(f.pair);
    if (f.other) {
        const row more = numbers_of(*f.other);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}
void set_numbers(found& f, const row& numbers) {
    std::visit([&](auto& q) { precision::set_numbers(q, numbers); }, f.pair);
    if (f.other) {
        const row rest(numbers.begin() + static_cast<std::ptrdiff_t>(numbers_of(f.pair).size()), numbers.end());
        std::visit([&](auto& q) { precision::set_numbers(q, rest); }, *f.other);
    }
}
std::vector<magnitudes::range> ranges_of(const goal& g, const found& f) {
    std::vector<magnitudes::range> all = g.within.of(f.pair);
    if (f.other) {
        const auto more = g.within.of(*f.other);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

std::optional<double> score_of(const goal& g, found& at, const row& numbers, allowance& left) {
    if (left.spent()) {
        return std::nullopt;
    }
    --left.evaluations;
    set_numbers(at, numbers);
    return at.score_by(g);
}

// A range around x, 2^bits to both sides, of the same sign and within the magnitudes: only the climb changes signs.
// Masses stay.
range about(double x, int bits, const magnitudes::range& within) {
    const std::int64_t at = place_of(x), reach = std::int64_t{1} << bits;
    if (at == 0 || !std::isfinite(x)) {
        return {at, at};
    }
    const std::int64_t size = at < 0 ? -at : at;
    const std::int64_t low = std::max({size - reach, std::min(size, narrowest), place_of(within.low)});
    std::int64_t high = std::min(size + reach, std::max(size, widest));
    high = std::isfinite(within.high) ? std::min(high, place_of(within.high)) : high;
    return at < 0 ? range{-high, -low} : range{low, high};
}

// The nearest number of the same sign that is within the range; 0 and infinity stay.
double moved_into(double x, const magnitudes::range& within) {
    return x == 0 || !std::isfinite(x) ? x : std::copysign(std::clamp(std::fabs(x), within.low, within.high), x);
}

double drawn_from(const range& r, random& source) {
    const auto width = static_cast<std::uint64_t>(r.high - r.low) + 1;
    return at_place(r.low + static_cast<std::int64_t>(source.below(width)));
}

struct sample {
    row numbers;
    double score;
};

// The best of a few samples from the box.
std::optional<sample> best_of(const goal& g, found& p, const std::vector<range>& box, random& source, allowance& left) {
    constexpr int draws = 6;
    std::optional<sample> best;
    for (int i = 0; i < draws; ++i) {
        row numbers;
        for (const range& r : box) {
            numbers.push_back(drawn_from(r, source));
        }
        const auto score = score_of(g, p, numbers, left);
        if (score && (!best || *score > best->score)) {
            best = sample{numbers, *score};
        }
    }
    return best;
}

std::vector<double> changed(const row& numbers, std::size_t i) {
    const double x = numbers[i];
    const std::int64_t at = place_of(x);
    std::vector<double> all;
    for (int bit = 61; bit >= 0; --bit) { // large changes first
        all.push_back(std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ std::uint64_t{1} << bit));
        for (const std::int64_t step : {std::int64_t{1} << bit, -(std::int64_t{1} << bit)}) {
            if (bit < 53 && at + step <= last_place && at + step >= -last_place) {
                all.push_back(at_place(at + step));
            }
        }
    }
    all.push_back(-x);
    all.push_back(0);
    all.insert(all.end(), numbers.begin(), numbers.end());
    std::erase_if(all, [&](double y) { return !std::isfinite(y) || y == x; });
    return all;
}

} // namespace

std::optional<found> descend(const goal& g, const std::vector<precision::family>& families, std::uint64_t seed,
                             std::uint64_t index, allowance& left) {
    random source(seed ^ 0x7365617263680000U, index);
    const auto& family = families[source.below(families.size())].pairs;
    std::size_t drawn = source.below(family.size());
    found p;
    if (g.is_about_orders()) { // pairs 2i and 2i + 1
        drawn -= drawn % 2;
        p.other = family[std::min(drawn + 1, family.size() - 1)];
    }
    p.pair = family[drawn];
    row start = numbers_of(p);
    const std::vector<magnitudes::range> within = ranges_of(g, p);
    const int bits = static_cast<int>(source.below(60));
    std::vector<range> box;
    for (std::size_t i = 0; i < start.size(); ++i) {
        start[i] = moved_into(start[i], within[i]);
        const double x = start[i];
        box.push_back(source.one_in(4) ? range{place_of(x), place_of(x)} : about(x, bits, within[i]));
    }
    std::optional<sample> best;
    if (const auto score = score_of(g, p, start, left)) {
        best = sample{start, *score};
    }
    for (std::size_t stuck = 0, turn = source.below(box.size()); stuck < box.size() && !left.spent(); ++turn) {
        range& r = box[turn % box.size()];
        if (r.low >= r.high) {
            ++stuck;
            continue;
        }
        stuck = 0;
        const range whole = r;
        const std::int64_t middle = whole.low + (whole.high - whole.low) / 2;
        r = {whole.low, middle};
        const auto low = best_of(g, p, box, source, left);
        r = {middle + 1, whole.high};
        const auto high = best_of(g, p, box, source, left);
        const bool lower = low && (!high || low->score > high->score);
        r = lower || (!high && source.one_in(2)) ? range{whole.low, middle} : r;
        for (const auto& one : {low, high}) {
            if (one && (!best || one->score > best->score)) {
                best = one;
            }
        }
    }
    if (!best) {
        return std::nullopt;
    }
    set_numbers(p, best->numbers);
    p.score = best->score;
    p.climbing = true;
    return p;
}

void climb(const goal& g, found& at, allowance& left) {
    row numbers = numbers_of(at);
    found p = at;
    std::size_t unchanged = 0;
    for (std::size_t i = 0; unchanged < numbers.size() && !left.spent(); i = (i + 1) % numbers.size()) {
        ++unchanged;
        const row before = numbers;
        for (const double y : changed(before, i)) {
            row candidate = numbers;
            candidate[i] = y;
            const auto score = score_of(g, p, candidate, left);
            if (score && *score > at.score) {
                at.score = *score;
                numbers = candidate;
                unchanged = 0;
            }
        }
    }
    set_numbers(at, numbers);
    at.climbing = unchanged < numbers.size();
}

found shrink(const goal& g, const found& f, double share) {
    const bool is_share = g.what == aim::error || g.what == aim::fallback;
    const double least = is_share ? share * f.score : f.score - 1;
    found small = f;
    const auto still_shows = [&](const any_pair& p, const any_pair* other) {
        const auto score = g.score(p, other);
        return score && *score >= least && g.is_found(*score) == g.is_found(f.score);
    };
    const any_pair* const other = small.other ? &*small.other : nullptr;
    small.pair = precision::shrunk(f.pair, [&](const any_pair& q) { return still_shows(q, other); });
    if (f.other) {
        small.other = precision::shrunk(*f.other, [&](const any_pair& q) { return still_shows(small.pair, &q); });
    }
    small.score = small.score_by(g).value();
    return small;
}

} // namespace search
