# Certified runs, and runs in number types beside them, as static libraries that their tests link too.
if(NOT TARGET graze_number_mpfi)
    set_property(SOURCE main.cpp APPEND PROPERTY COMPILE_DEFINITIONS COMPARE_HAS_MPFI=0)
    return()
endif()
set_property(SOURCE main.cpp APPEND PROPERTY COMPILE_DEFINITIONS COMPARE_HAS_MPFI=1)

# The proof, and how a type's run is judged by it.
add_library(compare_certified STATIC
    run/certified.cpp run/certified_flight.cpp run/certified_run.cpp run/certified_time.cpp run/clearance.cpp
    run/event_check.cpp run/event_ways.cpp run/integer_line.cpp run/interruption.cpp run/mpfi_interval.cpp run/sequence.cpp)
target_link_libraries(compare_certified PUBLIC compare_engine graze_number_mpfi PRIVATE graze_warnings)
compare_compile_quickly(compare_certified)

# Number types against the clock: those of the machine as they are, those of software, which spend their time in their
# libraries, and the many templates of graze less optimised.
add_library(compare_run_machine_types STATIC run/types/built_in.cpp)
add_library(compare_run_software_types STATIC
    run/runnables.cpp run/types/cpp_bin_float.cpp run/types/graze.cpp run/types/mpfr_float_50.cpp)
foreach(types IN ITEMS compare_run_machine_types compare_run_software_types)
    target_link_libraries(${types} PUBLIC compare_certified PRIVATE graze_warnings)
endforeach()
target_link_libraries(compare_run_software_types PRIVATE compare_run_machine_types)
compare_compile_quickly(compare_run_software_types)
function(compare_run_type library source)
    string(TOUPPER "COMPARE_HAS_${library}" macro)
    if(TARGET graze_number_${library})
        target_sources(compare_run_software_types PRIVATE ${source})
        target_link_libraries(compare_run_software_types PRIVATE graze_number_${library})
        set_property(SOURCE run/runnables.cpp APPEND PROPERTY COMPILE_DEFINITIONS ${macro}=1)
    else()
        set_property(SOURCE run/runnables.cpp APPEND PROPERTY COMPILE_DEFINITIONS ${macro}=0)
    endif()
endfunction()
compare_run_type(float128 run/types/float128.cpp)
compare_run_type(qd run/types/double_double.cpp)

# What is told.
add_library(compare_run STATIC
    run/digits_picture.cpp run/paths_picture.cpp run/run_command.cpp run/run_json.cpp run/run_text.cpp)
target_link_libraries(compare_run
    PUBLIC compare_certified
    PRIVATE compare_run_software_types compare_report CLI11::CLI11 nlohmann_json::nlohmann_json Boost::headers
        graze_warnings)
compare_compile_quickly(compare_run)
target_link_libraries(graze-compare PRIVATE compare_run)
