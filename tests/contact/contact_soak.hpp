// Contacts of every family, each component judged by the oracle.
#pragma once

#include "../soak/soak.hpp"

namespace contact_soak {

// What was seen of one family in one dimension and one type.
struct tally {
    std::uint64_t pairs = 0, contacts = 0, components = 0, ties = 0, exact = 0, wrong = 0;

    tally& operator+=(const tally& other) {
        pairs += other.pairs;
        contacts += other.contacts;
        components += other.components;
        ties += other.ties;
        exact += other.exact;
        wrong += other.wrong;
        return *this;
    }
};

// Draws pairs of soak::families_drawn[family] from number `first` on until `count` of them collide or 16 count have
// been drawn.
template <int N, class T>
tally run(std::size_t family, std::uint64_t seed, std::uint64_t first, std::uint64_t count,
          std::vector<std::string>& complaints);

extern template tally run<2, double>(std::size_t, std::uint64_t, std::uint64_t, std::uint64_t,
                                     std::vector<std::string>&);
extern template tally run<3, double>(std::size_t, std::uint64_t, std::uint64_t, std::uint64_t,
                                     std::vector<std::string>&);
extern template tally run<2, float>(std::size_t, std::uint64_t, std::uint64_t, std::uint64_t,
                                    std::vector<std::string>&);
extern template tally run<3, float>(std::size_t, std::uint64_t, std::uint64_t, std::uint64_t,
                                    std::vector<std::string>&);

} // namespace contact_soak
