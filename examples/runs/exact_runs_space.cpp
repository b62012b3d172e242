#include "exact_runs_definition.hpp"

template finished_run<3> run_exactly<3>(const graze::scene<3>&, const graze::run_limits<double>&,
                                        const std::function<bool(const exact_event<3>&)>&, graze::cells,
                                        const clock_keeping&);
