#include "contact_soak_run.hpp"

template contact_soak::tally contact_soak::run<3, float>(std::size_t, std::uint64_t, std::uint64_t, std::uint64_t,
                                                         std::vector<std::string>&);
