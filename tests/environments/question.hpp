// One question with its answer by the oracle, as a line of the file.
#pragma once

#include "../oracle/encounter.hpp"
#include "draw.hpp"

#include <bit>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace environments {

// The lines of each subject, for example "decide ball-wall double 3".
using questions = std::map<std::string, std::vector<std::string>>;

template <class T>
using bits_of_type = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

template <class T>
[[nodiscard]] std::string hexadecimal(const std::vector<T>& numbers) {
    std::string text;
    for (const T& x : numbers) {
        text += ' ';
        const auto bits = std::bit_cast<bits_of_type<T>>(x);
        for (int digit = 2 * static_cast<int>(sizeof(T)); digit-- > 0;) {
            text += "0123456789abcdef"[bits >> 4 * digit & 0xf];
        }
    }
    return text;
}

template <int N, class T>
void ask(questions& q, const char* question, const std::string& about, std::string_view family, int answer,
         const std::vector<T>& numbers) {
    const std::string subject =
        std::string(question) + ' ' + about + ' ' + type_name<T> + ' ' + static_cast<char>('0' + N);
    q[subject].push_back(subject + ' ' + std::string(family) + ' ' + std::to_string(answer) + hexadecimal(numbers));
}

// The numbers in T, if each fits.
template <class T>
[[nodiscard]] std::optional<std::vector<T>> in_type(const row& x) {
    std::vector<T> numbers;
    for (const number& y : x.numbers) {
        const std::optional<T> value = as<T>(y);
        if (!value) {
            return std::nullopt;
        }
        numbers.push_back(*value);
    }
    return numbers;
}

template <class T>
[[nodiscard]] mpq_class rational_of(T x) {
    return std::is_integral_v<T> ? mpq_class(static_cast<long>(x)) : mpq_class(static_cast<double>(x));
}

// Whether the predicates accept the pair: no negative radius, no zero normal, edges that span a wall.
template <int N, class T>
[[nodiscard]] bool is_valid(partner p, const std::vector<T>& numbers) {
    std::vector<mpq_class> x;
    for (const T& y : numbers) {
        x.push_back(rational_of(y));
    }
    constexpr std::size_t n = N;
    const auto is_zero = [&](std::size_t from) {
        return std::all_of(x.begin() + static_cast<std::ptrdiff_t>(from),
                           x.begin() + static_cast<std::ptrdiff_t>(from + n), [](const auto& y) { return y == 0; });
    };
    if (x[2 * n] < 0) {
        return false;
    }
    if (p == partner::ball) {
        return x.back() >= 0;
    }
    if (p == partner::plane || n == 2) {
        return !is_zero(3 * n + 1);
    }
    const mpq_class* e = &x[3 * n + 1];
    const mpq_class* f = e + n;
    return e[1] * f[2] != e[2] * f[1] || e[2] * f[0] != e[0] * f[2] || e[0] * f[1] != e[1] * f[0];
}

template <int N, class T>
[[nodiscard]] oracle::answer answer_of(partner p, const std::vector<T>& numbers) {
    const auto meet = [](const auto& a, const auto& b) { return oracle::meet(a, b); };
    return p == partner::ball    ? with_shapes<partner::ball, N>(numbers.data(), meet)
           : p == partner::plane ? with_shapes<partner::plane, N>(numbers.data(), meet)
                                 : with_shapes<partner::wall, N>(numbers.data(), meet);
}

// A valid pair and its encounter.
template <class T>
struct case_of {
    partner with;
    std::string_view family;
    std::vector<T> numbers;
    oracle::answer truth;
};

template <int N, class T>
[[nodiscard]] std::optional<case_of<T>> make_case(const row& x, std::string_view family) {
    const auto numbers = in_type<T>(x);
    if (!numbers || !is_valid<N>(x.with, *numbers)) {
        return std::nullopt;
    }
    return case_of<T>{x.with, family, *numbers, answer_of<N>(x.with, *numbers)};
}

// Its encounter, and whether it overlaps: 2 encounter + overlaps.
template <int N, class T>
void ask_decision(questions& q, const case_of<T>& c) {
    ask<N>(q, "decide", name_of(c.with), c.family, 2 * static_cast<int>(c.truth.what) + (c.truth.overlaps ? 1 : 0),
           c.numbers);
}

// The sign of the difference of two collisions' times.
template <int N, class T>
void ask_order(questions& q, const case_of<T>& x, const case_of<T>& y) {
    std::vector<T> numbers = x.numbers;
    numbers.insert(numbers.end(), y.numbers.begin(), y.numbers.end());
    ask<N>(q, "order", std::string(name_of(x.with)) + '/' + name_of(y.with), y.family,
           oracle::compare(*x.truth.time, *y.truth.time), numbers);
}

// The sign of a collision's time less a time in T.
template <int N, class T>
void ask_against(questions& q, const case_of<T>& x, T time) {
    std::vector<T> numbers = x.numbers;
    numbers.push_back(time);
    ask<N>(q, "against", name_of(x.with), x.family, oracle::compare(*x.truth.time, rational_of(time)), numbers);
}

} // namespace environments
