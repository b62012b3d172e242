# graze-compare-run: certified runs, and runs in number types beside them. They take long to compile and are rarely wanted,
# so `./graze compare run` builds them when needed. Static libraries, which their tests link too.
if(NOT TARGET graze_number_mpfi)
    target_compile_definitions(compare_program PRIVATE COMPARE_HAS_MPFI=0)
    return()
endif()
target_compile_definitions(compare_program PRIVATE COMPARE_HAS_MPFI=1)

# The proof, and the judgement of a type's run by it.
set(certified run/certified.cpp run/certified_flight.cpp run/certified_run.cpp run/certified_time.cpp run/clearance.cpp
    run/event_check.cpp run/extent.cpp run/integer_line.cpp run/mpfi_interval.cpp)
add_library(compare_certified STATIC ${certified} run/event_place.cpp run/event_sides.cpp run/event_ways.cpp
    run/sequence.cpp)
target_link_libraries(compare_certified PUBLIC compare_engine graze_number_mpfi PRIVATE graze_warnings)
compare_compile_together(compare_certified -O1 ${certified})

# Runs in number types, which are timed.
add_library(compare_run_types STATIC run/runnables.cpp run/types/cpp_bin_float_50.cpp run/types/cpp_bin_float_100.cpp
    run/types/double.cpp run/types/float.cpp run/types/graze.cpp run/types/long_double.cpp run/types/mpfr_float_50.cpp)
target_link_libraries(compare_run_types PUBLIC compare_certified PRIVATE $<TARGET_NAME_IF_EXISTS:graze::compiled> graze_warnings)
function(compare_run_type library source)
    string(TOUPPER "COMPARE_HAS_${library}" macro)
    if(TARGET graze_number_${library})
        target_sources(compare_run_types PRIVATE ${source})
        target_link_libraries(compare_run_types PRIVATE graze_number_${library})
        set_property(SOURCE run/runnables.cpp APPEND PROPERTY COMPILE_DEFINITIONS ${macro}=1)
    else()
        set_property(SOURCE run/runnables.cpp APPEND PROPERTY COMPILE_DEFINITIONS ${macro}=0)
    endif()
endfunction()
compare_run_type(float128 run/types/float128.cpp)
compare_run_type(qd run/types/double_double.cpp)

# The reports.
set(told run_main.cpp run/digits_picture.cpp run/paths_picture.cpp run/run_command.cpp run/run_json.cpp
    run/run_options.cpp run/run_text.cpp)
add_executable(graze-compare-run ${told})
target_link_libraries(graze-compare-run PRIVATE compare_run_types compare_report CLI11::CLI11 nlohmann_json::nlohmann_json
    Boost::headers graze_warnings)
compare_compile_together(graze-compare-run -O0 ${told})
