# What package.xml names, found. Lists of a project: NAME_FOUND_BUILD_DEPENDS, NAME_FOUND_TEST_DEPENDS.

# Find these packages, and note them in the list NAME_FOUND_<kind>_DEPENDS. What is no package of CMake is left out,
# unless it stands behind REQUIRED.
macro(_ament_auto_find kind)
  cmake_parse_arguments(_AUTO "" "" "PACKAGES;REQUIRED" ${ARGN})
  if(_AUTO_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "this function was called with unused arguments: ${_AUTO_UNPARSED_ARGUMENTS}")
  endif()
  foreach(_auto_name ${_AUTO_REQUIRED})
    if(NOT _auto_name IN_LIST _AUTO_PACKAGES)
      message(FATAL_ERROR "'${_auto_name}' is required, and package.xml does not name it as a dependency")
    endif()
  endforeach()
  foreach(_auto_name ${_AUTO_PACKAGES})
    find_package(${_auto_name} QUIET)
    if(${_auto_name}_FOUND)
      list(APPEND ${PROJECT_NAME}_FOUND_${kind}_DEPENDS ${_auto_name})
    elseif(_auto_name IN_LIST _AUTO_REQUIRED)
      message(FATAL_ERROR "the required package '${_auto_name}' was not found")
    endif()
  endforeach()
endmacro()

# ament_auto_find_build_dependencies([REQUIRED package…]): find what package.xml needs for the build.
macro(ament_auto_find_build_dependencies)
  _ament_auto_read_package_xml()
  _ament_auto_find(BUILD ${ARGN} PACKAGES ${${PROJECT_NAME}_BUILD_DEPENDS} ${${PROJECT_NAME}_BUILDTOOL_DEPENDS})
endmacro()

# ament_auto_find_test_dependencies([REQUIRED package…]): find what package.xml needs for the tests.
macro(ament_auto_find_test_dependencies)
  _ament_auto_read_package_xml()
  _ament_auto_find(TEST ${ARGN} PACKAGES ${${PROJECT_NAME}_TEST_DEPENDS})
endmacro()

# ament_auto_depend_on_packages(package…): packages that package.xml does not name, for all targets that follow.
macro(ament_auto_depend_on_packages)
  _ament_auto_find(BUILD PACKAGES ${ARGN} REQUIRED ${ARGN})
endmacro()

macro(_ament_auto_read_package_xml)
  if(NOT _AMENT_PACKAGE_NAME)
    ament_package_xml()
  endif()
endmacro()
