#include <graze/precision/decisions.hpp>

void add_decisions_double(graze::precision::subjects& list);
void add_decisions_double(graze::precision::subjects& list) { graze::precision::add_decisions<double>(list); }
