"""The one hand in which all figures are drawn: colours and fonts.

A sheet brings its own light ground, so that it reads the same on a light page, on a dark one and on paper. Colour is
never alone in saying something: what is wrong is dashed and says so, what is code is set as code.
"""

SANS = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif"
MONO = "ui-monospace, SFMono-Regular, Menlo, Consolas, 'DejaVu Sans Mono', monospace"
SIZE, NOTE = 15, 13.5  # of texts, and of notes to them: at 700 pixels, and a narrow page makes them smaller
LEAST = 12
GROUND, EDGE = '#fcfcfa', '#c9cdd3'
# Of texts and lines. Each has a contrast of more than 4.5 : 1 on the ground and on every fill.
INK = {
    'ink': '#20262e',
    'muted': '#555e6b',
    'blue': '#174f9e',
    'green': '#176239',
    'orange': '#8a4300',
    'red': '#a81e17',
    'violet': '#5b3a9e',
}
FILL = {
    'ink': '#ffffff',
    'muted': '#eef0f3',
    'blue': '#e3edfb',
    'green': '#e0f2e7',
    'orange': '#fdeedb',
    'red': '#fce5e3',
    'violet': '#ede6fa',
}
