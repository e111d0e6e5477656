"""What the tests of exercise 2.3 look at: the types as Python and the tools see them, and what package.xml declares."""

from rosidl_adapter import parser

from helpers.checks.chapter_02 import builds
from helpers.runner import about, broken, expect

CHARGE = ['std_msgs/Header header', 'uint8 percent', 'boolean charging']
REQUEST, RESPONSE = ['string station', 'float speed'], ['boolean docked', 'string message']
# The words of an interface file, where Python has others
_WORDS = {'boolean': 'bool', 'float': 'float32', 'double': 'float64'}
_WORDS_OF_PYTHON = {text: python for python, text in _WORDS.items()}


def _written(fields: list[str]) -> str:
    """Fields as they stand in an interface file."""
    pairs = [field.split() for field in fields]
    return ', '.join(f'{_WORDS.get(kind, kind)} {name}' for kind, name in pairs) or 'none'


def _fields(found: dict, key: str) -> list[str]:
    return [f'{kind} {name}' for name, kind in found[key]]


def _written_in(learner) -> dict:
    """What the learner's two texts define, in the words of Python: nothing of the learner's runs for this.

    `builds.interface` tells what a program finds, and that program is the learner's, too.
    """

    def fields(part) -> list[list[str]]:
        return [[field.name, _WORDS_OF_PYTHON.get(str(field.type), str(field.type))] for field in part.fields]

    try:
        message = parser.parse_message_string('dock_interfaces', 'Charge', learner.text('MSG'))
        service = parser.parse_service_string('dock_interfaces', 'Dock', learner.text('SRV'))
    except Exception as error:  # noqa: BLE001 - of rosidl's parser: any
        raise broken(f'The text of an interface cannot be read: {str(error)[:300]}', 'both') from None
    request, response = service.request, service.response
    defaults = {field.name: field.default_value for field in (*request.fields, *response.fields)}
    return {
        'msg': fields(message),
        'request': fields(request),
        'response': fields(response),
        'FULL': next((one.value for one in message.constants if one.name == 'FULL'), None),
        'constants': [one.name for one in message.constants if one.name != 'FULL'],
        'request constants': [one.name for one in request.constants],
        'response constants': [one.name for one in response.constants],
        'begins': [field.name for field in message.fields if field.default_value is not None],
        'speed': defaults.pop('speed', None) or 0.0,
        'defaults': [name for name, value in defaults.items() if value is not None],
    }


def _found(learner) -> list[dict]:
    """What a program finds in the types, and what the texts define: both must be right."""
    return [builds.interface(learner)[0], _written_in(learner)]


def judge_charge(learner) -> None:
    """The fields of Charge (`charge`) and its constant (`full`)."""
    for found in _found(learner):
        _judge_charge(learner, found)


def _judge_charge(learner, found: dict) -> None:
    fields = _fields(found, 'msg')
    expect('uint8 FULL' not in fields, 'FULL is a field of Charge. A constant has a `=` and a value.', 'full')
    expect(
        sorted(fields) != sorted(CHARGE) or fields == CHARGE,
        f'The fields of Charge are in the order {_written(fields)}; expected {_written(CHARGE)}.',
        'charge',
    )
    expect(fields == CHARGE, f'The fields of Charge are {_written(fields)}; expected {_written(CHARGE)}.', 'charge')
    begins, more = found.get('begins', []), found.get('constants', [])
    expect(not begins, f'`{begins and begins[0]}` of Charge has a default value. None of its fields has one.', 'charge')
    expect(not more, f'Charge has another constant, {more and more[0]}. Only FULL is asked for.', 'full')
    expect(
        found['FULL'] is not None,
        'Charge has no constant FULL. A constant has a type, a name, `=` and a value.',
        'full',
    )
    expect(
        not isinstance(found['FULL'], str),
        f'Charge.FULL is the text {found["FULL"]!r}. A constant of the type uint8 is a number.',
        'full',
    )
    expect(
        found['FULL'] == 100 and not isinstance(found['FULL'], (str, bool)),
        f'Charge.FULL is {found["FULL"]!r}, expected 100. A constant needs `=`.',
        'full',
    )
    expect(isinstance(found['FULL'], int), f'Charge.FULL is {found["FULL"]}, a float; expected uint8.', 'full')
    lines = [line.partition('#')[0] for line in learner.text('MSG').splitlines()]  # a comment may name FULL, too
    kinds = [line.split()[0] for line in lines if line.partition('=')[0].split()[1:] == ['FULL']]
    expect(kinds == ['uint8'], f'The type of FULL is {", ".join(kinds)}, expected uint8.', 'full')


