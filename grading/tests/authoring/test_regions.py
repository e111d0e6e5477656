"""Solution regions: what the learner gets, what stays, and misplaced markers."""

import pytest

from grading.authoring import regions

CELL = """\
class Talker:
    # BEGIN SOLUTION
    # STUB: def __init__(self):
    # STUB:     self.count = None
    def __init__(self):
        self.count = 0
    # END SOLUTION

    def total(self):
        # BEGIN SOLUTION
        # STUB: return None
        return self.count
        # END SOLUTION"""


def test_the_solved_form_loses_only_the_markers():
    assert (
        regions.split(CELL).solved
        == """\
class Talker:
    def __init__(self):
        self.count = 0

    def total(self):
        return self.count"""
    )


def test_the_stub_has_a_placeholder_and_the_stub_lines_at_their_indentation():
    assert (
        regions.split(CELL).stub
        == """\
class Talker:
    # Your code here.
    def __init__(self):
        self.count = None

    def total(self):
        # Your code here.
        return None"""
    )


def test_lines_of_the_solved_form_know_their_place_in_the_source():
    result = regions.split(CELL)
    author = CELL.splitlines()
    assert [author[offset] for offset in result.solved_lines] == result.solved.splitlines()
    assert result.regions == 2


def test_a_cell_without_markers_is_the_same_in_both_forms():
    result = regions.split('a = 1\n\n# STUBBORN: no marker')
    assert result.solved == result.stub == 'a = 1\n\n# STUBBORN: no marker'
    assert result.regions == 0


def test_a_file_that_is_xml_has_the_markers_as_its_comments():
    cell = '<a>\n  <!-- BEGIN SOLUTION -->\n  # STUB: <c/>\n  <b/>\n  <!-- END SOLUTION -->\n</a>'
    result = regions.split(cell)
    assert result.solved == '<a>\n  <b/>\n</a>'
    assert result.stub == '<a>\n  <!-- Your code here. -->\n  <c/>\n</a>'
    assert regions.has_marker('<!-- END SOLUTION -->')


@pytest.mark.parametrize(
    ('lines', 'offset', 'message'),
    [
        (['a = 1', '# BEGIN SOLUTION', 'b = 2'], 1, 'BEGIN SOLUTION without # END SOLUTION'),
        (['a = 1', 'b = 2', '    # END SOLUTION'], 2, 'END SOLUTION without # BEGIN SOLUTION'),
        (['# BEGIN SOLUTION', '# BEGIN SOLUTION', '# END SOLUTION'], 1, 'inside a solution region'),
        (['<!-- BEGIN SOLUTION -->', '<b/>'], 0, 'BEGIN SOLUTION without # END SOLUTION'),
        (['# STUB: pass'], 0, 'outside of a solution region'),
    ],
)
def test_misplaced_markers_are_named_with_their_line(lines, offset, message):
    with pytest.raises(regions.MarkerError, match=message) as caught:
        regions.split('\n'.join(lines))
    assert caught.value.offset == offset
