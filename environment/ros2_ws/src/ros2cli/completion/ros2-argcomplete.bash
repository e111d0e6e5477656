# Completion of `ros2` by the Tab key; argcomplete brings the command used here.
if command -v register-python-argcomplete > /dev/null; then
  eval "$(register-python-argcomplete ros2)"
elif command -v register-python-argcomplete3 > /dev/null; then
  eval "$(register-python-argcomplete3 ros2)"
fi
