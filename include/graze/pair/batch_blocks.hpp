// A batch, block by block: in lanes first, then one by one the pairs that these leave open.
#pragma once

#include <graze/exact/binary.hpp>
#include <graze/machine/failure.hpp>
#include <graze/pair/batch_source.hpp>
#include <graze/pair/open_pairs.hpp>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace graze::inline v0_1::detail {

// A: many balls; B: as many, or one thing, in numbers of the same type.
template <class A, class B>
concept batch_of = requires(const source_for<B>& b) {
    requires is_binary_input<typename source_for<A>::scalar>;
    requires is_shape_in < std::remove_cvref_t<decltype(b.at(0))>, source_for<A>::dimension,
    typename source_for<A>::scalar > ;
};

// Reading a user's own types may throw.
template <class A, class B>
inline constexpr bool reads_without_throwing = !is_foreign<A> && !is_foreign<B>;

// f(); an exception about bad input is thrown with the index of the pair.
template <class Mode, class F>
void of_pair(std::size_t i, const F& f) {
#if defined(__cpp_exceptions)
    try {
        f();
    } catch (const std::domain_error& error) {
        throw std::domain_error("pair " + std::to_string(i) + ": " + error.what());
    }
#else
    static_cast<void>(i);
    f();
#endif
}

template <class Mode, class A, class B>
void require_size(const A& a, const B& b, std::size_t answers) {
    bool fits = a.size() == answers;
    if constexpr (requires { b.size(); }) {
        fits = fits && b.size() == answers;
    }
    if (!fits) {
        fail<std::invalid_argument>("batch: what is given and what is to be written differ in size");
    }
}

// The pairs of one block from `from` on, as many as whole registers hold; the rest are left open. `answers` are the
// block's. Not inlined: it has to read the numbers as memory holds them, whatever expression they came from.
template <class Question, class V, class A, class B>
[[gnu::noinline]] void ask_lanes(const A& a, const B& b, std::size_t from, std::size_t count,
                                 typename Question::answer* answers,
                                 open_pairs& left) noexcept(reads_without_throwing<A, B>) {
    constexpr std::size_t step = V::lanes;
    std::size_t i = 0;
    const auto each = [&](const auto& other) __attribute__((always_inline)) {
        for (; i + step <= count; i += step) {
            const auto found = Question::lanes(a.template lanes_from<V>(from + i), other(i));
            found.store(answers + i);
            left.add(i, found.open);
        }
    };
    if constexpr (requires { b.template lanes_from<V>(from); }) {
        each([&](std::size_t k) { return b.template lanes_from<V>(from + k); });
    } else {
        const auto& shape = in_lanes<V>(b.at(0));
        each([&](std::size_t) -> const auto& { return shape; });
    }
    left.add_rest(i, count);
}

// ask_lanes in registers of that many bytes, in a unit of graze::compiled.
template <int Bytes, class Question, class A, class B>
void ask_compiled_lanes(const A& a, const B& b, std::size_t from, std::size_t count, typename Question::answer* answers,
                        open_pairs& left) noexcept;

// Whether lanes of V can answer.
template <class Question, class V, class A, class B>
inline constexpr bool has_lanes_of = [] {
    if constexpr (requires(const B& b) { b.template lanes_from<V>(0); }) {
        return requires(const ball<A::dimension, V>& x) { Question::lanes(x, x); };
    } else {
        return requires(const ball<A::dimension, V>& x, const B& b) { Question::lanes(x, in_lanes<V>(b.at(0))); };
    }
}();
template <class Question, class A, class B>
inline constexpr bool has_lanes = [] {
    if constexpr (std::is_floating_point_v<typename A::scalar> && register_bytes > 0) {
        return has_lanes_of<Question, native_pack<typename A::scalar>, A, B>;
    } else {
        return false;
    }
}();

// In the widest registers that there are. `Wider` is part of the name of all code that depends on it.
template <int Wider, class Question, class A, class B>
void ask_widest_lanes(const A& a, const B& b, std::size_t from, std::size_t count, typename Question::answer* answers,
                      open_pairs& left) {
    if constexpr (Wider > 0) {
        if (has_compiled_registers()) {
            ask_compiled_lanes<Wider, Question>(a, b, from, count, answers, left);
            return;
        }
    }
    ask_lanes<Question, native_pack<typename A::scalar>>(a, b, from, count, answers, left);
}

template <class Question, class Mode, class A, class B>
[[gnu::noinline]] void settle(const A& a, const B& b, std::size_t from, const open_pairs& left,
                              typename Question::answer* answers) {
    left.each([&](std::size_t k) {
        const std::size_t i = from + k;
        of_pair<Mode>(i, [&] { answers[i] = Question::further(a.at(i), b.at(i)); });
    });
}

// Whether lanes cost much of a pair's decision: for walls and triangles.
template <class B>
inline constexpr bool has_dear_lanes = requires(const B& b) {
    b.at(0).edge;
};

template <class Question, class Mode, int Wider = compiled_register_bytes, class A, class B>
void decide_all(const A& a, const B& b, std::span<typename Question::answer> answers) {
    require_size<Mode>(a, b, answers.size());
    const auto one_by_one = [&](std::size_t from, std::size_t end) {
        for (std::size_t i = from; i < end; ++i) {
            of_pair<Mode>(i, [&] { answers[i] = Question::one(a.at(i), b.at(i)); });
        }
    };
    if constexpr (has_lanes<Question, A, B>) {
        lane_pause pause;
        for (std::size_t from = 0; from < answers.size(); from += block_size) {
            const std::size_t count = std::min(block_size, answers.size() - from);
            if constexpr (has_dear_lanes<B>) {
                if (!pause.is_over()) {
                    one_by_one(from, from + count);
                    continue;
                }
            }
            open_pairs left;
            ask_widest_lanes<is_foreign<A> || is_foreign<B> ? 0 : Wider, Question>(a, b, from, count,
                                                                                   answers.data() + from, left);
            pause.note(left, count);
            settle<Question, Mode>(a, b, from, left, answers.data());
        }
    } else {
        one_by_one(0, answers.size());
    }
}

} // namespace graze::inline v0_1::detail
