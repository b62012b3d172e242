// environment_oracle FILE [FACTOR]: writes questions to the predicates, with the answers by the oracle's exact
// arithmetic: FACTOR (1) times seven thousand. Other targets and compilers are then asked them.
#include "../soak/more_families.hpp"
#include "question.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace environments {
namespace {

template <class T>
inline constexpr range range_of{};
template <>
inline constexpr range range_of<float>{-149, 121, 24};
template <>
inline constexpr range range_of<double>{-1074, 1017, 53};
template <>
inline constexpr range range_of<std::int32_t>{0, 25, 31};
template <>
inline constexpr range range_of<std::int64_t>{0, 57, 63};

template <int N>
[[nodiscard]] row row_of(const families::pair_of_doubles<N>& p) {
    row x;
    const auto vector = [&](const graze::vec<N, double>& v) {
        for (const double y : v.component) {
            x.numbers.push_back(number_of(y));
        }
    };
    const auto ball = [&](const graze::ball<N, double>& b) {
        vector(b.position);
        vector(b.velocity);
        x.numbers.push_back(number_of(b.radius));
    };
    ball(p.a);
    if (p.kind == families::pair_kind::ball_ball) {
        x.with = partner::ball;
        ball(p.b);
    } else if (p.kind == families::pair_kind::ball_plane) {
        x.with = partner::plane;
        vector(p.plane.point);
        vector(p.plane.normal);
    } else {
        x.with = partner::wall;
        vector(p.wall.corner);
        for (const auto& e : p.wall.edge) {
            vector(e);
        }
    }
    return x;
}

// Moves each group so that its largest number is among the largest integers or, for float, in range.
template <class T>
void fit(random& r, row& x, int n) {
    const std::vector<place> places = layout(x.with, n);
    units u;
    for (int g = 0; g < 3; ++g) {
        int top = std::numeric_limits<int>::min();
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (static_cast<int>(places[i].what) == g && x.numbers[i].significand != 0) {
                top = std::max(top, top_of(x.numbers[i]));
            }
        }
        int wanted = top;
        if (std::is_integral_v<T>) {
            wanted = range_of<T>.bits - static_cast<int>(r.in(0, 6));
        } else if (top > range_of<T>.high || top < range_of<T>.low + 20) {
            wanted = static_cast<int>(r.in(range_of<T>.low + 10, range_of<T>.high));
        }
        if (top != std::numeric_limits<int>::min()) {
            u.of_group[static_cast<std::size_t>(g)] = wanted - top;
        }
    }
    scale(x, n, u);
}

template <int N, class T>
class questioner {
  public:
    questioner(questions& q, int factor) : questions_(q), factor_(factor) {}

    void operator()() {
        ask_families(families::all_families);
        ask_families(families::more_families);
        ask_drawn();
        std::sort(collisions_.begin(), collisions_.end(),
                  [](const auto& x, const auto& y) { return oracle::compare(*x.truth.time, *y.truth.time) < 0; });
        ask_orders();
        ask_times();
    }

  private:
    using pair_case = std::optional<case_of<T>>;

    template <class Families>
    void ask_families(const Families& all) {
        const int count = (std::is_same_v<T, double> ? 10 : 4) * factor_;
        for (const families::family& f : all) {
            pair_case before;
            for (int i = 0; i < count; ++i) {
                row x = row_of<N>(f.template draw<N>(3, static_cast<std::uint64_t>(i)));
                if (!std::is_same_v<T, double>) {
                    random unit(5, static_cast<std::uint64_t>(i / 2)); // the same for 2i and 2i + 1
                    fit<T>(unit, x, N);
                }
                pair_case c = make_case<N, T>(x, f.name);
                if (!c) {
                    continue;
                }
                ask_decision<N>(questions_, *c);
                if (c->truth.time && before && before->truth.time && i % 2 == 1) {
                    ask_order<N>(questions_, *before, *c);
                }
                before = keep(std::move(c));
            }
        }
    }

