#include "block.hpp"

template void soak::run_block<2>(drawn, std::uint64_t, std::uint64_t, std::uint64_t, tallies&,
                                 std::vector<std::string>&);
