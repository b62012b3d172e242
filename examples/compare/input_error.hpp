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

// At most `longest` bytes of text, fit for that line and for a terminal: control characters, characters that change how
// others look (formatting_at) and bytes that are not UTF-8 are written as \xNN.
[[nodiscard]] std::string printable(const std::string& text, std::size_t longest = 60);

// If the character at text[at] is invisible but changes how others look, such as a right-to-left override or a line
// separator: its length in bytes. Otherwise 0.
[[nodiscard]] std::size_t formatting_at(std::string_view text, std::size_t at);

// The message on one line, with the same characters replaced.
[[nodiscard]] std::string one_line(std::string message);

} // namespace compare
