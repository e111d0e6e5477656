# Let the linters that were found add their tests.
ament_execute_extensions(ament_lint_auto)
