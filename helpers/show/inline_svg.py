"""Drawings in forms that JupyterLab shows in every notebook, trusted or not.

Inside of the page a drawing takes the page's colours, and tells more when the mouse is over it. But JupyterLab removes
SVG elements (not their words) from outputs of a notebook that it does not trust, such as one that somebody else has
run. It removes styles there, too, and keeps images: so a style decides which of two forms is seen. It has to be
`!important`, as JupyterLab has rules of its own for images.
https://jupyterlab.readthedocs.io/en/stable/user/notebook.html#trust
"""

import base64
import hashlib
from html import escape

PAGE_COLOUR = 'color: var(--jp-ui-font-color1, currentColor)'  #: in the style of a drawing that is given to `html`
# An image does not know the page's colours, only whether they are dark: by the `color-scheme` of its element.
_CARD = (
    '<style>:root {color: #20262e; background: #fcfcfa} '
    '@media (prefers-color-scheme: dark) {:root {color: #e6e9ee; background: #181b20}}</style>'
)


def html(svg: str, width: float, alternative: str) -> str:
    """Return ``svg`` for the page, and as an image with the text ``alternative`` for notebooks without trust.

    :param svg: its root has a ``style`` with `PAGE_COLOUR` in it.
    :param width: the greatest one, in px.
    """
    root, end, rest = svg.replace(PAGE_COLOUR, '').partition('>')
    image = base64.b64encode(f'{root}{end}{_CARD}{rest}'.encode()).decode()
    name = 'drawing-' + hashlib.sha256(svg.encode()).hexdigest()[:12]  # the style of one output reaches all others
    return (
        f'<div hidden="hidden" class="{name}">{svg}</div>'
        f'<style>.{name} {{display: block !important}} .{name}-image {{display: none !important}}</style>'
        f'<img class="{name}-image" style="width: 100%; max-width: {width:g}px" alt="{escape(alternative)}" '
        f'src="data:image/svg+xml;base64,{image}"/>'
    )


def still(svg: str, alternative: str) -> dict[str, str]:
    """Return the forms, by MIME type, of a drawing that needs nothing of the page.

    JupyterLab shows `image/svg+xml` only in notebooks that it trusts; an image in HTML it shows in all of them.

    :param svg: its root has its width and height.
    :param alternative: the same in words.
    """
    image = base64.b64encode(svg.encode()).decode()
    return {
        'image/svg+xml': svg,
        'text/html': f'<img alt="{escape(alternative)}" src="data:image/svg+xml;base64,{image}"/>',
        'text/plain': alternative,
    }
