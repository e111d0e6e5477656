"""YAML that somebody has written by hand: whatever is wrong with it is one kind of error."""

import yaml


def read(text: str) -> object:
    """The value that a text holds, of plain types only.

    :raises yaml.YAMLError: it holds none. The parser itself raises other types, too, as for a date that there is not, a
        number of thousands of digits, or a list that is nested a thousand times.
    """
    try:
        return yaml.safe_load(text)
    except yaml.YAMLError:
        raise
    except RecursionError:
        raise yaml.YAMLError('it is nested too deeply') from None
    except Exception as error:
        raise yaml.YAMLError(f'a value in it is none: {error}') from None
