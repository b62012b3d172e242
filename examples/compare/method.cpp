#include "method.hpp"

namespace compare {

const char* to_string(graze::variant v) noexcept {
    switch (v) {
    case graze::variant::textbook:
        return "textbook";
    case graze::variant::halved:
        return "halved";
    case graze::variant::kahan:
        return "kahan";
    case graze::variant::lagrange:
        return "lagrange";
    }
    return "unknown";
}

const char* to_string(graze::root_form f) noexcept { return f == graze::root_form::printed ? "printed" : "stable"; }

std::vector<method> all_methods() {
    std::vector<method> methods;
    for (const auto v :
         {graze::variant::textbook, graze::variant::halved, graze::variant::kahan, graze::variant::lagrange}) {
        for (const auto f : {graze::root_form::printed, graze::root_form::stable}) {
            methods.push_back({v, f});
        }
    }
    return methods;
}

} // namespace compare
