// RapidCheck's properties behind a few functions, which are compiled once. RapidCheck is templates: of a test with many
// properties they were more than half of the functions, and took most of the time to compile.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

namespace property {

// What is to be tried: a call without arguments and without result, which draws its input by the functions below.
class trial {
  public:
    template <class F>
    requires std::is_void_v<std::invoke_result_t<const F&>> trial(const F& f)
    noexcept : object(&f), call([](const void* o) { (*static_cast<const F*>(o))(); }) {}
    void operator()() const { call(object); }

  private:
    const void* object;
    void (*call)(const void*);
};

// Whether the trial passes for all input drawn; if not, the least input found is told. How often it is tried, and from
// which seed, RC_PARAMS in the environment says.
[[nodiscard]] bool check(const std::string& name, const trial& t);
[[nodiscard]] inline bool check(const trial& t) { return check("", t); }

// A number of low <= x < high. Early trials draw small ones.
[[nodiscard]] std::int64_t signed_in_range(std::int64_t low, std::int64_t high);
[[nodiscard]] std::uint64_t unsigned_in_range(std::uint64_t low, std::uint64_t high);
template <std::integral T>
[[nodiscard]] T in_range(T low, T high) {
    if constexpr (std::is_signed_v<T>) {
        return static_cast<T>(signed_in_range(low, high));
    } else {
        return static_cast<T>(unsigned_in_range(low, high));
    }
}

// Any number, all equally likely, from the first trial on.
[[nodiscard]] std::size_t index_below(std::size_t count);
template <class T, class... More>
requires std::same_as<std::common_type_t<T, More...>, T>
[[nodiscard]] T one_of(T first, More... more) {
    return std::array<T, 1 + sizeof...(more)>{first, static_cast<T>(more)...}[index_below(1 + sizeof...(more))];
}

// Any value of a type; of integers, early trials draw small ones.
template <class T>
[[nodiscard]] T any() = delete;
template <>
[[nodiscard]] bool any<bool>();
template <>
[[nodiscard]] std::int32_t any<std::int32_t>();
template <>
[[nodiscard]] std::uint32_t any<std::uint32_t>();
template <>
[[nodiscard]] std::int64_t any<std::int64_t>();
template <>
[[nodiscard]] std::uint64_t any<std::uint64_t>();

// Counts trials of a kind; the shares are printed.
void tag(const std::string& kind);
inline void tag_if(bool condition, const char* kind) {
    if (condition) {
        tag(kind);
    }
}
// What is printed if the trial fails.
void log(const std::string& line);

[[noreturn]] void fail(const char* file, int line, const char* expression);
[[noreturn]] void discard(const char* file, int line, const char* expression);

} // namespace property

// In a trial: it fails unless this holds; it does not count unless this holds.
#define PROPERTY_ASSERT(expression)                                                                                    \
    ((expression) ? static_cast<void>(0) : property::fail(__FILE__, __LINE__, #expression))
#define PROPERTY_PRE(expression)                                                                                       \
    ((expression) ? static_cast<void>(0) : property::discard(__FILE__, __LINE__, #expression))
