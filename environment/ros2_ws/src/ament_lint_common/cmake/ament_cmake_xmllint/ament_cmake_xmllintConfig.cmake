# ament_xmllint(): adds a test that runs the program of this name.
set(ament_cmake_xmllint_FOUND_AMENT_PACKAGE TRUE)
set(ament_cmake_xmllint_VERSION "0.17.3")

find_package(ament_cmake_core QUIET REQUIRED)
find_package(ament_cmake_test QUIET REQUIRED)
ament_register_extension("ament_lint_auto" "ament_cmake_xmllint" "ament_cmake_xmllint_lint_hook.cmake")

# TESTNAME: "xmllint" if not given. EXCLUDE;EXTENSIONS: passed on. Other arguments: the files and directories to check.
function(ament_xmllint)
  cmake_parse_arguments(ARG "" "TESTNAME;EXCLUDE;EXTENSIONS" "" ${ARGN})
  if(NOT ARG_TESTNAME)
    set(ARG_TESTNAME "xmllint")
  endif()
  find_program(ament_xmllint_BIN NAMES ament_xmllint REQUIRED)
  set(result "${AMENT_TEST_RESULTS_DIR}/${PROJECT_NAME}/${ARG_TESTNAME}.xunit.xml")
  set(command "${ament_xmllint_BIN}" --xunit-file "${result}" ${ARG_UNPARSED_ARGUMENTS})
  if(ARG_EXCLUDE)
    list(APPEND command --exclude ${ARG_EXCLUDE})
  endif()
  if(ARG_EXTENSIONS)
    list(APPEND command --extensions ${ARG_EXTENSIONS})
  endif()
  ament_add_test("${ARG_TESTNAME}"
    COMMAND ${command}
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/ament_xmllint/${ARG_TESTNAME}.txt"
    RESULT_FILE "${result}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
  )
  set_tests_properties("${ARG_TESTNAME}" PROPERTIES LABELS "xmllint;linter")
endfunction()
