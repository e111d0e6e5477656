# ament_lint_cmake(): adds a test that runs the program of this name.
set(ament_cmake_lint_cmake_FOUND_AMENT_PACKAGE TRUE)
set(ament_cmake_lint_cmake_VERSION "0.17.3")

find_package(ament_cmake_core QUIET REQUIRED)
find_package(ament_cmake_test QUIET REQUIRED)
ament_register_extension("ament_lint_auto" "ament_cmake_lint_cmake" "ament_cmake_lint_cmake_lint_hook.cmake")

# TESTNAME: "lint_cmake" if not given. MAX_LINE_LENGTH: passed on. Other arguments: the files and directories to check.
function(ament_lint_cmake)
  cmake_parse_arguments(ARG "" "TESTNAME;MAX_LINE_LENGTH" "" ${ARGN})
  if(NOT ARG_TESTNAME)
    set(ARG_TESTNAME "lint_cmake")
  endif()
  find_program(ament_lint_cmake_BIN NAMES ament_lint_cmake REQUIRED)
  set(result "${AMENT_TEST_RESULTS_DIR}/${PROJECT_NAME}/${ARG_TESTNAME}.xunit.xml")
  set(command "${ament_lint_cmake_BIN}" --xunit-file "${result}" ${ARG_UNPARSED_ARGUMENTS})
  if(ARG_MAX_LINE_LENGTH)
    list(APPEND command --linelength ${ARG_MAX_LINE_LENGTH})
  endif()
  ament_add_test("${ARG_TESTNAME}"
    COMMAND ${command}
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/ament_lint_cmake/${ARG_TESTNAME}.txt"
    RESULT_FILE "${result}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
  )
  set_tests_properties("${ARG_TESTNAME}" PROPERTIES LABELS "lint_cmake;linter")
endfunction()
