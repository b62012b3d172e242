#include "decide.hpp"

#include <type_traits>

void environments::add_balls_and_planes(std::vector<subject>& subjects) {
    const auto add = [&]<int N, class T>() {
        add_decision<partner::ball, N, T>(subjects);
        if constexpr (level >= 1 || std::is_same_v<T, double>) {
            add_decision<partner::plane, N, T>(subjects);
        }
    };
    add.operator()<3, double>();
    add.operator()<2, float>();
    add.operator()<3, std::int64_t>();
    if constexpr (level >= 1) {
        add.operator()<2, double>();
        add.operator()<3, float>();
        add.operator()<2, std::int32_t>();
        add.operator()<3, std::int32_t>();
        add.operator()<2, std::int64_t>();
    }
}
