// Results as a run could have found them, made up by rule: enough types, groups and cells for every picture, and names
// that would break a page or a script if they were not escaped.
#pragma once

#include "results.hpp"

[[nodiscard]] compare::results sample_results();
