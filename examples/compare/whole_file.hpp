// A file that is written whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace compare {

// The path that means the standard output or the standard input.
inline constexpr const char* standard_stream = "-";

// Writes content to a new file beside path and renames it to path, so that no reader sees half of it and a failure
// leaves the old file. The file keeps the mode of the one that it replaces. Part files of killed programs are removed.
// "-" is the standard output. A path that exists but is no regular file (/dev/stdout, a pipe) is written directly.
// Throws std::runtime_error, which names path and says what failed.
void write_whole_file(const std::string& path, std::string_view content);

// Checks, before hours of measuring, that the file of an option can be written. An empty path is none. Throws
// input_error.
void check_writable(const std::string& option, const std::string& path);

} // namespace compare
