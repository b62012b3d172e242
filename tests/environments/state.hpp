// The part of the floating-point environment that is state: the rounding direction and the flushing of subnormals.
#pragma once

namespace environments {

enum class rounding { nearest, upward, downward, towards_zero };

[[nodiscard]] constexpr const char* name_of(rounding r) {
    return r == rounding::nearest    ? "to nearest"
           : r == rounding::upward   ? "upward"
           : r == rounding::downward ? "downward"
                                     : "towards zero";
}

// Whether the machine has a mode in which subnormal results and operands count as zero.
[[nodiscard]] bool can_flush();

// Whether the machine can be told to round in this direction. WebAssembly rounds to nearest, always.
[[nodiscard]] constexpr bool can_round(rounding r) {
#if defined(__wasm__)
    constexpr bool others = false;
#else
    constexpr bool others = true;
#endif
    return others || r == rounding::nearest;
}

// Sets both. False if the machine then does not calculate accordingly.
[[nodiscard]] bool set_state(rounding direction, bool flush);

// Whether subnormals count as zero now.
[[nodiscard]] bool flushes();

// As the process started.
void save_state();
void restore_state();

} // namespace environments
