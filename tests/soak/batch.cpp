// graze-batch-soak [COUNT [SEED]]: COUNT pairs of balls in batches, a quarter each in 2D and 3D, float and double, and
// as many balls against planes and walls. Every answer is compared with the scalar function's. Exit code 1 if one
// differs.
#include <families/random.hpp>

#include <graze/batch.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <span>
#include <vector>

namespace {

constexpr std::size_t size = 1'000; // pairs in a batch: whole blocks and a rest

template <class T>
class numbers {
  public:
    explicit numbers(std::uint64_t seed) : random_(seed) {}

    // In (-1, 1), with all bits. In a batch on a grid a multiple of an eighth; one in eight of these is off by a unit.
    [[nodiscard]] T number(bool grid) {
        if (!grid) {
            return static_cast<T>(random_.signed_bits(53)) * T(0x1p-53);
        }
        const T x = static_cast<T>(random_.in(-8, 8)) / T(8);
        return random_.one_in(8) ? std::nextafter(x, T(1)) : x;
    }
    template <int N>
    [[nodiscard]] graze::vec<N, T> vector(bool grid, T scale) {
        return graze::make_vec<N>([&](int) { return scale * number(grid); });
    }
    // Mostly of one size; of one in sixteen batches of any.
    [[nodiscard]] T unit() {
        const int most = random_.one_in(16) ? (sizeof(T) == 4 ? 60 : 500) : 1;
        return std::ldexp(T(1), static_cast<int>(random_.in(-most, most)));
    }
    [[nodiscard]] bool one_in(std::uint64_t n) { return random_.one_in(n); }

  private:
    families::random random_;
};

template <int N, class T>
std::vector<graze::ball<N, T>> draw(numbers<T>& from, bool grid, T length, T velocity) {
    std::vector<graze::ball<N, T>> balls(size);
    for (auto& b : balls) {
        b.position = from.template vector<N>(grid, length);
        b.velocity = from.template vector<N>(grid, velocity);
        b.radius = std::abs(from.number(grid)) * length / (grid ? T(1) : T(4));
    }
    return balls;
}

struct tally {
    std::uint64_t asked = 0, wrong = 0, met = 0;
};

template <class T>
bool same(const T& x, const T& y) {
    if constexpr (std::is_floating_point_v<T>) {
        using bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
        return std::bit_cast<bits>(x) == std::bit_cast<bits>(y);
    } else {
        return x == y;
    }
}

template <int N, class T, class B, class At>
void compare(const std::vector<graze::ball<N, T>>& a, const B& b, At at, tally& t) {
    std::vector<graze::encounter> what(size);
    std::vector<T> time(size);
    bool inside[size];
    graze::batch::classify(a, b, what);
    graze::batch::overlaps(a, b, inside);
    graze::batch::time_of_impact(a, b, time);
    for (std::size_t i = 0; i < size; ++i) {
        const auto impact = graze::time_of_impact(a[i], at(i));
        const T expected = impact ? static_cast<T>(*impact) : std::numeric_limits<T>::infinity();
        t.asked += 1;
        t.met += impact ? 1 : 0;
        t.wrong += what[i] == graze::classify(a[i], at(i)) && inside[i] == graze::overlaps(a[i], at(i)) &&
                           same(time[i], expected)
                       ? 0
                       : 1;
    }
}

template <int N, class T>
void run(std::uint64_t count, std::uint64_t seed, const char* name) {
    numbers<T> from(seed);
    tally balls, shapes;
    for (std::uint64_t done = 0; done < count; done += size) {
        const bool grid = from.one_in(16);
        const T length = from.unit(), velocity = from.unit();
        const auto a = draw<N, T>(from, grid, length, velocity), b = draw<N, T>(from, grid, length, velocity);
        compare(
            a, b, [&](std::size_t i) -> const auto& { return b[i]; }, balls);
        if (done % (64 * size) == 0) { // now and then against a plane and a wall, which take longer
            const graze::plane<N, T> p{from.template vector<N>(grid, length), from.template vector<N>(false, T(1))};
            graze::wall<N, T> w{from.template vector<N>(grid, length), {}};
            for (auto& e : w.edge) {
                e = from.template vector<N>(false, length);
            }
            compare(
                a, p, [&](std::size_t) -> const auto& { return p; }, shapes);
            compare(
                a, w, [&](std::size_t) -> const auto& { return w; }, shapes);
        }
    }
    std::printf("%s: %ju pairs, %ju meet, %ju differ; of balls and planes or walls %ju, %ju, %ju\n", name,
                std::uintmax_t{balls.asked}, std::uintmax_t{balls.met}, std::uintmax_t{balls.wrong},
                std::uintmax_t{shapes.asked}, std::uintmax_t{shapes.met}, std::uintmax_t{shapes.wrong});
    if (balls.wrong + shapes.wrong != 0 || balls.met == 0) {
        std::exit(1);
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100'000'000;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    run<2, float>(count / 4, seed, "2D, float");
    run<3, float>(count / 4, seed + 1, "3D, float");
    run<2, double>(count / 4, seed + 2, "2D, double");
    run<3, double>(count / 4, seed + 3, "3D, double");
    return 0;
}
