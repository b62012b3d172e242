// Which flag lost the precision, from the results of several flag sets.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

namespace precision {

// Reads what `run` writes as results.txt. Names, for each set of figures that were lost in the same flag sets, the
// flags that all of these have and no other set has. unaccepted: nothing is known to be lost, but there are figures
// that were compared with nothing. std::runtime_error for a file that is not there or not of this form.
enum class flag_verdict { nothing_lost, lost, unaccepted };
flag_verdict which_flag(const std::vector<std::filesystem::path>& results, std::ostream& out);

} // namespace precision
