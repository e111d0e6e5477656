"""The charts of the chapters: what stands where."""

import matplotlib
import pytest

from helpers.show.charts import figure, show_charge, show_support

RELEASES = {'old': ('20.04', '2020-01', '2022-06'), 'new': ('24.04', '2022-07', '2027-12')}


@pytest.fixture(autouse=True)
def no_window():
    import matplotlib.pyplot as plt

    before = matplotlib.get_backend()
    plt.switch_backend('agg')
    with plt.rc_context():
        yield plt
    plt.close('all')
    plt.switch_backend(before)


def test_a_figure_is_empty_and_has_the_height_that_was_asked_for():
    axes = figure(1.5)
    assert list(axes.figure.get_size_inches()) == [7, 1.5]
    assert not axes.lines and not axes.patches


def test_bars_reach_from_the_first_month_to_the_end_of_the_last(no_window):
    show_support(RELEASES, '2022-07')
    axes = no_window.gca()
    assert [(bar.get_x(), bar.get_x() + bar.get_width()) for bar in axes.patches] == [
        (2020, pytest.approx(2022.5)),
        (2022.5, pytest.approx(2028)),
    ]
    assert [label.get_text() for label in axes.get_yticklabels()] == ['old (20.04)', 'new (24.04)']


@pytest.mark.parametrize(
    'month, green', [('2022-06', [True, False]), ('2022-07', [False, True]), ('2028-01', [False] * 2)]
)
def test_what_is_supported_in_the_month_is_green(no_window, month, green):
    show_support(RELEASES, month)
    colours = [bar.get_facecolor() for bar in no_window.gca().patches]
    assert [colour == matplotlib.colors.to_rgba('tab:green') for colour in colours] == green


def test_the_charge_is_red_while_it_charges_and_both_thresholds_are_lines(no_window):
    show_charge([(0.5, 'working'), (0.1, 'charging'), (0.3, 'charging')], low=0.2, full=0.9)
    axes = no_window.gca()
    red, green = (tuple(matplotlib.colors.to_rgba(f'tab:{name}')) for name in ('red', 'green'))
    assert [tuple(colour) for colour in axes.collections[0].get_facecolors()] == [green, red, red]
    assert [line.get_ydata()[0] for line in axes.lines] == [0.2, 0.9]
