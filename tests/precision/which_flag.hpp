// Which flag lost the precision, from the results of several flag sets.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

namespace precision {

// Reads the results.txt that `run` writes. For each group of figures lost in the same flag sets, it names the flags
// that all of these sets have and no other set has. unaccepted: no loss is known, but some figures were compared with
// nothing. Throws std::runtime_error if a file is missing or not of this form.
enum class flag_verdict { nothing_lost, lost, unaccepted };
flag_verdict which_flag(const std::vector<std::filesystem::path>& results, std::ostream& out);

} // namespace precision
