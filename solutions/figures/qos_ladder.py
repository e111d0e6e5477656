"""Chapter 3: which offer serves which request, for two policies."""

from grading.authoring.drawing import NOTE, Sheet

ALT = (
    'Two ladders, one for reliability and one for durability. RELIABLE stands above BEST_EFFORT, TRANSIENT_LOCAL '
    'above VOLATILE. A publisher on a rung serves requests of the same rung and of those below. Only an offer '
    'from the lower rung for a request of the upper rung does not fit: BEST_EFFORT for RELIABLE, VOLATILE for '
    'TRANSIENT_LOCAL.'
)


def ladder(sheet, x, title, strong, weak):
    """Offers on the left, requests on the right."""
    sheet.text(x + 161, 24, title, bold=True)
    sheet.text(x + 65, 50, 'publisher offers', size=NOTE, colour='muted')
    sheet.text(x + 257, 50, 'subscription requests', size=NOTE, colour='muted')
    offers = [sheet.box(x, y, 130, 40, f'`{name}`', size=NOTE) for y, name in ((66, strong), (176, weak))]
    requests = [
        sheet.box(x + 192, y, 130, 40, f'`{name}`', size=NOTE, colour='violet')
        for y, name in ((66, strong), (176, weak))
    ]
    for offer, request in ((0, 0), (1, 1)):
        sheet.arrow(offers[offer], requests[request], colour='green')
    sheet.arrow(offers[0].on('right', 0.8), requests[1].on('left', 0.2), colour='green')
    sheet.arrow(offers[1].on('right', 0.2), requests[0].on('left', 0.8), colour='red', dashed=True)
    sheet.cross(x + 146, 162, size=7)  # beside the arrow that it does not mean


def draw():
    sheet = Sheet('Offer and request', height=290)
    ladder(sheet, 10, 'Reliability', 'RELIABLE', 'BEST_EFFORT')
    ladder(sheet, 360, 'Durability', 'TRANSIENT_LOCAL', 'VOLATILE')
    sheet.arrow((150, 254), (210, 254), colour='green')
    sheet.text(218, 254, 'fits', anchor='start', size=NOTE)
    sheet.arrow((290, 254), (350, 254), colour='red', dashed=True)
    sheet.cross(320, 254)
    sheet.text(358, 254, 'does not fit: no connection', anchor='start', size=NOTE)
    return sheet
