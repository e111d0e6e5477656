"""Other notebook graders, timed on the sheet of `grading.bench.sheet`, as far as they can express it.

They run an answer and its test in one Python process, in real time and without isolation. Their kernel is the course's,
so that they find rclpy. What they need is installed for the benchmark only, into build/bench/peers.
"""