    void ask_drawn() {
        for (const std::string_view kind : kinds_of_rows) {
            for (const partner p : partners) {
                if (kind == "grid") {
                    ask_drawn(kind, p, 45 * factor_, [](const oracle::answer&) { return true; });
                    if (p != partner::plane) {
                        ask_drawn(kind, p, 5 * factor_,
                                  [](const oracle::answer& a) { return a.what == oracle::encounter::graze; });
                    }
                } else {
                    ask_drawn(kind, p, 15 * factor_, [](const oracle::answer&) { return true; });
                }
            }
        }
    }

    // As many rows of a kind as wanted that are valid and have a suitable answer.
    template <class Wanted>
    void ask_drawn(std::string_view kind, partner p, int count, Wanted wanted) {
        for (int found = 0, tries = 0; found < count; ++tries) {
            if (tries > 1000 * count) {
                throw std::logic_error("too few pairs: " + std::string(kind) + ' ' + name_of(p));
            }
            pair_case c = make_case<N, T>(draw(random_, kind, p, N, range_of<T>), kind);
            if (c && wanted(c->truth)) {
                ask_decision<N>(questions_, *c);
                keep(std::move(c));
                ++found;
            }
        }
    }

    // Equal times after 0, two neighbours in the order of time, or any two.
    void ask_orders() {
        const std::size_t count = collisions_.size();
        for (const partner p : partners) {
            for (const partner other : partners) {
                for (int i = 0; i < 24 * factor_; ++i) {
                    std::size_t first = find(p, random_.below(count));
                    std::size_t second = i % 4 == 0   ? find(other, random_.below(count))
                                         : i % 2 == 0 ? find(other, first + 1)
                                                      : find(other, first + count - 1, count - 1);
                    if (i % 4 == 3) {
                        std::tie(first, second) = find_tie(other, {first, second});
                    }
                    ask_order<N>(questions_, collisions_[first], collisions_[second]);
                }
            }
        }
    }

    // The next two with equal times, the second one with `other`; without such a tie, the two given.
    [[nodiscard]] std::pair<std::size_t, std::size_t> find_tie(partner other,
                                                               std::pair<std::size_t, std::size_t> given) const {
        const partner p = collisions_[given.first].with;
        for (std::size_t i = 0; i < collisions_.size(); ++i) {
            const std::size_t first = find(p, given.first + i);
            for (const std::size_t step : {std::size_t{1}, collisions_.size() - 1}) {
                const std::size_t second = find(other, first + step, step);
                const oracle::surd& time = *collisions_[first].truth.time;
                if (second != first && sign_of(time) > 0 &&
                    oracle::compare(time, *collisions_[second].truth.time) == 0) {
                    return {first, second};
                }
            }
        }
        return given;
    }

    // The time in T next to a collision's, or the same.
    [[nodiscard]] static std::optional<T> near(const case_of<T>& c) {
        const double time = oracle::nearest_double(*c.truth.time);
        return std::isinf(time) ? std::nullopt : as<T>(number_of(time));
    }

    // The next collision with p whose time is a T, or simply the next.
    [[nodiscard]] std::size_t find_exact(partner p, std::size_t from) const {
        for (std::size_t k = 0; k < collisions_.size(); ++k) {
            const std::size_t at = find(p, from + k);
            const std::optional<T> time = near(collisions_[at]);
            if (time && oracle::compare(*collisions_[at].truth.time, rational_of(*time)) == 0) {
                return at;
            }
        }
        return from;
    }

