"""The arguments of a substitution in a launch file that is no program."""

from collections.abc import Sequence


def counted(word: str, data: Sequence, least: int, most: int | None = None) -> Sequence:
    """
    Return the arguments of ``$(word …)``.

    :raises TypeError: if there are fewer than ``least`` or more than ``most``
    """
    most = least if most is None else most
    if not least <= len(data) <= most:
        wanted = str(least) if least == most else f'{least} to {most}'
        plural = '' if (least, most) == (1, 1) else 's'
        raise TypeError(f'{word} substitution expects {wanted} argument{plural}, got {len(data)}')
    return data
