"""The course as web pages: each chapter executed and readable without a kernel, for everyone to see.

It is made for learners, so it holds no solutions: an exercise shows its stub, and no output of the exercise's cells.
"""
