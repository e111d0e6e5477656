"""The reports that are made of one record: (folder, suffix of the file, function from Record to text)."""

from grading.reports import feedback, gradescope, junit

KINDS = (
    ('feedback', '.html', feedback.dumps),
    ('gradescope', '.json', gradescope.dumps),
    ('junit', '.xml', junit.dumps),
)
