# The report: its text by itself, and as a browser shows it.
find_package(Boost 1.74 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)

graze_add_test(compare_report_test SOURCES report_test.cpp report_sample.cpp LIBRARIES compare_report Boost::headers)

add_executable(compare_report_browser_test report_browser_test.cpp report_sample.cpp chromium.cpp)
target_link_libraries(compare_report_browser_test
  PRIVATE compare_report graze_warnings doctest::doctest nlohmann_json::nlohmann_json)
add_test(NAME compare_report_browser_test COMMAND compare_report_browser_test)
# 77: chromium is not installed.
set_tests_properties(compare_report_browser_test PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600)
graze_build_when_asked(matrix compare_report_browser_test compare_report_browser_test)
