// The questions to the predicates in one environment: functions from a row of bits to an answer. Needs only the
// standard library and graze, so that it runs where there is nothing else.
#pragma once

#include "row.hpp"

#include <graze/pair/stage.hpp>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace environments {

// The number of instantiations: 0 takes seconds to compile, 1 most of the predicates, 2 all of them.
#ifndef GRAZE_ENVIRONMENT_LEVEL
#define GRAZE_ENVIRONMENT_LEVEL 0
#endif
inline constexpr int level = GRAZE_ENVIRONMENT_LEVEL;

// An answer in the file's form, and the stages that decided it.
struct reply {
    int answer = 0;
    int filter = 0, exact = 0;
};

struct subject {
    std::string name;
    std::size_t numbers; // in a question
    reply (*ask)(const std::uint64_t* bits);
};

// Numbers from their bits, without arithmetic.
template <class T, std::size_t Count>
[[nodiscard]] std::array<T, Count> numbers_from(const std::uint64_t* bits) {
    std::array<T, Count> numbers;
    for (std::size_t i = 0; i < Count; ++i) {
        if constexpr (sizeof(T) == 4) {
            numbers[i] = std::bit_cast<T>(static_cast<std::uint32_t>(bits[i]));
        } else {
            numbers[i] = std::bit_cast<T>(bits[i]);
        }
    }
    return numbers;
}

// Counts how often each stage decided.
struct stage_counter {
    reply& counts;
    void operator()(graze::stage s) const { ++(s == graze::stage::filter ? counts.filter : counts.exact); }
};

template <int N, class T>
[[nodiscard]] std::string subject_name(const std::string& question, const std::string& about) {
    return question + ' ' + about + ' ' + type_name<T> + ' ' + static_cast<char>('0' + N);
}

void add_balls_and_planes(std::vector<subject>& subjects);
void add_walls(std::vector<subject>& subjects);
void add_times(std::vector<subject>& subjects);

} // namespace environments
