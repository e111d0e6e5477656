"""What notebooks draw: views of robots and graphs, timelines, turtles, progress bars and tables."""
