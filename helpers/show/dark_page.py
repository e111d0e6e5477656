"""Drawings that change with the page: they are made with light colours, and say what those become on a dark page."""

from collections.abc import Mapping


def rules(drawing: str, colours: Mapping[str, str], within: str = '') -> str:
    """Return the CSS that gives a drawing its dark colours where the colour scheme of the page is dark.

    In an `<img>`, the scheme is that of the element, as its style `color-scheme` says.

    :param drawing: the text of its SVG elements; colours that it does not use get no rule.
    :param colours: light → dark, as they stand in the attributes `fill` and `stroke`.
    :param within: a selector of the drawing, for one that may stand in a page beside others.
    """
    changed = [
        f'{within} [{attribute}="{light}"] {{ {attribute}: {dark} }}'.lstrip()
        for light, dark in colours.items()
        for attribute in ('fill', 'stroke')
        if f'{attribute}="{light}"' in drawing
    ]
    return '\n'.join(['@media (prefers-color-scheme: dark) {', *changed, '}'])
