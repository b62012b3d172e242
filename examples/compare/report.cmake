# compare_report: the report and its pictures, as a static library that its test links too.
find_package(Boost 1.74 REQUIRED)
add_library(compare_report STATIC
  ${CMAKE_CURRENT_LIST_DIR}/report.cpp
  ${CMAKE_CURRENT_LIST_DIR}/whole_file.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/decisions.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/distribution.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/exactness.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/gnuplot.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/hardness.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/matrix.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/picture.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/placement.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/speed.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/style.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/summary.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/svg.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/tables.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/text.cpp)
target_include_directories(compare_report PUBLIC ${CMAKE_CURRENT_LIST_DIR})
target_compile_features(compare_report PUBLIC cxx_std_20)
target_link_libraries(compare_report PRIVATE compare_engine Boost::headers graze_warnings)
target_compile_options(compare_report PRIVATE $<$<CONFIG:Release>:-O1>)
