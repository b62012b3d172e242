#include "certified_mechanics.hpp"

namespace compare::run {

int order_of(const certified_time& s, const certified_time& t) {
    if (const std::optional<int> certain = (s.value - t.value).certain_sign()) {
        return *certain;
    }
    if (s.exactly && t.exactly) {
        return graze::root_order{}(*s.exactly, *t.exactly);
    }
    throw graze::undecided("the order of two times", near_double(s.value));
}

} // namespace compare::run
