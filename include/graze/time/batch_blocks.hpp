// The times of a block of pairs: decided in lanes, then those of the hits rounded in lanes.
#pragma once

#include <graze/machine/fused.hpp>
#include <graze/pair/batch_blocks.hpp>
#include <graze/time/lane_times.hpp>

#include <array>
#include <cstddef>
#include <type_traits>

namespace graze::inline v0_1::detail {

// The hits of a block, next to each other.
struct hit_list {
    std::array<std::size_t, block_size + 8> index;
    std::size_t size = 0;

    // Repeats the last hit up to a multiple of `step`.
    hit_list(const open_pairs& hits, std::size_t step) noexcept {
        hits.each([this](std::size_t i) { index[size++] = i; });
        for (std::size_t k = size; k % step != 0; ++k) {
            index[k] = index[size - 1];
        }
    }
};

// Rounds the times of the pairs of a block from `from` on. time[i] is near the time of pair i if that is a hit. Leaves
// open the times in doubt.
template <class V, class A, class B>
struct rounded_hits {
    const A* a;
    const B* b;
    std::size_t from;
    const open_pairs* hits;
    rounding mode;
    typename V::scalar* time;
    open_pairs* left;

    template <bool Fused>
    [[gnu::always_inline]] int operator()(std::bool_constant<Fused>) const noexcept(reads_without_throwing<A, B>) {
        constexpr std::size_t step = V::lanes;
        const hit_list list(*hits, step);
        for (std::size_t first = 0; first < list.size; first += step) {
            std::array<std::size_t, step> at{};
            for (std::size_t k = 0; k < step; ++k) {
                at[k] = from + list.index[first + k];
            }
            round<Fused>(a->template lanes_at<V>(at), b->template lanes_at<V>(at), at);
        }
        return 0;
    }

  private:
    template <bool Fused, int N>
    [[gnu::always_inline]] void round(const ball<N, V>& x, const ball<N, V>& y,
                                      const std::array<std::size_t, V::lanes>& at) const noexcept {
        if constexpr (std::is_same_v<typename V::scalar, double>) {
            const V near = V::made([&](int k) { return time[at[static_cast<std::size_t>(k)]]; });
            const auto found = impact_lanes<Fused>(x, y, near, mode);
            for (int k = 0; k < V::lanes; ++k) {
                keep(at[static_cast<std::size_t>(k)], found.value[k], (found.certain >> k & 1U) != 0);
            }
        } else {
            round_half(enclose_lanes(widened<0>(x), widened<0>(y)), at.data());
            round_half(enclose_lanes(widened<1>(x), widened<1>(y)), at.data() + V::lanes / 2);
        }
    }
    template <class W>
    [[gnu::always_inline]] void round_half(const enclosed_lanes<W>& found, const std::size_t* at) const noexcept {
        for (int k = 0; k < W::lanes; ++k) {
            const float lower = rounded_to_float(found.lower[k], mode), upper = rounded_to_float(found.upper[k], mode);
            keep(at[k], upper, (found.certain >> k & 1U) != 0 && lower == upper && lower > 0);
        }
    }
    [[gnu::always_inline]] void keep(std::size_t i, typename V::scalar value, bool certain) const noexcept {
        if (certain) {
            time[i] = value;
        } else {
            left->add(i - from, 1);
        }
    }
};

// The times of `count` pairs from `from` on, and which of them are left open.
template <class V, class A, class B>
[[gnu::noinline]] void time_lanes(const A& a, const B& b, std::size_t from, std::size_t count, rounding mode,
                                  typename V::scalar* time, open_pairs& left) noexcept(reads_without_throwing<A, B>) {
    constexpr std::size_t step = V::lanes;
    open_pairs hits;
    std::size_t i = 0;
    for (; i + step <= count; i += step) {
        const auto found = first_times(a.template lanes_from<V>(from + i), b.template lanes_from<V>(from + i));
        found.time.store(time + from + i);
        left.add(i, found.open);
        hits.add(i, found.hits);
    }
    left.add_rest(i, count);
    if (has_error_free_doubles && rounds_to_nearest()) {
        static_cast<void>(with_best_products(rounded_hits<V, A, B>{&a, &b, from, &hits, mode, time, &left}));
    } else {
        hits.each([&left](std::size_t k) { left.add(k, 1); });
    }
}

// time_lanes in registers of this many bytes, in a unit of graze::compiled.
template <int Bytes, class A, class B>
void time_compiled_lanes(const A& a, const B& b, std::size_t from, std::size_t count, rounding mode,
                         typename A::scalar* time, open_pairs& left) noexcept;

template <int Wider, class A, class B>
void time_widest_lanes(const A& a, const B& b, std::size_t from, std::size_t count, rounding mode,
                       typename A::scalar* time, open_pairs& left) noexcept(reads_without_throwing<A, B>) {
    if constexpr (Wider > 0) {
        if (has_compiled_registers()) {
            time_compiled_lanes<Wider>(a, b, from, count, mode, time, left);
            return;
        }
    }
    time_lanes<native_pack<typename A::scalar>>(a, b, from, count, mode, time, left);
}

} // namespace graze::inline v0_1::detail
