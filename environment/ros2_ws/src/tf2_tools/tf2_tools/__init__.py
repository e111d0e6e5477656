"""Tools for looking at transforms."""
