"""Chapter 6: a cup with two parents."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'A tree with the root world and its children table and gripper. Both the node of the table and that of the '
    'gripper publish where the cup is, so cup has two parents. Whoever spoke last wins: the cup is at (2.3, 0, 0) '
    'or at (5, 0, 1.1), in turns, and no exception is raised.'
)


def draw():
    sheet = Sheet('A frame with two parents', height=300)
    world = sheet.box(130, 20, 110, 40, '`world`')
    table = sheet.box(30, 120, 110, 40, '`table`')
    gripper = sheet.box(230, 120, 110, 40, '`gripper`')
    cup = sheet.box(130, 230, 110, 40, '`cup`', colour='red')
    for parent, child, place, side, wrong in (
        (world, table, 'x = 2', 'left', False),
        (world, gripper, 'x = 5, z = 1', 'right', False),
        (table, cup, 'x = 0.3', 'left', True),
        (gripper, cup, 'z = 0.1', 'right', True),
    ):
        points = [parent.towards(child.centre), child.towards(parent.centre)]
        colour = 'red' if wrong else 'muted'
        sheet.line(points, colour=colour, dashed=wrong)
        sheet.label(points, place, side=side, at=0.7 if parent is world else 0.5, colour=colour)
    sheet.text(540, 40, 'where is the cup in the world?', bold=True)
    for number, (who, place) in enumerate(
        (('table', '(2.3, 0, 0)'), ('gripper', '(5, 0, 1.1)'), ('table', '(2.3, 0, 0)'), ('gripper', '(5, 0, 1.1)'))
    ):
        y = 64 + 44 * number
        sheet.text(536, y + 17, f'`{who}` was last', anchor='end', size=NOTE)
        sheet.box(552, y, 120, 34, place, colour='red', size=NOTE, round=0)
    sheet.text(540, 254, 'It flickers, and there is no exception.', size=NOTE, colour='red')
    return sheet
