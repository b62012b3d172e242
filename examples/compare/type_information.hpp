// What is known of a number type.
#pragma once

#include <cstddef>
#include <string>

namespace compare {

struct type_information {
    std::string name;
    std::string library; // "built in", "Boost", "GMP", "MPFR", "CGAL", "QD", "example"
    bool is_exact = false;
    bool is_interval = false;
    int digits = 0; // bits of the significand; 0 where there is no such number
    bool has_sqrt = false, has_fma = false;
    std::size_t bytes = 0;      // size of one value
    std::size_t real_bytes = 0; // size of τ's type (a sqrt_extension where the type has no root)
    bool uses_heap = false;     // whether a value owns memory beyond its bytes
    std::string alias_of;       // the listed type that this also names; an alias is neither measured nor counted
    std::string note;
};

} // namespace compare
