"""Chapter 7: the questions from top to bottom, with their tools."""

from grading.authoring.drawing import NOTE, Sheet, stack

ALT = (
    'Six steps from top to bottom. Question 0: is this terminal the one that I think it is? Then the five '
    'questions: what runs, who talks to whom, same name, type and QoS, same domain, same time. Beside each '
    'question stands its tool. One goes on only with the answer.'
)
STEPS = (
    ('Is this terminal the one that I think it is?', '`which ros2`, `env`, `ros2 doctor`'),
    ('**What runs?**', '`ros2 node list`, `ros2 param get`'),
    ('**Who talks to whom?**', '`show_graph()`, `ros2 topic hz`'),
    ('**Same name, same type, same QoS?**', '`ros2 topic info --verbose`'),
    ('**Same domain?**', '`ROS_DOMAIN_ID`, discovery range'),
    ('**Same time?**', 'stamps, `use_sim_time`'),
)


def draw():
    sheet = Sheet('Five questions', height=390)
    layers = [(question, 'blue' if number else 'muted') for number, (question, _) in enumerate(STEPS)]
    boxes = stack(sheet, 56, 18, 344, layers, h=40, gap=20)
    for number, (box, (_, tool)) in enumerate(zip(boxes, STEPS, strict=True)):
        sheet.text(34, box.centre[1], str(number), bold=True)
        sheet.text(420, box.centre[1], tool, anchor='start', size=NOTE)
    for box, below in zip(boxes, boxes[1:], strict=False):
        sheet.arrow(box, below)
    sheet.text(350, 374, 'Do not go on before you have the answer.', size=NOTE)
    return sheet
