// A file that is written whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace compare {

// The path that stands for the standard output, or the standard input.
inline constexpr const char* standard_stream = "-";

// Writes content to a new file beside path and renames it onto path, so that nobody sees half of it and what was there
// stays when something fails. The file keeps the mode of the one that it replaces. What a killed program left behind of
// such a new file is removed. "-" is the standard output; a path that exists and is no regular file (/dev/stdout, a
// pipe) is written straight. Throws std::runtime_error that names path and says what failed.
void write_whole_file(const std::string& path, std::string_view content);

// That the file an option names could be written, before hours of measuring; an empty path is none. Throws input_error.
void check_writable(const std::string& option, const std::string& path);

} // namespace compare
