#include <graze/precision/formulas.hpp>

void add_double(graze::precision::subjects& list);
void add_double(graze::precision::subjects& list) { graze::precision::add_formulas<double>(list); }
