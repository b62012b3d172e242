// Numbers that lie side by side, row by row, brought into lanes: a row a lane.
#pragma once

#include <graze/machine/pack.hpp>

#include <array>
#include <cstddef>

namespace graze::inline v0_1::detail {

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define GRAZE_DETAIL_SHUFFLES 1
#endif
#endif

// The numbers that 16 bytes hold, from number `first` on of each row: number first + j of row k is lane k of
// columns[first + j]. row(k) is a pointer.
template <class T, int Lanes, class Row>
[[gnu::always_inline]] inline void transpose_chunk(const Row& row_at, int first, pack<T, Lanes>* columns) noexcept {
    constexpr int chunk = 16 / static_cast<int>(sizeof(T));
    using lane = pack<T, Lanes>;
#ifdef GRAZE_DETAIL_SHUFFLES
    using chunk_pack = pack<T, chunk>;
    // Rows k and k + chunk side by side, where a register has room for both.
    const auto row = [&](int k) __attribute__((always_inline)) {
        const auto low = chunk_pack::load(row_at(k) + first).value;
        if constexpr (Lanes == chunk) {
            return low;
        } else if constexpr (chunk == 2) {
            return __builtin_shufflevector(low, chunk_pack::load(row_at(k + 2) + first).value, 0, 1, 2, 3);
        } else {
            return __builtin_shufflevector(low, chunk_pack::load(row_at(k + 4) + first).value, 0, 1, 2, 3, 4, 5, 6, 7);
        }
    };
    if constexpr (Lanes == 2 && chunk == 2) {
        const auto x = row(0), y = row(1);
        columns[first] = lane::of(__builtin_shufflevector(x, y, 0, 2));
        columns[first + 1] = lane::of(__builtin_shufflevector(x, y, 1, 3));
    } else if constexpr (Lanes == 4 && chunk == 2) {
        const auto x = row(0), y = row(1);
        columns[first] = lane::of(__builtin_shufflevector(x, y, 0, 4, 2, 6));
        columns[first + 1] = lane::of(__builtin_shufflevector(x, y, 1, 5, 3, 7));
    } else if constexpr (Lanes == 4 && chunk == 4) {
        const auto x = row(0), y = row(1), z = row(2), w = row(3);
        const auto xy01 = __builtin_shufflevector(x, y, 0, 4, 1, 5), xy23 = __builtin_shufflevector(x, y, 2, 6, 3, 7);
        const auto zw01 = __builtin_shufflevector(z, w, 0, 4, 1, 5), zw23 = __builtin_shufflevector(z, w, 2, 6, 3, 7);
        columns[first] = lane::of(__builtin_shufflevector(xy01, zw01, 0, 1, 4, 5));
        columns[first + 1] = lane::of(__builtin_shufflevector(xy01, zw01, 2, 3, 6, 7));
        columns[first + 2] = lane::of(__builtin_shufflevector(xy23, zw23, 0, 1, 4, 5));
        columns[first + 3] = lane::of(__builtin_shufflevector(xy23, zw23, 2, 3, 6, 7));
    } else if constexpr (Lanes == 8 && chunk == 4) {
        const auto x = row(0), y = row(1), z = row(2), w = row(3);
        const auto xy01 = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13);
        const auto xy23 = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15);
        const auto zw01 = __builtin_shufflevector(z, w, 0, 8, 1, 9, 4, 12, 5, 13);
        const auto zw23 = __builtin_shufflevector(z, w, 2, 10, 3, 11, 6, 14, 7, 15);
        columns[first] = lane::of(__builtin_shufflevector(xy01, zw01, 0, 1, 8, 9, 4, 5, 12, 13));
        columns[first + 1] = lane::of(__builtin_shufflevector(xy01, zw01, 2, 3, 10, 11, 6, 7, 14, 15));
        columns[first + 2] = lane::of(__builtin_shufflevector(xy23, zw23, 0, 1, 8, 9, 4, 5, 12, 13));
        columns[first + 3] = lane::of(__builtin_shufflevector(xy23, zw23, 2, 3, 10, 11, 6, 7, 14, 15));
    } else
#endif
    {
        for (int j = first; j < first + chunk; ++j) {
            columns[j] = lane::made([&](int k) __attribute__((always_inline)) { return row_at(k)[j]; });
        }
    }
}

#undef GRAZE_DETAIL_SHUFFLES

// The first Count numbers of each row, 4 to 8. The rest at the end of a row is read together with the numbers before.
template <int Count, class T, int Lanes, class Row>
[[nodiscard, gnu::always_inline]] inline std::array<pack<T, Lanes>, Count> transposed(const Row& row) noexcept {
    constexpr int chunk = 16 / static_cast<int>(sizeof(T));
    static_assert(Count >= chunk && Count <= 8);
    std::array<pack<T, Lanes>, Count> columns;
    if constexpr (Count % chunk != 0) {
        transpose_chunk<T, Lanes>(row, Count - chunk, columns.data());
    }
    const auto read = [&](auto first) __attribute__((always_inline)) {
        if constexpr (first + chunk <= Count) {
            transpose_chunk<T, Lanes>(row, first, columns.data());
        }
    };
    read(std::integral_constant<int, 0>{});
    read(std::integral_constant<int, chunk>{});
    read(std::integral_constant<int, 2 * chunk>{});
    read(std::integral_constant<int, 3 * chunk>{});
    return columns;
}

} // namespace graze::inline v0_1::detail
