# What the bash of `./course shell` reads at its start.
if [ -f ~/.bashrc ]; then . ~/.bashrc; fi
# What that sets for another ROS does not count, as it does not in a notebook. (-I: not from the folder it went to.)
. <("${COURSE_SETUP%/*}/bin/python" -I -m environment.setup.startup)
. "$COURSE_SETUP"
# Once more: the user's file may have put another Python before an entry that was there already.
PATH=${COURSE_SETUP%/*}/bin:$PATH
PS1="(course) $PS1"
