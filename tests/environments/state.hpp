// The part of the floating-point environment that is state: rounding direction and flushing of subnormals.
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

// Whether the machine can round in this direction. WebAssembly always rounds to nearest.
[[nodiscard]] constexpr bool can_round(rounding r) {
#if defined(__wasm__)
    constexpr bool others = false;
#else
    constexpr bool others = true;
#endif
    return others || r == rounding::nearest;
}

// Sets both. False if the machine does not compute accordingly afterwards.
[[nodiscard]] bool set_state(rounding direction, bool flush);

// Whether subnormals count as zero now.
[[nodiscard]] bool flushes();

// As the process started.
void save_state();
void restore_state();

} // namespace environments
