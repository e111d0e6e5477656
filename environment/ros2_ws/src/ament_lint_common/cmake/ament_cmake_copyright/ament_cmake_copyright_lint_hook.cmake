file(GLOB_RECURSE _source_files FOLLOW_SYMLINKS
  "*.c" "*.cc" "*.cpp" "*.cxx" "*.h" "*.hh" "*.hpp" "*.hxx" "*.cmake" "*.py")
if(_source_files)
  message(STATUS "Added test 'copyright' to check source files copyright and LICENSE")
  ament_copyright()
endif()
