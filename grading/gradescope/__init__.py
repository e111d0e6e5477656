"""An autograder for Gradescope: the zip (`bundle`), its two scripts, and what the scripts run (`harness`).

The contract is https://gradescope-autograders.readthedocs.io/en/latest/specs/: `setup.sh` and `run_autograder` at the
root of the zip; its content is in /autograder/source, the learner's files are in /autograder/submission, and results go
to /autograder/results/results.json.
"""
