// Batches in registers of 32 bytes: compiled with -mavx2 -mfma, and run where the processor has both. Every function
// made here has packs of four doubles or eight floats, or the register size, in its name, so that no other unit has
// that name: else the linker might take a function from here for a machine without such registers.
#define GRAZE_DETAIL_WIDE_UNIT
#include <graze/batch.hpp>

#if defined(__AVX2__) && defined(__FMA__)

namespace graze::inline v0_1::detail {

template <class T>
using wide_pack = pack<T, 32 / static_cast<int>(sizeof(T))>;

template <int Bytes, class Question, class A, class B>
void ask_compiled_lanes(const A& a, const B& b, std::size_t from, std::size_t count, typename Question::answer* answers,
                        open_pairs& left) noexcept {
    ask_lanes<Question, wide_pack<typename A::scalar>>(a, b, from, count, answers, left);
}
template <int Bytes, class A, class B>
void time_compiled_lanes(const A& a, const B& b, std::size_t from, std::size_t count, rounding mode,
                         typename A::scalar* time, open_pairs& left) noexcept {
    time_lanes<wide_pack<typename A::scalar>>(a, b, from, count, mode, time, left);
}

// The lists of questions: about balls, in either form, and about one thing.
#define GRAZE_ASK(Q, A, B)                                                                                             \
    template void ask_compiled_lanes<32, Q, A, B>(const A&, const B&, std::size_t, std::size_t, Q::answer*,            \
                                                  open_pairs&) noexcept;
#define GRAZE_TIME(A, B)                                                                                               \
    template void time_compiled_lanes<32, A, B>(const A&, const B&, std::size_t, std::size_t, rounding, A::scalar*,    \
                                                open_pairs&) noexcept;
#define GRAZE_ASK_BALLS(A, B)                                                                                          \
    GRAZE_ASK(batch_classify, A, B)                                                                                    \
    GRAZE_ASK(batch_overlaps, A, B)                                                                                    \
    GRAZE_TIME(A, B)
#define GRAZE_ASK_ALL(N, T, A)                                                                                         \
    GRAZE_ASK_BALLS(A, columns_of##N##T)                                                                               \
    GRAZE_ASK_BALLS(A, balls_of##N##T)                                                                                 \
    GRAZE_ASK_BALLS(A, ball_of##N##T)                                                                                  \
    GRAZE_ASK(batch_classify, A, plane_of##N##T)                                                                       \
    GRAZE_ASK(batch_overlaps, A, plane_of##N##T)                                                                       \
    GRAZE_ASK(batch_classify, A, wall_of##N##T)                                                                        \
    GRAZE_ASK(batch_overlaps, A, wall_of##N##T)
#define GRAZE_SOURCES(N, T)                                                                                            \
    using columns_of##N##T = column_source<N, T>;                                                                      \
    using balls_of##N##T = array_source<N, T>;                                                                         \
    using ball_of##N##T = single_source<ball<N, T>>;                                                                   \
    using plane_of##N##T = single_source<plane<N, T>>;                                                                 \
    using wall_of##N##T = single_source<wall<N, T>>;                                                                   \
    GRAZE_ASK_ALL(N, T, columns_of##N##T)                                                                              \
    GRAZE_ASK_ALL(N, T, balls_of##N##T)

GRAZE_SOURCES(2, float)
GRAZE_SOURCES(2, double)
GRAZE_SOURCES(3, float)
GRAZE_SOURCES(3, double)

#define GRAZE_ASK_TRIANGLE(T)                                                                                          \
    using triangle_of_##T = single_source<triangle<T>>;                                                                \
    GRAZE_ASK(batch_classify, columns_of3##T, triangle_of_##T)                                                         \
    GRAZE_ASK(batch_classify, balls_of3##T, triangle_of_##T)                                                           \
    GRAZE_ASK(batch_overlaps, columns_of3##T, triangle_of_##T)                                                         \
    GRAZE_ASK(batch_overlaps, balls_of3##T, triangle_of_##T)

GRAZE_ASK_TRIANGLE(float)
GRAZE_ASK_TRIANGLE(double)

} // namespace graze::inline v0_1::detail

#endif
