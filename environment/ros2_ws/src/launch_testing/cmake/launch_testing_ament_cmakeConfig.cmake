# add_launch_test(): adds a launch test to those of the package.
set(launch_testing_ament_cmake_FOUND_AMENT_PACKAGE TRUE)
set(launch_testing_ament_cmake_VERSION "3.4.5")

find_package(ament_cmake_test QUIET REQUIRED)
find_package(Python3 QUIET REQUIRED COMPONENTS Interpreter)

# filename: the launch test. TARGET: the test's name; made of the path, if not given. TIMEOUT: in seconds, 60 if not given.
# PYTHON_EXECUTABLE, LABELS. ARGS: launch arguments, as name:=value. Others, such as RUNNER, go to ament_add_test().
function(add_launch_test filename)
  cmake_parse_arguments(ARG "" "TARGET;TIMEOUT;PYTHON_EXECUTABLE" "ARGS;LABELS" ${ARGN})
  file(TO_CMAKE_PATH "${filename}" filename)
  get_filename_component(path "${filename}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  if(NOT EXISTS "${path}")
    message(FATAL_ERROR "Can't find launch test file \"${filename}\"")
  endif()
  if(NOT ARG_TARGET)
    set(ARG_TARGET "${path}")
    foreach(folder "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}")
      string(FIND "${ARG_TARGET}" "${folder}/" begin)
      if(begin EQUAL 0)
        string(LENGTH "${folder}/" length)
        string(SUBSTRING "${ARG_TARGET}" ${length} -1 ARG_TARGET)
      endif()
    endforeach()
    string(REPLACE "/" "_" ARG_TARGET "${ARG_TARGET}")
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 60)
  endif()
  if(NOT ARG_PYTHON_EXECUTABLE)
    set(ARG_PYTHON_EXECUTABLE "${Python3_EXECUTABLE}")
  endif()
  if(NOT ARG_LABELS)
    set(ARG_LABELS "launch_test")
  endif()
  set(result "${AMENT_TEST_RESULTS_DIR}/${PROJECT_NAME}/${ARG_TARGET}.xunit.xml")
  ament_add_test("${ARG_TARGET}"
    COMMAND "${ARG_PYTHON_EXECUTABLE}" -m launch_testing.launch_test "${path}" ${ARG_ARGS}
      "--junit-xml=${result}" "--package-name=${PROJECT_NAME}"
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/launch_test/${ARG_TARGET}.txt"
    RESULT_FILE "${result}"
    TIMEOUT "${ARG_TIMEOUT}"
    ${ARG_UNPARSED_ARGUMENTS}
  )
  set_tests_properties("${ARG_TARGET}" PROPERTIES LABELS "${ARG_LABELS}")
endfunction()
