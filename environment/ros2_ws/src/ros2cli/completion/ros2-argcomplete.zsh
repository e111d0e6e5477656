# Completion of `ros2` by the Tab key; argcomplete's hook for zsh goes through bash's completion.
autoload -U +X compinit && compinit
autoload -U +X bashcompinit && bashcompinit
if command -v register-python-argcomplete > /dev/null; then
  eval "$(register-python-argcomplete ros2)"
elif command -v register-python-argcomplete3 > /dev/null; then
  eval "$(register-python-argcomplete3 ros2)"
fi
