# Targets with the dependencies that were found. Lists of a project: NAME_EXECUTABLES, NAME_LIBRARIES.

# The sources among these words, with those of the folder behind DIRECTORY; and what to do with the target.
macro(_ament_auto_parse)
  cmake_parse_arguments(_AUTO "NO_TARGET_LINK_LIBRARIES" "DIRECTORY" "" ${ARGN})
  set(_auto_sources ${_AUTO_UNPARSED_ARGUMENTS})
  if(_AUTO_DIRECTORY)
    file(GLOB _auto_found ${_AUTO_DIRECTORY}/*.c ${_AUTO_DIRECTORY}/*.cc ${_AUTO_DIRECTORY}/*.cpp
      ${_AUTO_DIRECTORY}/*.cxx)
    if(NOT _auto_found)
      message(FATAL_ERROR "no source was found in the folder '${_AUTO_DIRECTORY}'")
    endif()
    list(APPEND _auto_sources ${_auto_found})
  endif()
endmacro()

# Headers in include/, the project's own libraries, and what the lists of these kinds name.
macro(_ament_auto_link target)
  if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/include")
    target_include_directories(${target} PUBLIC
      $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
  endif()
  if(NOT _AUTO_NO_TARGET_LINK_LIBRARIES AND ${PROJECT_NAME}_LIBRARIES)
    target_link_libraries(${target} ${${PROJECT_NAME}_LIBRARIES})
  endif()
  foreach(_auto_kind ${ARGN})
    if(${PROJECT_NAME}_FOUND_${_auto_kind}_DEPENDS)
      ament_target_dependencies(${target} ${${PROJECT_NAME}_FOUND_${_auto_kind}_DEPENDS})
    endif()
  endforeach()
endmacro()

# ament_auto_add_executable(target [DIRECTORY folder] [NO_TARGET_LINK_LIBRARIES] source…)
macro(ament_auto_add_executable target)
  _ament_auto_add(add_executable EXECUTABLES ${target} ${ARGN})
endmacro()

# ament_auto_add_library(target [DIRECTORY folder] [NO_TARGET_LINK_LIBRARIES] [SHARED|STATIC] source…)
macro(ament_auto_add_library target)
  _ament_auto_add(add_library LIBRARIES ${target} ${ARGN})
endmacro()

macro(_ament_auto_add command list target)
  _ament_auto_parse(${ARGN})
  cmake_language(CALL ${command} ${target} ${_auto_sources})
  _ament_auto_link(${target} BUILD)
  list(APPEND ${PROJECT_NAME}_${list} ${target})
endmacro()

# ament_auto_add_gtest(target source…), ament_auto_add_gmock(target source…): with the arguments of ament_add_…
macro(ament_auto_add_gtest target)
  ament_add_gtest(${target} ${ARGN})
  _ament_auto_link_test(${target})
endmacro()

macro(ament_auto_add_gmock target)
  ament_add_gmock(${target} ${ARGN})
  _ament_auto_link_test(${target})
endmacro()

macro(_ament_auto_link_test target)
  if(TARGET ${target})  # there is none where the tests are skipped
    set(_AUTO_NO_TARGET_LINK_LIBRARIES FALSE)
    _ament_auto_link(${target} BUILD TEST)
  endif()
endmacro()

# ament_auto_generate_code(): the interfaces in the folders msg, srv and action.
macro(ament_auto_generate_code)
  file(GLOB _auto_interfaces RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" msg/*.msg srv/*.srv action/*.action
    msg/*.idl srv/*.idl action/*.idl)
  if(_auto_interfaces)
    set(_auto_named ${${PROJECT_NAME}_FOUND_BUILD_DEPENDS})
    list(FILTER _auto_named EXCLUDE REGEX "^(ament_.*|rosidl_default_generators)$")
    rosidl_generate_interfaces(${PROJECT_NAME} ${_auto_interfaces} DEPENDENCIES ${_auto_named})
  endif()
endmacro()
