#include "state.hpp"

#include <cfenv>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace environments {
namespace {

#if defined(__SSE2__)
constexpr unsigned flush_bits = 0x8040; // results (FTZ) and operands (DAZ)
void set_flush(bool on) { _mm_setcsr(on ? _mm_getcsr() | flush_bits : _mm_getcsr() & ~flush_bits); }
constexpr bool has_flush = true;
#elif defined(__aarch64__)
constexpr unsigned long flush_bits = 1UL << 24; // FPCR.FZ
void set_flush(bool on) {
    unsigned long control;
    asm volatile("mrs %0, fpcr" : "=r"(control));
    control = on ? control | flush_bits : control & ~flush_bits;
    asm volatile("msr fpcr, %0" : : "r"(control));
}
constexpr bool has_flush = true;
#else
void set_flush(bool) {}
constexpr bool has_flush = false;
#endif

// Arithmetic that no compiler evaluates in advance.
double sum(double x, double y) {
    volatile double a = x;
    volatile double b = y;
    volatile double c = a + b;
    return c;
}

bool rounds(rounding direction) {
    const bool up = sum(1, 0x1p-60) > 1;
    const bool down = sum(-1, -0x1p-60) < -1;
    const bool inward = sum(1, -0x1p-60) < 1;
    switch (direction) {
    case rounding::nearest:
        return !up && !down && !inward;
    case rounding::upward:
        return up && !down && !inward;
    case rounding::downward:
        return !up && down && inward;
    case rounding::towards_zero:
        return !up && !down && inward;
    }
    return false;
}

std::fenv_t at_start;

} // namespace

bool can_flush() { return has_flush; }

bool flushes() { return sum(0x1p-1050, 0x1p-1050) == 0; }

bool set_state(rounding direction, bool flush) {
#if defined(__wasm__)
    constexpr int modes[] = {FE_TONEAREST};
#else
    constexpr int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
#endif
    if (!can_round(direction) || std::fesetround(modes[static_cast<int>(direction)]) != 0) {
        return false;
    }
    set_flush(flush);
    return rounds(direction) && flushes() == flush;
}

void save_state() { std::fegetenv(&at_start); }
void restore_state() { std::fesetenv(&at_start); }

} // namespace environments
