"""Exercises: where their cells are in a notebook, and the list of all of them."""
