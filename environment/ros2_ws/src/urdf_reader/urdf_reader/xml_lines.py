"""XML elements that know their line."""

from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

from urdf_reader.model import UrdfError


def parse(text: str) -> tuple[Element, dict[Element, int]]:
    """
    Return the root element of an XML text, and the line of each element, from 1.

    :raises UrdfError: the text is no XML.
    """
    builder, lines = TreeBuilder(), {}
    parser = expat.ParserCreate()

    def start(tag, attributes):
        lines[builder.start(tag, attributes)] = parser.CurrentLineNumber

    parser.StartElementHandler = start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.data
    try:
        parser.Parse(text, True)
    except expat.ExpatError as error:
        if not text.strip():
            raise UrdfError('the robot description is empty') from None
        raise UrdfError(f'line {error.lineno}: this is no XML: {expat.ErrorString(error.code)}') from None
    return builder.close(), lines
