"""What may stand in the outputs of a solved notebook, and which differences between two runs do not count.

One list of patterns serves both: the build applies it to what it keeps, nbval to what it compares. A replacement
must be its own fixed point, or the kept output would change again under nbval.
"""

import re
from pathlib import Path

from nbformat import NotebookNode

MAX_BYTES = 1_000_000
FIELDS = {'stream': ('text',), 'error': ('evalue',)}
# Widgets live as long as their kernel: what is kept is the still that stands beside them.
WIDGET = 'application/vnd.jupyter.widget-view+json'
TEXT_TYPES = ('text/plain', 'text/html', 'text/markdown', 'text/latex')


def sanitizers(root: Path) -> list[tuple[str, str, str]]:
    """Return (name, regular expression, replacement) for what differs between machines and runs."""
    return [
        # A notebook runs in notebooks/ when it is built, in solutions/ when nbval compares it.
        ('folder', re.escape(str(root)) + r'/(?:solutions|notebooks)\b', '/course/notebooks'),
        ('checkout', re.escape(str(root)), '/course'),
        ('ipykernel_file', r'/tmp/ipykernel_\d+/\d+\.py', '/tmp/ipykernel_0/0.py'),
        ('temporary', r'/tmp/tmp[a-z0-9_]{8}\b', '/tmp/tmp00000000'),
        ('address', r'\b0x[0-9a-f]{6,16}\b', '0x0'),
        ('port', r'(127\.0\.0\.1|localhost):\d{4,5}', r'\1:0'),
        ('duration', r'\[(?:\d+min )?\d+(?:\.\d+)?s\b', '[… s'),  # colcon: Finished <<< package [1.28s]
        # Bounded, and only from a word's beginning: else a long line without @ takes minutes.
        ('email', r'(?<![\w.+-])[\w.+-]{1,64}@[\w-]{1,63}\.[\w.-]+', 'you@example.com'),
        ('pid', r'\b(pid|process)([ =]\[?)\d+', r'\1\g<2>0'),
        # A workspace tells what of an earlier run it has put aside.
        ('kept', r'What you made or changed in \w+ is kept: [^\n]*\n', ''),
        # ros2 launch names its folder of logs after ROS_HOME, the time, the host and the process.
        ('ros_log', r'(?<!\S)/\S*/\.?ros/log/[\w.-]+', '/home/you/.ros/log/0'),
    ]


def nbval_config(root: Path) -> str:
    """Return the sanitizers as the text of a file for ``nbval --nbval-sanitize-with``."""
    return '\n'.join(f'[{name}]\nregex: {regex}\nreplace: {replace}\n' for name, regex, replace in sanitizers(root))


def settle(notebook: NotebookNode, root: Path) -> None:
    """Bring the outputs of an executed notebook into the form that is kept, in place."""
    patterns = [(re.compile(regex), replace) for _, regex, replace in sanitizers(root)]

    def clean(text):
        for pattern, replace in patterns:
            text = pattern.sub(replace, text)
        return text

    for cell in notebook.cells:
        cell.metadata.pop('execution', None)
        if cell.cell_type == 'code':
            cell.outputs = _merged([output for output in cell.outputs if not _is_empty(output)])
        for output in cell.get('outputs', []):
            for key in FIELDS.get(output.output_type, ()):
                output[key] = clean(output[key])
            if 'traceback' in output:
                output.traceback = [clean(line) for line in output.traceback]
            output.get('data', {}).pop(WIDGET, None)
            for mime in TEXT_TYPES:
                if mime in output.get('data', {}):
                    output.data[mime] = clean(output.data[mime])


def _is_empty(output: NotebookNode) -> bool:
    """Whether nothing is left of it: a progress bar that has ended, say."""
    return output.output_type == 'display_data' and not any(output.data.values())


def _merged(found: list[NotebookNode]) -> list[NotebookNode]:
    """Join what one stream printed between two other outputs, stdout first; how a kernel splits them is chance.

    nbclient could do it, but takes minutes for a long line.
    """
    merged: list[NotebookNode] = []
    streams: dict[str, NotebookNode] = {}
    for output in found:
        if output.output_type != 'stream':
            merged += [streams[name] for name in sorted(streams, reverse=True)]
            streams = {}
            merged.append(output)
        elif output.name in streams:
            streams[output.name].text += output.text
        else:
            streams[output.name] = output
    return merged + [streams[name] for name in sorted(streams, reverse=True)]
