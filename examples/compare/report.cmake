# compare_report: the report and its pictures, as a static library that its test links too.
find_package(Boost 1.74 REQUIRED)
set(report report.cpp report/decisions.cpp report/diff_page.cpp report/distribution.cpp report/dots.cpp report/exactness.cpp
    report/gnuplot.cpp report/hardness.cpp report/matrix.cpp report/picture.cpp report/placement.cpp report/speed.cpp
    report/style.cpp report/summary.cpp report/svg.cpp report/tables.cpp report/text.cpp)
add_library(compare_report STATIC ${report})
target_include_directories(compare_report PUBLIC ${CMAKE_CURRENT_LIST_DIR})
target_compile_features(compare_report PUBLIC cxx_std_20)
target_link_libraries(compare_report PRIVATE compare_results compare_input Boost::headers nlohmann_json::nlohmann_json graze_warnings)
compare_compile_together(compare_report -O0 ${report})
