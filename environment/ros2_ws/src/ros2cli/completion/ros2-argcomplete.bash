# Completion of `ros2` by the Tab key. The first Tab asks argcomplete for it: asking takes as long as a `ros2 --help`,
# and most terminals that source this file never need it.
_ros2_first_completion() {
  local register
  for register in register-python-argcomplete register-python-argcomplete3; do
    if command -v "$register" > /dev/null; then
      eval "$("$register" ros2)"
      return 124 # bash begins anew, with what has been registered
    fi
  done
}
if command -v register-python-argcomplete > /dev/null || command -v register-python-argcomplete3 > /dev/null; then
  complete -o nospace -o default -o bashdefault -F _ros2_first_completion ros2
fi
