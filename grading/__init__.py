"""The instructor's half of the course: authoring, hidden tests, grading, reports. Learners do not get it."""
