#include "run.hpp"

#include <algorithm>
#include <limits>

namespace search {

namespace {

std::string origin_of(const terms& t, const kept_pair& p) {
    return command_of(t) + " --try " + std::to_string(p.attempt) + " --climbs " + std::to_string(p.climbs);
}

// Whether p is among the first most_kept.
bool is_kept(const std::vector<kept_pair>& pairs, const kept_pair& p) {
    return std::ranges::count_if(pairs, [&](const kept_pair& q) { return q.at.score > p.at.score; }) <
           static_cast<std::ptrdiff_t>(most_kept);
}

// The best pair that can still climb and has climbed fewer than `climbs` times.
kept_pair* next_climber(std::vector<kept_pair>& pairs, std::uint64_t climbs) {
    const auto at = std::ranges::find_if(
        pairs, [&](const kept_pair& p) { return p.at.climbing && !p.partial && p.climbs < climbs; });
    return at == pairs.end() ? nullptr : &*at;
}

// A round lets the pairs climb that did so least often, up to this number. If stopped, it continues with the rest.
std::uint64_t climbs_of_round(const std::vector<kept_pair>& pairs) {
    std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max() - 1;
    for (const kept_pair& p : pairs) {
        fewest = p.at.climbing && !p.partial ? std::min(fewest, p.climbs) : fewest;
    }
    return fewest + 1;
}

} // namespace

std::optional<found> repeat(const goal& g, const std::vector<precision::family>& families, const terms& of,
                            std::uint64_t attempt, std::uint64_t climbs, const std::atomic<bool>* stop) {
    allowance left{of.evaluations, stop};
    std::optional<found> f = descend(g, families, of.seed, attempt, left);
    if (f) {
        climb(g, *f, left);
    }
    for (std::uint64_t i = 1; f && f->climbing && i < climbs && (stop == nullptr || !stop->load()); ++i) {
        left.evaluations = of.evaluations;
        climb(g, *f, left);
    }
    return f;
}

bool go_on(kept_file& file, const goal& g, const std::vector<precision::family>& families, const plan& p) {
    const auto stopped = [&] { return p.stop != nullptr && p.stop->load(); };
    const auto tell = [&](const kept_pair& k) {
        if (p.told) {
            p.told("try " + std::to_string(k.attempt) + ": " + g.tell(k.at.score) +
                   (k.at.climbing ? ", still climbing" : ", no changed bit is worse"));
        }
    };
    const auto save = [&] {
        if (p.saved) {
            p.saved(file);
        }
    };
    const auto take = [&](kept_pair k) {
        if (g.is_found(k.at.score)) {
            k.partial = stopped();
            tell(k);
            k.origin = origin_of(file.of, k);
            if (!k.partial && is_kept(file.pairs, k)) {
                const std::string small = shrink(g, k.at).lines();
                k.shrunk = small == k.at.lines() ? "" : small;
            }
            keep(file.pairs, std::move(k));
        }
    };
    const bool was_done = file.next >= p.tries;
    file.next = std::max(file.next, file.of.shard);
    while (file.next < p.tries && !stopped()) {
        if (const auto f = repeat(g, families, file.of, file.next, 1, p.stop)) {
            take({*f, file.next, 1, false, {}, {}});
        }
        if (!stopped()) { // if stopped, this try is made again
            file.next += file.of.shards;
        }
        save();
    }
    const std::uint64_t climbs = climbs_of_round(file.pairs);
    while (was_done && !stopped()) {
        kept_pair* const at = next_climber(file.pairs, climbs);
        if (at == nullptr) {
            break;
        }
        kept_pair k = *at;
        allowance left{file.of.evaluations, p.stop};
        climb(g, k.at, left);
        ++k.climbs;
        take(std::move(k));
        save();
    }
    return file.next >= p.tries && !stopped();
}

} // namespace search
