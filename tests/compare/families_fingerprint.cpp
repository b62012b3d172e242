// Prints each family's name and a hash of its first 1000 pairs in the plane and in space. The output must be
// families_fingerprint.txt on every platform. Needs only the standard library.
#include "../../examples/families/families.hpp"

#include <cinttypes>
#include <cstdio>

namespace {

template <int N>
class hash {
  public:
    void add(const families::pair_of_doubles<N>& p) {
        for (const auto* b : {&p.a, &p.b}) {
            add(b->position);
            add(b->velocity);
            add(b->radius);
            add(b->mass);
        }
        add(p.plane.point);
        add(p.plane.normal);
        add(p.wall.corner);
        for (const auto& e : p.wall.edge) {
            add(e);
        }
        add_bits(static_cast<std::uint64_t>(p.hardness + 1));
        add_bits(static_cast<std::uint64_t>(p.kind));
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    void add(const graze::vec<N, double>& v) {
        for (int i = 0; i < N; ++i) {
            add(v[i]);
        }
    }
    void add(const double& x) { add_bits(std::bit_cast<std::uint64_t>(x)); }
    void add_bits(std::uint64_t bits) { value_ = (value_ ^ bits ^ bits >> 32U) * 0x100000001b3U; }

    std::uint64_t value_ = 0xcbf29ce484222325U;
};

template <int N>
std::uint64_t fingerprint(const families::family& f) {
    hash<N> h;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        h.add(f.draw<N>(42, i));
    }
    return h.value();
}

} // namespace

int main() {
    for (const families::family& f : families::all_families) {
        std::printf("%-24s %016" PRIx64 " %016" PRIx64 "\n", f.name.data(), fingerprint<2>(f), fingerprint<3>(f));
    }
}
