# cmake -D PROGRAM=... -D WORK=directory -P own.cmake: a program with the types and formulas of own_number.hpp. Their
# losses are known: 2τ instead of τ is wrong by τ, which is 2^52 to 2^53 units in the last place; 30 of 53 bits leave an
# error of 2^20 units or more in half of the pairs.
cmake_policy(VERSION 3.25)
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
function(expect what)
    if(NOT (${ARGN}))
        message(SEND_ERROR "${what}: not ${ARGN}")
    endif()
endfunction()

execute_process(COMMAND "${PROGRAM}" --list-types OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
foreach(name IN ITEMS thirty_bits "late in thirty_bits" "careless in thirty_bits")
    if(NOT said MATCHES "\n${name} ")
        message(SEND_ERROR "no '${name}' among the types:\n${said}")
    endif()
endforeach()
# figures(family type...): measures 60 pairs and sets variables TYPE_VARIANT_ROOT_QUANTITY_FIGURE.
macro(figures family)
    execute_process(COMMAND "${PROGRAM}" --family ${family} --count 60 --timing 0.01 --json out.json --types "${ARGN}"
        WORKING_DIRECTORY "${WORK}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    file(READ "${WORK}/out.json" json)
    string(JSON rows LENGTH "${json}" rows)
    math(EXPR last "${rows} - 1")
    foreach(i RANGE ${last})
        set(row "")
        foreach(key IN ITEMS type variant root)
            string(JSON word GET "${json}" rows ${i} ${key})
            string(APPEND row "${word}_")
        endforeach()
        string(MAKE_C_IDENTIFIER "${row}" row)
        foreach(quantity IN ITEMS time discriminant)
            foreach(figure IN ITEMS median largest)
                string(JSON ${row}${quantity}_${figure} GET "${json}" rows ${i} errors ${quantity} ${figure})
            endforeach()
        endforeach()
        string(JSON ${row}ns GET "${json}" rows ${i} nanoseconds)
    endforeach()
endmacro()

figures(generic "double,thirty_bits,late in thirty_bits,graze")
expect("the types and forms" rows EQUAL 16) # 8 of double, 6 of one without a fused multiply-add, a formula, and graze
expect("twice the time" late_in_thirty_bits_lagrange_stable_time_median GREATER 4503599627370496)
expect("twice the time" late_in_thirty_bits_lagrange_stable_time_median LESS 9007199254740992)
expect("thirty bits" thirty_bits_lagrange_stable_time_median GREATER 1048576)
expect("what double gets right" double_lagrange_stable_time_median LESS 16)
expect("graze" graze_lagrange_stable_time_largest LESS_EQUAL 0.5)
expect("the time of a formula" late_in_thirty_bits_lagrange_stable_ns GREATER 0)

# h² and q|Δx|² - qR² lose more apart than in h² - qc, where c is small and right to its last bits.
figures(near_contact "thirty_bits,careless in thirty_bits")
expect("the careless discriminant" careless_in_thirty_bits_lagrange_stable_discriminant_median GREATER
    thirty_bits_halved_stable_discriminant_median)
