# Read by CTest: adds a test for each suite of the GoogleTest program `program`, as "${prefix}Suite", and
# keeps the list in the file `found` until the program is newer. See asos_discover_suites.
if(NOT EXISTS "${program}")
  add_test("${prefix}not_built" "${program}")
  return()
endif()
if(NOT EXISTS "${found}" OR "${program}" IS_NEWER_THAN "${found}" OR
    "${CMAKE_CURRENT_LIST_FILE}" IS_NEWER_THAN "${found}")
  execute_process(COMMAND "${program}" --gtest_list_tests
    OUTPUT_VARIABLE listed RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${program} --gtest_list_tests: ${status}\n${listed}")
  endif()
  # A suite's line has its name and a dot; its tests' lines begin with spaces.
  string(REGEX MATCHALL "(^|\n)[^ \n][^ \n]*[.]" suites "${listed}")
  # A suite is skipped if no test passed and none failed: failures would be listed last.
  set(skipped "PASSED  \\] 0 tests[.]\n(\\[  SKIPPED \\] [^\n]*\n)+$")
  set(tests "")
  foreach(line IN LISTS suites)
    string(REGEX REPLACE "^\n?(.*)[.]$" "\\1" suite "${line}")
    string(APPEND tests "add_test([==[${prefix}${suite}]==] [==[${program}]==] "
      "[==[--gtest_filter=${suite}.*]==] --gtest_color=no)\n"
      "set_tests_properties([==[${prefix}${suite}]==] PROPERTIES TIMEOUT ${timeout} "
      "SKIP_REGULAR_EXPRESSION [==[${skipped}]==])\n")
  endforeach()
  file(WRITE "${found}" "${tests}")
endif()
include("${found}")
