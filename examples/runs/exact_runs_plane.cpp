#include "exact_runs_definition.hpp"

template finished_run<2> run_exactly<2>(const graze::scene<2>&, const graze::run_limits<double>&,
                                        const std::function<bool(const exact_event<2>&)>&, graze::cells,
                                        const clock_keeping&);
