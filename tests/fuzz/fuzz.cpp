// Random bytes as input to every predicate. The answers for good input and the messages for bad input are compared with
// the oracle.
#include "../predicate/faults.hpp"

#include "../oracle/encounter.hpp"

#include <graze/predicate/overlaps_of_shapes.hpp>
#include <graze/time/time_of_shapes.hpp>
#include <graze/time/time_of_walls.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace {

void require(bool right, const char* what) {
    if (!right) {
        std::fprintf(stderr, "graze-fuzz: wrong: %s\n", what);
        std::abort();
    }
}

// Makes numbers from bytes, and zeros when there are none left.
class reader {
  public:
    reader(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    std::uint8_t byte() {
        std::uint8_t x = 0;
        take(&x, 1);
        return x;
    }

    // A first byte says how: the bits as they are, or a small whole number (times a power of two), so that ties and
    // zeros occur.
    template <class T>
    T number() {
        const std::uint8_t kind = byte();
        if (kind < 96) {
            T x{};
            take(&x, sizeof x);
            return x;
        }
        const int whole = kind % 16 - 8;
        if constexpr (std::is_floating_point_v<T>) {
            return kind < 224 ? static_cast<T>(whole) : std::ldexp(static_cast<T>(whole), byte() * 16 - 2048);
        } else {
            return static_cast<T>(whole);
        }
    }
    template <int N, class T>
    graze::vec<N, T> vector() {
        graze::vec<N, T> x{};
        for (int i = 0; i < N; ++i) {
            x[i] = number<T>();
        }
        return x;
    }
    template <int N, class T>
    graze::ball<N, T> ball() {
        const auto position = vector<N, T>();
        const auto velocity = vector<N, T>();
        return {position, velocity, number<T>()};
    }

  private:
    void take(void* to, std::size_t count) {
        count = count < size_ ? count : size_;
        std::memcpy(to, data_, count);
        data_ += count;
        size_ -= count;
    }

    const std::uint8_t* data_;
    std::size_t size_;
};

template <int N, class T>
struct event {
    graze::impact_time<N, T> time;
    oracle::surd truth;
};

int sign_of(std::partial_ordering o) { return o < 0 ? -1 : o > 0 ? 1 : o == 0 ? 0 : 2; }

// Asks every predicate about a pair. Returns its event, if there is one.
template <int N, class T, class Shape>
std::optional<event<N, T>> decide(const graze::ball<N, T>& a, const Shape& b) {
    const faults::list bad = faults::of(a, b);
    if (!bad.empty()) {
        require(faults::told(bad, [&] { (void)graze::classify(a, b); }), "classify of bad input");
        require(faults::told(bad, [&] { (void)graze::overlaps(a, b); }), "overlaps of bad input");
        require(faults::told(bad, [&] { (void)graze::time_of_impact(a, b); }), "time_of_impact of bad input");
        return std::nullopt;
    }
    const oracle::answer truth = oracle::meet(a, b);
    require(static_cast<int>(graze::classify(a, b)) == static_cast<int>(truth.what), "classify");
    require(graze::overlaps(a, b) == truth.overlaps, "overlaps");
    const auto time = graze::time_of_impact(a, b);
    require(time.has_value() == truth.time.has_value(), "time_of_impact");
    return time ? std::optional(event<N, T>{*time, *truth.time}) : std::nullopt;
}

template <int N, class T>
std::optional<event<N, T>> any_event(reader& r, int kind) {
    const auto a = r.ball<N, T>();
    if (kind == 0) {
        return decide(a, r.ball<N, T>());
    }
    if (kind == 1) {
        const auto point = r.vector<N, T>();
        return decide(a, graze::plane<N, T>{point, r.vector<N, T>()});
    }
    graze::wall<N, T> w{r.vector<N, T>(), {}};
    for (auto& e : w.edge) {
        e = r.vector<N, T>();
    }
    return decide(a, w);
}

// Two pairs, the order of their times, and a number to compare with.
template <int N, class T>
void try_all(reader& r, int kinds) {
    const auto x = any_event<N, T>(r, kinds % 3);
    const auto y = any_event<N, T>(r, kinds / 3);
    if (x && y) {
        const int truth = oracle::compare(x->truth, y->truth);
        require(sign_of(x->time <=> y->time) == truth, "the order of two times");
        require(sign_of(y->time <=> x->time) == -truth, "the order of two times, exchanged");
        require((x->time == y->time) == (truth == 0), "the equality of two times");
    }
    if (x) {
        const T m = r.number<T>();
        const int truth = !faults::is_finite(m) ? (m < 0   ? 1
                                                   : m > 0 ? -1
                                                           : 2)
                                                : oracle::compare(x->truth, mpq_class(oracle::input(m)));
        require(sign_of(x->time <=> m) == truth, "a time against a number");
        if constexpr (std::is_floating_point_v<T>) {
            const auto nearest = static_cast<T>(oracle::nearest_double(x->truth));
            if (std::isfinite(nearest)) {
                require(sign_of(x->time <=> nearest) == oracle::compare(x->truth, mpq_class(nearest)),
                        "a time against its nearest number");
            }
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    reader r(data, size);
    const int how = r.byte();
    const int kinds = how % 9;
    switch (how / 9 % 5) {
    case 0:
        try_all<2, double>(r, kinds);
        break;
    case 1:
        try_all<2, float>(r, kinds);
        break;
    case 2:
        try_all<2, std::int64_t>(r, kinds);
        break;
    default:
        try_all<3, double>(r, kinds);
    }
    return 0;
}
