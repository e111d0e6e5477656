# Leaves out the generators and type supports for C++ where interfaces are made for Python programs only. rclpy works on
# those for C (rmw_fastrtps_cpp reads the introspection of C, too, when it registers a type).
#
# An interface package that was built so installs this file, and whoever finds the package includes it: what stands upon
# it would look in vain for its C++ parts.
if(NOT COMMAND _ament_register_extension)
  find_package(ament_cmake_core QUIET)

  macro(ament_register_extension point package file)
    if(NOT ("${point}" STREQUAL "rosidl_generate_idl_interfaces" AND "${package}" MATCHES "_cpp$"))
      # The macro's own definition: CMake keeps an overridden command under its name with an underscore.
      _ament_register_extension("${point}" "${package}" "${file}")
    endif()
  endmacro()
endif()
# Those that came before.
list(FILTER AMENT_EXTENSIONS_rosidl_generate_idl_interfaces EXCLUDE REGEX "_cpp:")
