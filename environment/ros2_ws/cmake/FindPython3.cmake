# An interface package finds Python nine times, and each time CMake asks the interpreter anew, by up to seven processes.
# What was found for this directory, with all that is asked for now, stays as it is.
set(_found TRUE)
foreach(_component IN LISTS Python3_FIND_COMPONENTS)
  if(NOT Python3_${_component}_FOUND)
    set(_found FALSE)
  endif()
endforeach()
if(NOT _found OR NOT TARGET Python3::Interpreter)
  include(${CMAKE_ROOT}/Modules/FindPython3.cmake)
endif()
