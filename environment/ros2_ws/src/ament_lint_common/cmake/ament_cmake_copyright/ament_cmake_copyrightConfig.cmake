# ament_copyright(): adds a test that runs the program of this name.
set(ament_cmake_copyright_FOUND_AMENT_PACKAGE TRUE)
set(ament_cmake_copyright_VERSION "0.17.3")

find_package(ament_cmake_core QUIET REQUIRED)
find_package(ament_cmake_test QUIET REQUIRED)
ament_register_extension("ament_lint_auto" "ament_cmake_copyright" "ament_cmake_copyright_lint_hook.cmake")

# TESTNAME: "copyright" if not given. TIMEOUT: passed on. Other arguments: the files and directories to check.
function(ament_copyright)
  cmake_parse_arguments(ARG "" "TESTNAME;TIMEOUT" "" ${ARGN})
  if(NOT ARG_TESTNAME)
    set(ARG_TESTNAME "copyright")
  endif()
  find_program(ament_copyright_BIN NAMES ament_copyright REQUIRED)
  set(result "${AMENT_TEST_RESULTS_DIR}/${PROJECT_NAME}/${ARG_TESTNAME}.xunit.xml")
  set(command "${ament_copyright_BIN}" --xunit-file "${result}" ${ARG_UNPARSED_ARGUMENTS})
  if(ARG_TIMEOUT)
    set(timeout TIMEOUT ${ARG_TIMEOUT})
  else()
    set(timeout TIMEOUT 120)
  endif()
  ament_add_test("${ARG_TESTNAME}"
    COMMAND ${command}
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/ament_copyright/${ARG_TESTNAME}.txt"
    RESULT_FILE "${result}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    ${timeout}
  )
  set_tests_properties("${ARG_TESTNAME}" PROPERTIES LABELS "copyright;linter")
endfunction()
