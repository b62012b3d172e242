#include "contact_hash.hpp"

#include "draw.hpp"
#include "subject.hpp"

#include <graze/batch.hpp>
#include <graze/checked.hpp>

#include <bit>
#include <type_traits>
#include <vector>

namespace environments {
namespace {

// FNV-1a over 64-bit words, from each word's lowest byte.
class hash {
  public:
    void add(std::uint64_t x) {
        for (int i = 0; i < 8; ++i) {
            value_ = (value_ ^ (x >> 8 * i & 0xff)) * 0x100000001b3U;
        }
    }
    void add(const double& x) { add(std::bit_cast<std::uint64_t>(x)); }
    void add(const float& x) { add(std::uint64_t{std::bit_cast<std::uint32_t>(x)}); }
    template <int N, class T>
    void add(const graze::vec<N, T>& x) {
        for (const T& y : x.component) {
            add(y);
        }
    }
    template <int N, class T>
    void add(const graze::contact<N, T>& c) {
        add(c.time);
        add(c.position_a);
        add(c.position_b);
        add(c.normal);
        add(c.velocity_a);
        add(c.velocity_b);
    }
    template <int N, class T>
    void add(const graze::wall_contact<N, T>& c) {
        add(c.time);
        add(c.position);
        add(c.point);
        add(c.normal);
        add(c.velocity);
        add(static_cast<std::uint64_t>(c.feature));
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

template <class T>
inline constexpr range range_of = sizeof(T) == 4 ? range{-149, 122, 24} : range{-1074, 1018, 53};

// Numbers with all their bits: a ball in (-1,1)^N flies at a thing near the origin that is a few tenths large.
[[nodiscard]] row draw_generic(random& r, partner p, int n, const range& type) {
    row x{p, {}};
    const auto places = layout(p, n);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool own = i < static_cast<std::size_t>(n);
        const bool is_radius = places[i].axis < 0;
        const std::int64_t value = r.signed_bits(type.bits);
        const int down = type.bits + (own || places[i].what != group::length ? 0 : 2);
        x.numbers.push_back({is_radius && value < 0 ? -value : value, -down});
    }
    if (p != partner::plane && !r.one_in(3)) { // towards the middle
        for (int i = 0; i < n; ++i) {
            const number& from = x.numbers[static_cast<std::size_t>(i)];
            x.numbers[ball_velocity(n, i)] = {-from.significand + r.signed_bits(type.bits - 3), from.exponent};
        }
    }
    return x;
}

// Pair number `index` of a subject, made from bits only: its numbers, and a mass for each ball.
template <partner P, int N, class T>
[[nodiscard]] std::array<T, row_length(P, N) + 2> draw_numbers(std::uint64_t index) {
    random r(20261126, index);
    for (;;) {
        const bool generic = r.one_in(2);
        const auto kind = kinds_of_rows[r.below(kinds_of_rows.size())];
        row x = generic ? draw_generic(r, P, N, range_of<T>) : draw(r, kind, P, N, range_of<T>);
        const auto mass = [&] { x.numbers.push_back({r.in(1, (1 << 20) - 1), static_cast<int>(r.in(-30, 10))}); };
        mass();
        mass();
        std::array<T, row_length(P, N) + 2> numbers{};
        bool fits = true;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const auto value = as<T>(x.numbers[i]);
            fits = fits && value.has_value();
            numbers[i] = value.value_or(T(1));
        }
        if (fits) {
            return numbers;
        }
    }
}

// collide's answer about a pair, or the fact that it rejects the pair.
struct contacts_of {
    static constexpr const char* name = "contacts";

    template <class A, class B>
    static void add(tally& t, hash& h, const A& a, const B& b) {
        auto given_by = graze::stage::filter;
        const auto answer = graze::try_collide(a, b, [&](graze::stage s) { given_by = s; });
        if (!answer.has_value()) {
            h.add(std::uint64_t{2});
            return;
        }
        const auto& contact = *answer;
        h.add(std::uint64_t{contact ? 1U : 0U});
        if (contact) {
            h.add(*contact);
            ++t.contacts;
            t.by_doubles += given_by == graze::stage::filter ? 1 : 0;
        }
    }
};

// A time, rounded to nearest, downward and upward.
struct times_of {
    static constexpr const char* name = "times";

