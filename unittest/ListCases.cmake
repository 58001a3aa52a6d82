# Read by ctest when it starts: asks one test program for its GoogleTest cases and adds a
# ctest test for each, on each number of ranks.  The variables come from the script that
# includes this one (written by lbmibb_add_test).

execute_process(COMMAND "${program}" --gtest_list_tests
  OUTPUT_VARIABLE listing ERROR_VARIABLE errors RESULT_VARIABLE failed)
if(failed)
  # a program that was not built, or cannot start, must be seen to fail
  add_test("${name}.NOT_BUILT" "${program}")
  set_tests_properties("${name}.NOT_BUILT" PROPERTIES LABELS "${labels}")
  return()
endif()

string(REGEX REPLACE " +#[^\n]*" "" listing "${listing}")    # values of parameters
string(REPLACE "\n" ";" listing "${listing}")
foreach(line IN LISTS listing)
  if(line MATCHES "^([A-Za-z0-9_/]+\\.)$")
    set(suite "${line}")
  elseif(line MATCHES "^  ([A-Za-z0-9_/]+)$")
    set(case "${suite}${CMAKE_MATCH_1}")
    foreach(np IN LISTS ranks)
      if(np STREQUAL "none")    # started without mpirun
        set(test "${name}.${case}")
        set(command "${program}")
        set(processors 1)
      else()
        set(test "${name}.${case}-np${np}")
        set(command ${mpiexec} ${np} "${program}")
        set(processors ${np})
      endif()
      string(REPLACE "/" "_" run "${test}")
      file(MAKE_DIRECTORY "${folder}/${run}")
      add_test("${test}" ${command} "--gtest_filter=${case}" --gtest_also_run_disabled_tests)
      set_tests_properties("${test}" PROPERTIES
        LABELS "${labels}" TIMEOUT "${timeout}" PROCESSORS "${processors}"
        ENVIRONMENT "${environment}" WORKING_DIRECTORY "${folder}/${run}"
        SKIP_RETURN_CODE 77)
      if(case MATCHES "DISABLED_")
        set_tests_properties("${test}" PROPERTIES DISABLED TRUE)
      endif()
    endforeach()
  endif()
endforeach()
