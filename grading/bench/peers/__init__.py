"""Other notebook graders, timed on the sheet of `grading.bench.timed_sheet`, as far as they can express it.

They have their usual settings: `nbgrader autograde` is called once for all submissions, `otter run` once for each, as
it takes only one; both grade one after the other. They run an answer and its test in one Python process, in real time
and without isolation (`otter grade`, which isolates, needs Docker). Their kernel is the course's, so that they find
rclpy. What they need is installed for the benchmark only, into build/bench/peers.
"""
