"""Colours that say good, bad or open; each can be read on light and on dark pages."""

GOOD, BAD, OPEN = '#2e9d4e', '#d6453d', '#c98a00'
