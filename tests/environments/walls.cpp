#include "decide.hpp"

void environments::add_walls(std::vector<subject>& subjects) {
    add_decision<partner::wall, 2, double>(subjects);
    if constexpr (level >= 1) {
        add_decision<partner::wall, 3, double>(subjects);
        add_decision<partner::wall, 2, std::int64_t>(subjects);
    }
    if constexpr (level >= 2) {
        add_decision<partner::wall, 2, float>(subjects);
        add_decision<partner::wall, 3, float>(subjects);
        add_decision<partner::wall, 2, std::int32_t>(subjects);
        add_decision<partner::wall, 3, std::int32_t>(subjects);
        add_decision<partner::wall, 3, std::int64_t>(subjects);
    }
}
