"""YAML that somebody has written by hand: whatever is wrong with it is one kind of error.

A number is what is written as one, and `true`, `false` and `null` are the only words that are no texts. YAML itself
takes `0123` for 83, `12_34` for 1234, `1:30` for 90 and `no` for false: then an id is another learner's.
"""

import re

import yaml

_WORDS = {
    'tag:yaml.org,2002:bool': (r'true|false', 'tf'),
    'tag:yaml.org,2002:null': (r'null|~|', 'n~'),
    'tag:yaml.org,2002:int': (r'[-+]?(?:0|[1-9][0-9]*)', '-+0123456789'),
    'tag:yaml.org,2002:float': (r'[-+]?(?:0|[1-9][0-9]*)\.[0-9]*|[-+]?\.inf|\.nan', '-+0123456789.'),
}
_KEPT = 'tag:yaml.org,2002:timestamp', 'tag:yaml.org,2002:merge'


class _Loader(yaml.SafeLoader):
    """Plain types; each key is a text, and stands in its table once."""

    yaml_implicit_resolvers = {
        sign: [(tag, pattern) for tag, pattern in found if tag in _KEPT]
        for sign, found in yaml.SafeLoader.yaml_implicit_resolvers.items()
    }

    def construct_mapping(self, node, deep=False):
        seen: set[str] = set()
        if not isinstance(node, yaml.MappingNode):
            return super().construct_mapping(node, deep)
        for key, _ in node.value:
            if not isinstance(key, yaml.ScalarNode):
                raise yaml.constructor.ConstructorError(None, None, 'found a key that is no text', key.start_mark)
            if key.tag == 'tag:yaml.org,2002:merge':
                continue
            key.tag = 'tag:yaml.org,2002:str'
            if key.value in seen:
                raise yaml.constructor.ConstructorError(
                    None, None, f'found {key.value!r} a second time', key.start_mark
                )
            seen.add(key.value)
        return super().construct_mapping(node, deep)


for _tag, (_pattern, _signs) in _WORDS.items():
    _Loader.add_implicit_resolver(
        _tag, re.compile(f'(?:{_pattern})$'), [*_signs, *([''] if _tag.endswith('null') else [])]
    )


def read(text: str) -> object:
    """The value that a text holds, of plain types only.

    :raises yaml.YAMLError: it holds none. The parser itself raises other types, too, as for a date that there is not, a
        number of thousands of digits, or a list that is nested a thousand times.
    """
    try:
        return yaml.load(text, _Loader)  # noqa: S506 - a safe loader
    except yaml.YAMLError:
        raise
    except RecursionError:
        raise yaml.YAMLError('it is nested too deeply') from None
    except Exception as error:
        raise yaml.YAMLError(f'a value in it is none: {error}') from None
