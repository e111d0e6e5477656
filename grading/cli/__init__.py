"""The instructor's commands of ``./course``; helpers.cli says how a command is made."""
