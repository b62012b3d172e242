// Turns CORE's errors into exceptions. Must be included before CGAL wherever CGAL is used.
//
// CORE::core_error writes a file Core_Diagnostics into the current directory and, for an error, ends the program.
// Ordinary input leads there: to find the sign of a sum with a small quotient (below about 2^-60), CORE divides by an
// approximation without a correct bit ("possible zero divisor"). The macro renames the function in CORE's headers.
// Their calls pass a literal as file name, so they find the better match below.
#pragma once

#include <stdexcept>
#include <string>

namespace CORE {

inline void diagnosed(const char* message, const char*, int, bool is_error) {
    if (is_error) {
        throw std::runtime_error(message);
    }
}
inline void diagnosed(const std::string& message, const char* file, int line, bool is_error) {
    diagnosed(message.c_str(), file, line, is_error);
}

} // namespace CORE

#define core_error(message, file, line, is_error) diagnosed(message, file, line, is_error)
