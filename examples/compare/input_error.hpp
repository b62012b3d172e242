// The exception for bad input.
#pragma once

#include <stdexcept>
#include <string>

namespace compare {

// what() is one line that names the file or the option, the place in it and what is wrong.
class input_error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// text as it can stand in that line: at most `longest` bytes of it, control characters and bytes that are not UTF-8
// as \xNN.
[[nodiscard]] std::string printable(const std::string& text, std::size_t longest = 60);

// A message on one line, as printable as its text.
[[nodiscard]] std::string one_line(std::string message);

} // namespace compare
