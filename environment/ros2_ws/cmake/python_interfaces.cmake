# Included by project() of each package (CMAKE_PROJECT_INCLUDE) when interfaces are built for Python programs only. For
# code that others use from C++, build without this file.
file(GLOB _interfaces ${PROJECT_SOURCE_DIR}/msg/*.msg ${PROJECT_SOURCE_DIR}/srv/*.srv
  ${PROJECT_SOURCE_DIR}/action/*.action)
if(_interfaces)
  list(APPEND ${PROJECT_NAME}_CONFIG_EXTRAS "${CMAKE_CURRENT_LIST_DIR}/for_python_only.cmake")
  # All that the packages of ROS will ask for, found once: see FindPython3.cmake.
  list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
  find_package(Python3 QUIET COMPONENTS Interpreter Development.Module NumPy)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/for_python_only.cmake)

include(${CMAKE_CURRENT_LIST_DIR}/faster_interfaces.cmake)

# While the set-up builds (environment/builder): one server runs the generators of all packages, and no library names
# the folder that it was built in, so that another copy of the course can use it.
if(DEFINED ENV{COURSE_RULE_LAUNCHER})
  set_property(GLOBAL PROPERTY RULE_LAUNCH_CUSTOM "$ENV{COURSE_RULE_LAUNCHER}")
  foreach(language C CXX)  # not by add_compile_options(): rosidl sets the options of its targets anew
    string(APPEND CMAKE_${language}_FLAGS " \"-fmacro-prefix-map=${CMAKE_BINARY_DIR}=${PROJECT_NAME}\"")
  endforeach()
  cmake_language(DEFER CALL _share_headers_of_python_code)
endif()

function(_share_headers_of_python_code)
  foreach(kind generator_py typesupport_introspection_c)
    set(target ${PROJECT_NAME}__rosidl_${kind})
    if(TARGET ${target})
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 64)
    endif()
  endforeach()
  # The descriptions of types stay apart: two that contain the same type define the same constants.
  set(target ${PROJECT_NAME}__rosidl_generator_c)
  if(TARGET ${target})
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 64)
    get_target_property(_sources ${target} SOURCES)
    list(FILTER _sources INCLUDE REGEX "__description\\.c$")
    set_source_files_properties(${_sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()
