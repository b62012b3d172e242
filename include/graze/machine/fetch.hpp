// What will soon be read is fetched from memory while something else is done.
#pragma once

#include <cstddef>

namespace graze::inline v0_1::detail {

// A compiler may drop a call of a function that does nothing else; the empty statement keeps it.
[[gnu::always_inline]] inline void fetch_line(const void* x) noexcept {
#if defined(__GNUC__)
    __builtin_prefetch(x);
    __asm__ volatile("" : : "r"(x));
#else
    (void)x;
#endif
}

// Every line of the cache in which a part of x is.
template <class T>
[[gnu::always_inline]] inline void fetch(const T& x) noexcept {
    const auto* const first = reinterpret_cast<const char*>(&x);
    for (std::size_t at = 0; at < sizeof(T); at += 64) {
        fetch_line(first + at);
    }
    if constexpr (sizeof(T) % 64 != 0 && alignof(T) < 64 && sizeof(T) > 8) {
        fetch_line(first + sizeof(T) - 1);
    }
}

} // namespace graze::inline v0_1::detail
