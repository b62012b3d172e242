// How a scene's numbers are taken.
#pragma once

namespace compare {

// exactly: as written. as_double: each number rounded to the nearest double, so that all types solve the same problem;
// one that overflows is an error.
enum class number_input { as_double, exactly };

} // namespace compare
