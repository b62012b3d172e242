#include <graze/precision/formulas.hpp>

void add_float(graze::precision::subjects& list);
void add_float(graze::precision::subjects& list) { graze::precision::add_formulas<float>(list); }
