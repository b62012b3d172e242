# cmake -D SOURCE=<repository> -D WORK=directory -D COMPILER=... -P words.cmake: a word that graze_add_precision_test or
# graze_add_hard_case_search does not understand is an error that names it. For a number type without a conversion to
# double, the error says what to specialise.
cmake_policy(VERSION 3.25)
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")

# refuse(text call): a script with this call ends with an error that contains the text.
function(refuse text call)
    file(WRITE "${WORK}/call.cmake" "cmake_policy(VERSION 3.25)
include(\"${SOURCE}/examples/compare/graze-compare.cmake\")
${call}\n")
    execute_process(COMMAND "${CMAKE_COMMAND}" -P "${WORK}/call.cmake" RESULT_VARIABLE result ERROR_VARIABLE said
        OUTPUT_VARIABLE said)
    string(REGEX REPLACE "[ \n]+" " " said "${said}")
    string(FIND "${said}" "${text}" at)
    if(result EQUAL 0 OR at EQUAL -1)
        message(SEND_ERROR "${call}\nwas taken, or did not say '${text}':\n${said}")
    endif()
endfunction()

foreach(function IN ITEMS graze_add_precision_test graze_add_hard_case_search graze_add_compare_program)
    refuse("${function}(mine): TYPES is missing" "${function}(mine)")
    refuse("${function}(mine): TYPES has no value" "${function}(mine TYPES)")
    refuse("${function}(mine): 'double' belongs to no keyword" "${function}(mine double)")
    refuse("${function}(mine): HEADERS mine.hpp: no such file" "${function}(mine TYPES double HEADERS mine.hpp)")
endforeach()
refuse("FLAGS takes one string" "graze_add_hard_case_search(mine TYPES double FLAGS \"-O1\" \"-O2\")")
refuse("'ACCEPTED' belongs to no keyword" "graze_add_hard_case_search(mine ACCEPTED acc TYPES double)")
refuse("ACCEPTED and AS:" "graze_add_precision_test(mine TYPES double ACCEPTED acc AS /double)")
refuse("ACCEPTED, a folder, or AS is missing" "graze_add_precision_test(mine TYPES double)")
refuse("AS double: no variant/type" "graze_add_precision_test(mine TYPES double AS double)")
refuse("INPUTS none.txt: no such file" "graze_add_precision_test(mine TYPES double AS /double INPUTS none.txt)")
refuse("EXPECT_LOSS -ffast-math: no set of FLAGS has this flag"
    "graze_add_precision_test(mine TYPES double AS /double FLAGS \"-O2\" EXPECT_LOSS -ffast-math)")
refuse("PAIRS many: a whole number above 0" "graze_add_precision_test(mine TYPES double AS /double PAIRS many)")
foreach(option IN ITEMS PAIRS SEED)
    refuse("AS and ${option}: graze's own figures are of 400 pairs"
        "graze_add_precision_test(mine TYPES double AS /double ${option} 20)")
endforeach()
refuse("TOLERANCE little: a percentage" "graze_add_precision_test(mine TYPES double AS /double TOLERANCE little)")

file(WRITE "${WORK}/plain.cpp" "#include <graze/precision/number_access.hpp>
#include <compare>
struct plain16 {
    short n;
    plain16(int x) : n(static_cast<short>(x)) {}
    friend plain16 operator+(plain16 x, plain16 y) { return x.n + y.n; }
    friend plain16 operator-(plain16 x, plain16 y) { return x.n - y.n; }
    friend plain16 operator*(plain16 x, plain16 y) { return x.n * y.n; }
    plain16 operator-() const { return -n; }
    friend auto operator<=>(plain16, plain16) = default;
};
template <>
struct graze::number_traits<plain16> {
    static constexpr const char* name = \"plain16\";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0;
};
int main() { return graze::precision::describe<plain16>().digits; }
")
execute_process(COMMAND "${COMPILER}" -std=c++20 -fsyntax-only "-I${SOURCE}/include" "${WORK}/plain.cpp"
    RESULT_VARIABLE result ERROR_VARIABLE said)
string(REGEX MATCHALL "error:" errors "${said}")
list(LENGTH errors count)
if(result EQUAL 0 OR NOT said MATCHES "specialise graze::precision::number_access" OR NOT count EQUAL 1)
    message(SEND_ERROR "a type without a conversion to double is not told what it needs, in one error:\n${said}")
endif()
