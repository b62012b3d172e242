// Writes the seeds of the fuzz target into the given folder: a file for each of two pairs of each family, in the format
// that the target reads.
#include "../soak/more_families.hpp"

#include <array>
#include <bit>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

class writer {
  public:
    void byte(int x) { bytes_.push_back(static_cast<char>(x)); }
    void number(double x) {
        byte(0);
        bytes_.append(std::bit_cast<std::array<char, sizeof x>>(x).data(), sizeof x);
    }
    template <int N>
    void vector(const graze::vec<N, double>& x) {
        for (int i = 0; i < N; ++i) {
            number(x[i]);
        }
    }
    template <int N>
    void ball(const graze::ball<N, double>& b) {
        vector(b.position);
        vector(b.velocity);
        number(b.radius);
    }
    template <int N>
    void pair(const families::pair_of_doubles<N>& p) {
        ball(p.a);
        if (p.kind == families::pair_kind::ball_ball) {
            ball(p.b);
        } else if (p.kind == families::pair_kind::ball_plane) {
            vector(p.plane.point);
            vector(p.plane.normal);
        } else {
            vector(p.wall.corner);
            for (const auto& e : p.wall.edge) {
                vector(e);
            }
        }
    }
    void to(const std::filesystem::path& file) const {
        std::ofstream(file, std::ios::binary).write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    }

  private:
    std::string bytes_;
};

template <int N>
void write(const families::family& f, const std::filesystem::path& folder) {
    const auto x = f.draw<N>(5, 2);
    const auto y = f.draw<N>(5, 3);
    writer w;
    w.byte(static_cast<int>(x.kind) + 3 * static_cast<int>(y.kind) + (N == 2 ? 0 : 9 * 3));
    w.pair(x);
    w.pair(y);
    w.to(folder / (std::string(f.name) + (N == 2 ? "_in_the_plane" : "_in_space")));
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: graze-fuzz-seeds FOLDER\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    const auto both = [&](const families::family& f) {
        write<2>(f, folder);
        write<3>(f, folder);
    };
    for (const auto& f : families::all_families) {
        both(f);
    }
    for (const auto& f : families::more_families) {
        both(f);
    }
}
