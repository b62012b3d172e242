#include "own_types.hpp"

namespace compare {

std::vector<measurable> own_types() { return {}; }

} // namespace compare
