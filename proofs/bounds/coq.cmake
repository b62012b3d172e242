# cmake -D PROGRAM=error-bounds -D GAPPA=... -D COQC=... -D WORK=... [-D SECONDS=...] -P coq.cmake: writes every script,
# has Gappa write a proof of each for Coq, and has Coq check them, the shortest first. The steps that Gappa leaves to the
# user, the error of a quotient and x + y - x = y, are proved here too. A proof that Coq has accepted, word for word, is
# not checked again: remove WORK to check all. A proof that takes longer than SECONDS is skipped and named at the end.
cmake_policy(VERSION 3.25)
file(MAKE_DIRECTORY "${WORK}")
file(GLOB old "${WORK}/*.g")
if(old)
    file(REMOVE ${old})
endif()
execute_process(COMMAND "${PROGRAM}" scripts "${WORK}" COMMAND_ERROR_IS_FATAL ANY)
file(GLOB scripts "${WORK}/*_double.g") # for float nothing but u differs
set(by_length)
foreach(script IN LISTS scripts)
    execute_process(COMMAND "${GAPPA}" -Bcoq "${script}" OUTPUT_VARIABLE proof ERROR_VARIABLE said RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "gappa does not prove ${script}:\n${said}")
    endif()
    string(REPLACE "Section Generated_by_Gappa." [[
Require Reals.
Module left_to_us.
Import Reals.
Lemma quotient : forall x y t m : R,
  (t <> 0 -> m <> 0 -> x / t - y / m = (x - y - y / m * (t - m)) / t)%R.
Proof. intros; field; split; assumption. Qed.
Lemma sum : forall x y : R, (x + y - x = y)%R.
Proof. intros; ring. Qed.
End left_to_us.
Section Generated_by_Gappa.]] proof "${proof}")
    string(REGEX REPLACE "Hypothesis (a[0-9]+) : ([^\n]*)\\.\n"
        "Lemma \\1 : \\2.\nProof. intros; first [ apply left_to_us.quotient; assumption | apply left_to_us.sum ]. Qed.\n" proof "${proof}")
    if(proof MATCHES "Hypothesis|Axiom|Admitted")
        message(FATAL_ERROR "the proof of ${script} supposes something")
    endif()
    cmake_path(GET script STEM stem)
    file(WRITE "${WORK}/bound_${stem}.v" "${proof}")
    string(LENGTH "${proof}" length)
    list(APPEND by_length "${length}/${stem}")
endforeach()
list(SORT by_length COMPARE NATURAL)

set(limit)
if(SECONDS)
    set(limit TIMEOUT "${SECONDS}")
endif()
list(LENGTH by_length all)
set(count 0)
set(left)
foreach(entry IN LISTS by_length)
    cmake_path(GET entry FILENAME stem)
    set(file "${WORK}/bound_${stem}.v")
    file(STRINGS "${WORK}/${stem}.g" title LIMIT_COUNT 1 ENCODING UTF-8)
    file(SHA256 "${file}" hash)
    if(NOT EXISTS "${WORK}/accepted/${hash}")
        execute_process(COMMAND "${COQC}" -q "${file}" OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result
            ${limit})
        if(result MATCHES "timeout")
            message(STATUS "Coq takes longer than ${SECONDS} s: ${title}")
            string(APPEND left "\n  ${title}")
            continue()
        elseif(NOT result EQUAL 0)
            message(FATAL_ERROR "Coq does not accept ${file}:\n${said}")
        endif()
        file(WRITE "${WORK}/accepted/${hash}" "${title}\n")
    endif()
    math(EXPR count "${count} + 1")
    message(STATUS "Coq accepts ${count} of ${all}: ${title}")
endforeach()
if(left OR count EQUAL 0)
    message(FATAL_ERROR "Coq has accepted ${count} of ${all} proofs; left are:${left}")
endif()
message(STATUS "Coq accepts all ${count} proofs")
