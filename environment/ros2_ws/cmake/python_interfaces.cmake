# Included by project() of each package (CMAKE_PROJECT_INCLUDE) when interfaces are built for Python programs only:
# leave out the generators and type supports for C++. rclpy works on those for C (rmw_fastrtps_cpp reads the
# introspection of C, too, when it registers a type). For code that others use from C++, build without this file.
find_package(ament_cmake_core QUIET)

macro(ament_register_extension point package file)
  if(NOT ("${point}" STREQUAL "rosidl_generate_idl_interfaces" AND "${package}" MATCHES "_cpp$"))
    # The macro's own definition: CMake keeps an overridden command under its name with an underscore.
    _ament_register_extension("${point}" "${package}" "${file}")
  endif()
endmacro()

include(${CMAKE_CURRENT_LIST_DIR}/faster_interfaces.cmake)
