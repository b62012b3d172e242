// The exception for bad input.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace compare {

// what() is one line that names the file or the option, the place in it and what is wrong.
class input_error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// text as it can stand in that line and on a terminal: at most `longest` bytes of it. Control characters, characters
// that change how others look (formatting_at) and bytes that are not UTF-8 stand as \xNN.
[[nodiscard]] std::string printable(const std::string& text, std::size_t longest = 60);

// The bytes of the character at text[at] if it is one that is not seen but changes how others look, such as a
// right-to-left override or a line separator; otherwise 0.
[[nodiscard]] std::size_t formatting_at(std::string_view text, std::size_t at);

// A message on one line, as printable as its text.
[[nodiscard]] std::string one_line(std::string message);

} // namespace compare