    // A collision against its own time if that is a T, against a time near it, or against any time.
    void ask_times() {
        for (const partner p : partners) {
            for (int i = 0; i < 40 * factor_; ++i) {
                std::size_t at = find(p, random_.below(collisions_.size()));
                at = i % 4 == 0 ? find_exact(p, at) : at;
                std::optional<T> time = i % 8 == 7 ? std::nullopt : near(collisions_[at]);
                if (time && i % 4 != 0) {
                    time = moved(*time, static_cast<int>(random_.in(-1, 1)));
                }
                while (!time) {
                    const auto exponent = static_cast<int>(random_.in(range_of<T>.low, range_of<T>.high));
                    time = as<T>(number{random_.in(0, 63), exponent});
                }
                ask_against<N>(questions_, collisions_[at], *time);
            }
        }
    }

    // The next or previous T, if there is one.
    [[nodiscard]] static T moved(T x, int steps) {
        if (x == 0 || x >= std::numeric_limits<T>::max()) {
            return x;
        }
        const auto bits = std::bit_cast<bits_of_type<T>>(x);
        return std::bit_cast<T>(static_cast<bits_of_type<T>>(bits + static_cast<bits_of_type<T>>(steps)));
    }

    pair_case keep(pair_case c) {
        if (c->truth.time) {
            collisions_.push_back(*c);
        }
        return c;
    }

    // The first collision with p, from the one at `from` on; backwards if the step is their number less 1.
    [[nodiscard]] std::size_t find(partner p, std::size_t from, std::size_t step = 1) const {
        for (std::size_t i = 0; i < collisions_.size(); ++i) {
            if (const std::size_t at = (from + i * step) % collisions_.size(); collisions_[at].with == p) {
                return at;
            }
        }
        throw std::logic_error(std::string("no collision: ") + name_of(p));
    }

    questions& questions_;
    int factor_;
    random random_{N * 17 + sizeof(T) + (std::is_integral_v<T> ? 1 : 0)};
    std::vector<case_of<T>> collisions_;
};

template <class T>
void ask_type(questions& q, int factor) {
    questioner<2, T>(q, factor)();
    questioner<3, T>(q, factor)();
}

// The answers that must occur for a subject; otherwise its questions are too easy.
void require_all_answers(const questions& q) {
    for (const auto& [subject, lines] : q) {
        std::vector<std::string> wanted{"-1", "0", "1"}; // for an order
        if (subject.starts_with("decide")) {
            wanted = {"1", "2", "3", "8"}; // overlap, recede (also of what overlaps), hit
            if (subject.find("plane") == std::string::npos) {
                wanted.insert(wanted.end(), {"4", "6"}); // miss, graze
            }
        }
        for (const std::string& answer : wanted) {
            if (std::none_of(lines.begin(), lines.end(), [&](const std::string& line) {
                    const std::size_t family_end = line.find(' ', subject.size() + 1);
                    return line.compare(family_end + 1, answer.size() + 1, answer + ' ') == 0;
                })) {
                throw std::logic_error("no question has the answer " + answer + ": " + subject);
            }
        }
    }
}

void write(const char* path, const questions& q) {
    std::ofstream file(path);
    std::size_t count = 0;
    for (const auto& [subject, lines] : q) {
        file << "subject " << lines.size() << ' ' << subject << '\n';
        count += lines.size();
    }
    file << "questions " << count << '\n';
    for (const auto& [subject, lines] : q) {
        for (const std::string& line : lines) {
            file << line << '\n';
        }
    }
    if (!file.flush()) {
        throw std::runtime_error(std::string("cannot write ") + path);
    }
    std::cout << count << " questions about " << q.size() << " subjects\n";
}

} // namespace
} // namespace environments

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        std::cerr << "environment_oracle FILE [FACTOR]\n";
        return 2;
    }
    try {
        environments::questions q;
        const int factor = argc == 3 ? std::atoi(argv[2]) : 1;
        environments::ask_type<float>(q, factor);
        environments::ask_type<double>(q, factor);
        environments::ask_type<std::int32_t>(q, factor);
        environments::ask_type<std::int64_t>(q, factor);
        environments::require_all_answers(q);
        environments::write(argv[1], q);
    } catch (const std::exception& e) {
        std::cerr << "environment_oracle: " << e.what() << '\n';
        return 1;
    }
}
