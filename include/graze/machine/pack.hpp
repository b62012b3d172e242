// As many numbers as a register holds, computed side by side: the numbers of a batch.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace graze::inline v0_1::detail {

// The bytes of the registers that a compiler may use for this unit; 0 where there are none, or GNU's vectors are not
// known.
#if defined(__GNUC__) && defined(__AVX2__) && defined(__FMA__)
inline constexpr int register_bytes = 32;
#elif defined(__GNUC__) && (defined(__SSE2__) || !defined(__i386__))
inline constexpr int register_bytes = 16;
#else
inline constexpr int register_bytes = 0;
#endif

// The bytes of the registers for which graze::compiled has units of its own, if it is linked. 0 if there are none, or
// none wider than this unit's.
#if defined(GRAZE_COMPILED) && defined(__GNUC__) && defined(__x86_64__)
inline constexpr int compiled_register_bytes = register_bytes < 32 ? 32 : 0;
#else
inline constexpr int compiled_register_bytes = 0;
#endif
// Whether this machine has those registers.
[[nodiscard]] inline bool has_compiled_registers() noexcept {
#if defined(__GNUC__) && defined(__x86_64__)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
}

template <class T, int Lanes>
struct vector_of {
#if defined(__GNUC__)
    typedef T type __attribute__((vector_size(Lanes * sizeof(T))));
#endif
};

// A condition for each lane: all bits of the lane are set where it holds, or none.
template <class T, int Lanes>
struct pack_mask {
    using integer = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    using vector = typename vector_of<integer, Lanes>::type;
    vector value;

    // The same bits in every lane.
    [[nodiscard, gnu::always_inline]] static pack_mask filled(integer bits) noexcept { return {vector{} + bits}; }

    [[nodiscard, gnu::always_inline]] friend inline pack_mask operator&(pack_mask x, pack_mask y) noexcept {
        return {x.value & y.value};
    }
    [[nodiscard, gnu::always_inline]] friend inline pack_mask operator|(pack_mask x, pack_mask y) noexcept {
        return {x.value | y.value};
    }
    [[nodiscard, gnu::always_inline]] friend inline pack_mask operator^(pack_mask x, pack_mask y) noexcept {
        return {x.value ^ y.value};
    }
    [[nodiscard, gnu::always_inline]] friend inline pack_mask operator~(pack_mask x) noexcept { return {~x.value}; }
};

// One number per lane, with the operators of a number. How many lanes is part of the type, and so of the name of
// everything that is made for it: units that are compiled for other registers share none of it.
template <class T, int Lanes>
struct pack {
    using scalar = T;
    using mask = pack_mask<T, Lanes>;
    using vector = typename vector_of<T, Lanes>::type;
    static constexpr int lanes = Lanes;
    vector value;