def judge_dock(learner) -> None:
    """The fields of Dock (`request`, `response`) and the default value (`default`)."""
    for found in _found(learner):
        _judge_dock(found)


def _judge_dock(found: dict) -> None:
    request, response = _fields(found, 'request'), _fields(found, 'response')
    expect(
        (sorted(request), sorted(response)) != (sorted(RESPONSE), sorted(REQUEST)),
        'Request and response of Dock are exchanged: what stands above `---` is the request.',
        'request',
    )
    for rule, fields, wanted in (('request', request, REQUEST), ('response', response, RESPONSE)):
        expect(
            sorted(fields) == sorted(wanted),  # in any order: the specification gives one for Charge only
            f'The fields of the {rule} of Dock are {_written(fields)}; expected {_written(wanted)}.',
            rule,
        )
        constants = found.get(f'{rule} constants', [])
        expect(
            not constants,
            f'The {rule} of Dock has a constant, {constants and constants[0]}. Only Charge has one, FULL.',
            rule,
        )
    expect(
        abs(found['speed'] - 0.2) < 1e-6,
        f'A new request has the speed {found["speed"]:g}, expected 0.2: write the default value after the name.',
        'default',
    )
    others = found.get('defaults', [])
    expect(not others, f'`{others and others[0]}` of Dock has a default value. Only speed has one.', 'default')
    expect(
        found.get('others', ['', False, '']) == ['', False, ''],
        f'A new Dock begins with {found.get("others")} in station, docked and message. Only speed has a default value.',
        'default',
    )


def _right(found: dict) -> bool:
    """Whether all fields are as they should be."""
    return all(
        sorted(_fields(found, key)) == sorted(wanted)
        for key, wanted in (('msg', CHARGE), ('request', REQUEST), ('response', RESPONSE))
    )


def judge_use(learner, others: bool = False) -> None:
    """Both types can be used by programs and tools: rule `both`; with `others`, also with values of every kind."""
    random = learner.random
    station = f'dock{random.randint(10, 99)}'
    cases = [[station, None, True, random.randint(1, 99), True]]
    if others:
        cases += [
            [f'Süd {random.randint(1, 9)}', random.randint(30, 90) / 100, False, random.choice((0, 255)), False],
            ['', -random.randint(30, 90) / 100, True, random.randint(100, 254), False],
        ]
        random.shuffle(cases)
    found, wire = builds.interface(learner, cases)
    if _right(found):
        expect(_right(_written_in(learner)), 'A program finds other fields than your two texts define.', 'both')
        wanted = [
            [f'{name} at {found["speed"] if speed is None else speed:.2f} m/s', docked, name, percent, charging]
            for name, speed, docked, percent, charging in cases
        ]
        expect(wire == wanted, f'A program that uses your types ended with: {found["last_line"]}', 'both')
    for name, shown in (('srv/Dock', '---'), ('msg/Charge', ''))[: 2 if others else 1]:
        done = builds.dock_interfaces(learner).once('ros2', 'interface', 'show', f'dock_interfaces/{name}')
        expect(
            'Unknown package' not in done.last_line,
            f'`ros2 interface show dock_interfaces/{name}` says: {done.last_line}. CMakeLists.txt ends with '
            'ament_package(): this line makes the package known to ROS.',
            'both',
        )
        expect(
            done.status == 0 and any(line.startswith(shown) for line in done.lines),
            f'`ros2 interface show dock_interfaces/{name}` ended with: {done.last_line}',
            'both',
        )


def judge_declared(learner) -> None:
    """What package.xml declares: rules `to-build`, `to-run` and `group`."""
    with about('to-build'):
        declared = builds.dependencies(learner, 'DOCK_XML')
    expect(
        'rosidl_interface_packages' in declared.get('member_of_group', ()),
        'package.xml does not say that it is a member of the group: it needs '
        '<member_of_group>rosidl_interface_packages</member_of_group>.',
        'group',
    )
    for name in ('ament_cmake', 'rosidl_default_generators', 'std_msgs'):
        expect(
            name in builds.to_build(declared),
            f'{name} is needed for the build; package.xml does not say so.',
            'to-build',
        )
    expect(
        'std_msgs' in builds.to_run(declared),
        'std_msgs is declared for the build only. Who uses your message needs it, too: depend, or exec_depend.',
        'to-run',
    )
    expect(
        'rosidl_default_runtime' in builds.to_run(declared),
        'rosidl_default_runtime is not declared for run time: on a machine without compilers the types cannot be used.',
        'to-run',
    )
