// Included before anything else where CGAL is used (first of its precompiled headers, see CMakeLists.txt): errors of
// CORE's become exceptions.
//
// CORE::core_error writes a file Core_Diagnostics into the current directory and, of an error, ends the program. Real
// input leads there: the sign of a sum in which a quotient is small (below 2^-60 or so) divides by an approximation
// without a correct bit ("possible zero divisor"). The macro renames the function in CORE's headers; its calls,
// whose file name is a literal, then find the better match here.
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
