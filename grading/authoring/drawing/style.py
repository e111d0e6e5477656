"""The one hand in which all figures are drawn: colours and fonts.

A sheet brings its own ground, so that it can be read on every page and on paper. The ground is light; where the page
says that its colour scheme is dark, as JupyterLab with the course's extension and the web edition do, it is dark, and
the other colours change with it. Colour is never alone in saying something: what is wrong is dashed and says so, and
what is code is set as code.
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
# The same on a dark page, with the same contrast.
DARK_GROUND, DARK_EDGE = '#181b20', '#4a515c'
DARK_INK = {
    'ink': '#e6e9ee',
    'muted': '#aab3bf',
    'blue': '#8fbaf3',
    'green': '#82d3a2',
    'orange': '#f2b36f',
    'red': '#ff9d93',
    'violet': '#cbb6f7',
}
DARK_FILL = {
    'ink': '#22272e',
    'muted': '#2b3038',
    'blue': '#1b2e4b',
    'green': '#173626',
    'orange': '#432f10',
    'red': '#492321',
    'violet': '#33294e',
}
DARK = {GROUND: DARK_GROUND, EDGE: DARK_EDGE}
DARK |= {INK[name]: DARK_INK[name] for name in INK} | {FILL[name]: DARK_FILL[name] for name in FILL}