    pack() = default;
    [[gnu::always_inline]] explicit pack(T x) noexcept : value(made([x](int) { return x; }).value) {}
    [[nodiscard, gnu::always_inline]] static pack of(vector x) noexcept {
        pack r;
        r.value = x;
        return r;
    }
    [[nodiscard, gnu::always_inline]] static pack of(const mask& bits) noexcept {
        return of(std::bit_cast<vector>(bits.value));
    }
    [[nodiscard, gnu::always_inline]] mask bits() const noexcept {
        return {std::bit_cast<typename mask::vector>(value)};
    }
    // f(k) in lane k.
    template <class F>
    [[nodiscard, gnu::always_inline]] static pack made(const F& f) noexcept {
        if constexpr (Lanes == 2) {
            return of(vector{f(0), f(1)});
        } else if constexpr (Lanes == 4) {
            return of(vector{f(0), f(1), f(2), f(3)});
        } else {
            static_assert(Lanes == 8);
            return of(vector{f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)});
        }
    }
    // The numbers from x on.
    [[nodiscard, gnu::always_inline]] static pack load(const T* x) noexcept {
        pack r;
        std::memcpy(&r.value, x, sizeof(vector));
        return r;
    }
    [[gnu::always_inline]] void store(T* x) const noexcept { std::memcpy(x, &value, sizeof(vector)); }
    // Whole numbers, as integers of 32 bits from x on.
    template <class X>
    [[gnu::always_inline]] void store_integers(X* x) const noexcept {
        static_assert(sizeof(X) == sizeof(std::int32_t));
        const auto integers = __builtin_convertvector(value, typename vector_of<std::int32_t, Lanes>::type);
        std::memcpy(x, &integers, sizeof(integers));
    }
    [[nodiscard, gnu::always_inline]] T operator[](int lane) const noexcept { return value[lane]; }

    [[nodiscard, gnu::always_inline]] friend inline pack operator-(pack x) noexcept { return of(-x.value); }
    [[nodiscard, gnu::always_inline]] friend inline pack operator+(pack x, pack y) noexcept {
        return of(x.value + y.value);
    }
    [[nodiscard, gnu::always_inline]] friend inline pack operator-(pack x, pack y) noexcept {
        return of(x.value - y.value);
    }
    [[nodiscard, gnu::always_inline]] friend inline pack operator*(pack x, pack y) noexcept {
        return of(x.value * y.value);
    }
    [[nodiscard, gnu::always_inline]] friend inline pack operator/(pack x, pack y) noexcept {
        return of(x.value / y.value);
    }
    [[nodiscard, gnu::always_inline]] friend inline pack operator*(T x, pack y) noexcept { return pack(x) * y; }
    [[nodiscard, gnu::always_inline]] friend inline pack operator/(T x, pack y) noexcept { return pack(x) / y; }
    [[nodiscard, gnu::always_inline]] friend inline pack operator+(T x, pack y) noexcept { return pack(x) + y; }
    [[nodiscard, gnu::always_inline]] friend inline mask operator<(pack x, pack y) noexcept {
#if defined(__SSE2__) && !defined(__clang__) // g++ 12 takes what `&` joins out of such registers, and puts it back
        if constexpr (std::is_same_v<T, double> && Lanes == 2) {
            return {std::bit_cast<typename mask::vector>(__builtin_ia32_cmpltpd(x.value, y.value))};
        } else if constexpr (std::is_same_v<T, float> && Lanes == 4) {
            return {std::bit_cast<typename mask::vector>(__builtin_ia32_cmpltps(x.value, y.value))};
        } else
#endif
            return {x.value < y.value};
    }
    [[nodiscard, gnu::always_inline]] friend inline mask operator<(pack x, T y) noexcept { return x < pack(y); }
    [[nodiscard, gnu::always_inline]] friend inline mask operator>(pack x, pack y) noexcept { return y < x; }
};

// As many lanes as a register has.
template <class T>
using native_pack = pack<T, register_bytes / static_cast<int>(sizeof(T))>;

// x where the condition holds, else y.
template <class T, int Lanes>
[[nodiscard, gnu::always_inline]] inline pack<T, Lanes> chosen(pack_mask<T, Lanes> condition, pack<T, Lanes> x,
                                                               pack<T, Lanes> y) noexcept {
    return pack<T, Lanes>::of((condition & x.bits()) | (~condition & y.bits()));
}

// |x|, by its bits.
template <class T, int Lanes>
[[nodiscard, gnu::always_inline]] inline pack<T, Lanes> absolute(const pack<T, Lanes>& x) noexcept {
    return pack<T, Lanes>::of(~pack<T, Lanes>(T(-0.0)).bits() & x.bits());
}

// The sign bit of lane k in bit k.
template <class T, int Lanes>
[[nodiscard, gnu::always_inline]] inline unsigned sign_bits(const pack<T, Lanes>& x) noexcept {
#if defined(__SSE2__)
    if constexpr (std::is_same_v<T, double> && Lanes == 2) {
        return static_cast<unsigned>(__builtin_ia32_movmskpd(x.value));
    } else if constexpr (std::is_same_v<T, float> && Lanes == 4) {
        return static_cast<unsigned>(__builtin_ia32_movmskps(x.value));
    } else
#endif
#if defined(__AVX__)
        if constexpr (std::is_same_v<T, double> && Lanes == 4) {
        return static_cast<unsigned>(__builtin_ia32_movmskpd256(x.value));
    } else if constexpr (std::is_same_v<T, float> && Lanes == 8) {
        return static_cast<unsigned>(__builtin_ia32_movmskps256(x.value));
    } else
#endif
    {
        const auto integers = x.bits().value;
        unsigned bits = 0;
        for (int k = 0; k < Lanes; ++k) {
            bits |= (integers[k] < 0 ? 1U : 0U) << k;
        }
        return bits;
    }
}

// The bits of a mask: bit k says whether it holds in lane k; and those of a mask that holds in every lane.
template <class T, int Lanes>
[[nodiscard, gnu::always_inline]] inline unsigned bits_of(const pack_mask<T, Lanes>& x) noexcept {
    return sign_bits(pack<T, Lanes>::of(x));
}
template <class V>
inline constexpr unsigned all_lanes = (1U << V::lanes) - 1;

} // namespace graze::inline v0_1::detail
