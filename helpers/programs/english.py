"""The language of programs whose output is kept, compared or searched: bash, `ls` and gcc speak the user's."""

ENGLISH = {
    'LC_ALL': 'C.UTF-8',
    'LANGUAGE': '',  # GNU gettext asks it first, even so; desktops set it
}
