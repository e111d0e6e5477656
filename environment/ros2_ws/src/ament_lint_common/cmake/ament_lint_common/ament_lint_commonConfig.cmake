# Finds all common linters. One whose <name>_FOUND is set already is left out: so a package turns a linter off.
set(ament_lint_common_FOUND_AMENT_PACKAGE TRUE)
set(ament_lint_common_VERSION "0.17.3")

foreach(_ament_lint_common_linter copyright cppcheck cpplint flake8 lint_cmake pep257 uncrustify xmllint)
  if(NOT ament_cmake_${_ament_lint_common_linter}_FOUND)
    find_package(ament_cmake_${_ament_lint_common_linter} QUIET REQUIRED)
  endif()
endforeach()
