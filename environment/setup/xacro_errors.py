"""What xacro needs to tell an error: it names `xml.parsers.expat`, which nothing imports before a file is read."""

from xml.parsers import expat  # noqa: F401
