# Included by project() of each package (CMAKE_PROJECT_INCLUDE) when interfaces are built for Python programs only:
# leave out the type supports for C++ and the introspection ones, which rclpy on Fast DDS does not load.
# For code that others use from C++, too, build without this file.
find_package(ament_cmake_core QUIET)

macro(ament_register_extension point package file)
  if(NOT ("${point}" STREQUAL "rosidl_generate_idl_interfaces" AND "${package}" MATCHES "_cpp$|_introspection_"))
    # The macro's own definition: CMake keeps an overridden command under its name with an underscore.
    _ament_register_extension("${point}" "${package}" "${file}")
  endif()
endmacro()
