# Included by project() of each package (CMAKE_PROJECT_INCLUDE). An interface package has five C++ type support
# libraries, each with one small source per type whose headers take a second to read: read them once for many.
cmake_language(DEFER CALL _share_headers_of_type_support)

function(_share_headers_of_type_support)
  foreach(kind c cpp fastrtps_c fastrtps_cpp)
    set(target ${PROJECT_NAME}__rosidl_typesupport_${kind})
    if(TARGET ${target})
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 64)
    endif()
  endforeach()
  # Its sources specialise templates that others of them use before: they cannot be one translation unit.
  set(target ${PROJECT_NAME}__rosidl_typesupport_introspection_cpp)
  if(TARGET ${target})
    target_precompile_headers(${target} PRIVATE
      <algorithm> <array> <memory> <string> <vector>
      <rosidl_runtime_cpp/bounded_vector.hpp>
      <rosidl_runtime_cpp/message_initialization.hpp>
      <rosidl_typesupport_introspection_cpp/field_types.hpp>
      <rosidl_typesupport_introspection_cpp/message_introspection.hpp>)
  endif()
endfunction()
