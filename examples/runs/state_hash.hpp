// One number for the states of all balls.
#pragma once

#include <graze/shape/flight.hpp>

#include <bit>
#include <cstdint>
#include <vector>

// FNV-1a in steps of 64 bits, over the bits of positions, velocities and times.
template <int N>
[[nodiscard]] std::uint64_t hash_of(const std::vector<graze::flight<N>>& flights) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    const auto add = [&](double x) { hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3U; };
    for (const auto& f : flights) {
        for (int i = 0; i < N; ++i) {
            add(f.state.position[i]);
            add(f.state.velocity[i]);
        }
        add(f.since);
    }
    return hash;
}
