# What find_package(ament_cmake_auto) brings.
foreach(_part dependencies targets package)
  include("${ament_cmake_auto_DIR}/${_part}.cmake")
endforeach()
