// How a function fails: by an exception or, in a unit without exceptions, by ending the program.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

// Units of both kinds may be linked into one program. The linker keeps one copy of an inline function, from any unit.
// So that a unit with exceptions always gets its exception, the other kind throws too if any unit of the program can.
namespace graze::inline v0_1::detail {

#if defined(__cpp_exceptions)

#if !defined(GRAZE_DETAIL_WIDE_UNIT) // such a unit defines nothing that another unit might have
[[gnu::used]] inline void throw_domain_error(const char* message) { throw std::domain_error(message); }
#endif

inline namespace with_exceptions {
struct unit_mode {}; // as a template argument it makes different functions in units of the two kinds
template <class Error>
[[noreturn]] void fail(const std::string& message) {
    throw Error(message);
}
} // namespace with_exceptions

#else

[[gnu::weak]] void throw_domain_error(const char* message); // of a unit with exceptions

inline namespace without_exceptions {
struct unit_mode {};
template <class Error>
[[noreturn]] void fail(const std::string& message) {
    if (throw_domain_error != nullptr) {
        throw_domain_error(message.c_str());
    }
    std::fprintf(stderr, "%s\n", message.c_str());
    std::abort();
}
} // namespace without_exceptions

#endif

} // namespace graze::inline v0_1::detail