    template <int N, class T, class B>
    static void add(tally& t, hash& h, const graze::ball<N, T>& a, const B& b) {
        const auto answer = graze::try_time_of_impact(a, b);
        if (!answer.has_value()) {
            h.add(std::uint64_t{2});
            return;
        }
        const auto& time = *answer;
        h.add(std::uint64_t{time ? 1U : 0U});
        if (time) {
            h.add(static_cast<T>(*time));
            h.add(time->lower());
            h.add(time->upper());
            ++t.contacts;
        }
    }
};

template <class What, partner P, int N, class T>
tally run(std::uint64_t count) {
    tally t;
    hash h;
    for (std::uint64_t index = 0; index < count; ++index) {
        const auto numbers = draw_numbers<P, N, T>(index);
        with_shapes<P, N>(numbers.data(), [&](auto a, auto b) {
            a.mass = numbers[row_length(P, N)];
            if constexpr (P == partner::ball) {
                b.mass = numbers[row_length(P, N) + 1];
            }
            What::add(t, h, a, b);
        });
    }
    t.hash = h.value();
    return t;
}

template <class What, partner P, int N, class T>
void add(std::vector<hashed_subject>& subjects) {
    subjects.push_back({subject_name<N, T>(What::name, name_of(P)), run<What, P, N, T>});
}

// Times from batches; the hash must be that of times_of. A batch has this many pairs, several registers of either kind.
constexpr std::size_t pairs_a_batch = 300;

template <class T>
struct batch_answers {
    std::vector<graze::encounter> what;
    std::vector<T> nearest, lower, upper;

    template <class A, class B>
    batch_answers(const A& a, const B& b) : what(a.size()), nearest(a.size()), lower(a.size()), upper(a.size()) {
        graze::batch::classify(a, b, what);
        graze::batch::time_of_impact(a, b, nearest);
        graze::batch::time_of_impact(a, b, lower, graze::rounding::downward);
        graze::batch::time_of_impact(a, b, upper, graze::rounding::upward);
    }
    void add(tally& t, hash& h, std::size_t i) const {
        h.add(std::uint64_t{is_collision(what[i]) ? 1U : 0U});
        if (is_collision(what[i])) {
            h.add(nearest[i]);
            h.add(lower[i]);
            h.add(upper[i]);
            ++t.contacts;
        }
    }
};

template <int N, class T>
tally run_batches(std::uint64_t count) {
    tally t;
    hash h;
    for (std::uint64_t first = 0; first < count; first += pairs_a_batch) {
        std::vector<graze::ball<N, T>> a, b;
        std::vector<bool> accepted;
        for (std::uint64_t i = first; i < count && i < first + pairs_a_batch; ++i) {
            const auto numbers = draw_numbers<partner::ball, N, T>(i);
            with_shapes<partner::ball, N>(numbers.data(), [&](const auto& x, const auto& y) {
                accepted.push_back(graze::try_classify(x, y).has_value());
                if (accepted.back()) {
                    a.push_back(x);
                    b.push_back(y);
                }
            });
        }
        const batch_answers<T> answers(a, b);
        std::size_t next = 0;
        for (const bool good : accepted) {
            if (good) {
                answers.add(t, h, next++);
            } else {
                h.add(std::uint64_t{2});
            }
        }
    }
    t.hash = h.value();
    return t;
}

// Makes a batch for each pair's plane or wall, so that the ball is asked about as often as a register has lanes.
template <partner P, int N, class T>
tally run_batches_beside(std::uint64_t count) {
    tally t;
    hash h;
    for (std::uint64_t index = 0; index < count; ++index) {
        const auto numbers = draw_numbers<P, N, T>(index);
        with_shapes<P, N>(numbers.data(), [&](const auto& x, const auto& shape) {
            if (graze::try_classify(x, shape).has_value()) {
                batch_answers<T>(std::vector(8, x), shape).add(t, h, 3);
            } else {
                h.add(std::uint64_t{2});
            }
        });
    }
    t.hash = h.value();
    return t;
}

template <int N, class T>
void add_batches(std::vector<hashed_subject>& subjects) {
    subjects.push_back({subject_name<N, T>(times_of::name, name_of(partner::ball)), run_batches<N, T>});
    subjects.push_back(
        {subject_name<N, T>(times_of::name, name_of(partner::plane)), run_batches_beside<partner::plane, N, T>});
}

// All pair kinds in one dimension and type.
template <int N, class T>
void add_all(std::vector<hashed_subject>& subjects) {
    add<contacts_of, partner::ball, N, T>(subjects);
    add<contacts_of, partner::plane, N, T>(subjects);
    add<contacts_of, partner::wall, N, T>(subjects);
    add<times_of, partner::ball, N, T>(subjects);
    add<times_of, partner::plane, N, T>(subjects);
    add<times_of, partner::wall, N, T>(subjects);
    add_batches<N, T>(subjects);
    subjects.push_back(
        {subject_name<N, T>(times_of::name, name_of(partner::wall)), run_batches_beside<partner::wall, N, T>});
}

} // namespace

std::vector<hashed_subject> hashed_subjects() {
    std::vector<hashed_subject> subjects;
    if constexpr (level == 0) {
        add<contacts_of, partner::ball, 2, double>(subjects);
        // Vectors of two components, in which a compiler may look for zeros in another way.
        add<contacts_of, partner::plane, 2, double>(subjects);
        add_batches<2, double>(subjects);
    } else {
        add_all<2, double>(subjects);
        add_all<3, double>(subjects);
        add_all<2, float>(subjects);
        add_all<3, float>(subjects);
    }
    return subjects;
}

} // namespace environments
