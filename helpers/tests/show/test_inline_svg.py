"""A drawing in a page, and the same as an image: what JupyterLab removes from a notebook that it does not trust."""

import base64
import re
from xml.etree import ElementTree

from helpers.show import inline_svg
from helpers.tests.show.contrast import contrast

SVG = f'<svg xmlns="http://www.w3.org/2000/svg" style="{inline_svg.PAGE_COLOUR}"><text>a word</text></svg>'


def test_the_image_is_the_drawing_with_colours_of_its_own():
    shown = ElementTree.fromstring(f'<div>{inline_svg.html(SVG, 300, "a <word>")}</div>')
    image = shown.find('img')
    drawn = base64.b64decode(image.get('src').partition(',')[2]).decode()
    svg = ElementTree.fromstring(drawn)
    style, word = svg
    assert (inline_svg.PAGE_COLOUR in drawn, word.text) == (False, 'a word')
    light, dark = (dict(re.findall(r'(color|background): (#\w{6})', part)) for part in style.text.split('@media'))
    assert '(prefers-color-scheme: dark)' in style.text
    assert contrast(light['color'], light['background']) > 7 < contrast(dark['color'], dark['background'])
    assert contrast(light['background'], '#ffffff') < 1.2 > contrast(dark['background'], '#111111')
    assert image.get('alt') == 'a <word>' and 'max-width: 300px' in image.get('style')


def test_without_its_style_only_the_image_is_seen():
    """What JupyterLab leaves without trust: elements that HTML knew before SVG, no style element, the words."""
    page = inline_svg.html(SVG, 300, 'words')
    kept = re.sub(r'<style>.*?</style>|</?(svg|text)[^>]*>', '', page)
    hidden = ElementTree.fromstring(f'<div>{kept}</div>').find('div')
    assert (hidden.text, hidden.get('hidden')) == ('a word', 'hidden')


def test_with_its_style_only_the_drawing_is_seen():
    page = inline_svg.html(SVG, 300, 'words')
    name = re.search(r'class="(drawing-[0-9a-f]+)"', page)[1]
    # JupyterLab's own rule for images in outputs, `.jp-RenderedHTMLCommon > img`, is more specific than a class.
    assert f'.{name} {{display: block !important}}' in page
    assert f'.{name}-image {{display: none !important}}' in page


def test_the_style_of_one_drawing_leaves_others_alone():
    names = {re.search(r'class="(\S+)"', inline_svg.html(svg, 300, ''))[1] for svg in (SVG, SVG.replace('word', 'x'))}
    assert len(names) == 2


def test_a_still_is_an_image_wherever_svg_is_not_shown():
    svg = '<svg xmlns="http://www.w3.org/2000/svg" width="2" height="1"/>'
    forms = inline_svg.still(svg, 'a "word"\n<another>')
    image = ElementTree.fromstring(forms['text/html'])
    assert image.tag == 'img' and image.get('alt') == 'a "word" <another>'  # XML reads a line break as a blank
    assert base64.b64decode(image.get('src').partition('data:image/svg+xml;base64,')[2]).decode() == svg
    assert (forms['image/svg+xml'], forms['text/plain']) == (svg, 'a "word"\n<another>')
