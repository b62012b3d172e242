// The number types that are measured, one function and one source file each.
#pragma once

#include "../solver.hpp"

namespace compare::types {

measurable of_float();
measurable of_double();
measurable of_long_double();
measurable of_float128();          // libquadmath
measurable of_double_double();     // QD
measurable of_cpp_bin_float_50();  // Boost, as are the next three
measurable of_cpp_bin_float_100(); //
measurable of_cpp_dec_float_50();  //
measurable of_cpp_rational();      //
measurable of_mpfr_float_50();     // Boost on MPFR
measurable of_mpq_rational();      // Boost on GMP
measurable of_mpq_class();         // GMP
measurable of_gmpq();              // CGAL, as are the next four
measurable of_exact_rational();    // an alias
measurable of_lazy_exact();        //
measurable of_interval();          //
measurable of_core_expr();         //
measurable of_fixed_point();       // of examples/
measurable of_graze();             // graze::collide instead of formulas in a type

} // namespace compare::types
