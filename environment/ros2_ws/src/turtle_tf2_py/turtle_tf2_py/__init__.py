"""The programs of the tf2 tutorials: frames of turtles, and a turtle that follows a frame."""
