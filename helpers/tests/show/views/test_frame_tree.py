"""The tree of frames: poses by the latest transforms, the automatic fixed frame, and what is wrong."""

import numpy as np
import pytest

from helpers.show.views.frame_tree import FrameLink, Tree


def link(child: str, parent: str, x: float = 1.0, **more) -> FrameLink:
    return FrameLink(child, parent, static=False, values=((x, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)), **more)


def tree(*links: FrameLink) -> Tree:
    return Tree({one.child: one for one in links})


def test_poses_in_any_fixed_frame():
    half = np.sqrt(0.5)
    turned = FrameLink('hand', 'arm', False, values=((1.0, 0.0, 0.0), (0.0, 0.0, half, half)))
    one = tree(link('arm', 'base'), turned, link('tip', 'hand'), link('other', 'base', -1.0))
    np.testing.assert_allclose(one.poses('base')['tip'][:3, 3], (2.0, 1.0, 0.0), atol=1e-12)
    np.testing.assert_allclose(one.poses('hand')['other'][:3, 3], (0.0, 3.0, 0.0), atol=1e-12)
    np.testing.assert_allclose(one.poses('hand')['hand'], np.eye(4), atol=1e-12)
    assert one.poses('unknown') == {} and set(one.poses('tip')) == {'base', 'arm', 'hand', 'tip', 'other'}
    assert one.frames[0] == 'base' and one.problems('base') == []


def test_the_fixed_frame_is_the_root_of_the_largest_tree():
    assert tree().best_root() == ''
    assert tree(link('a', 'x'), link('b', 'y'), link('c', 'b')).best_root() == 'y'
    assert tree(link('a', 'x'), link('b', 'map')).best_root() == 'map'


def test_separate_trees_and_a_fixed_frame_that_is_not_there():
    one = tree(link('a', 'x'), link('b', 'y'), link('c', 'b'))
    assert one.problems('y') == ['no transform from [x], [a] to [y]: separate trees']
    assert set(one.poses('x')) == {'x', 'a'}
    assert one.problems('moon') == ['tf2 knows no frame [moon]: only what stands in it can be shown']


def test_a_loop():
    one = tree(link('a', 'c'), link('b', 'a'), link('c', 'b'), link('tail', 'c'), link('good', 'root'))
    [problem] = one.problems('root')
    assert problem == 'a loop: a → c → b → a' and set(one.poses('root')) == {'root', 'good'}
    assert set(one.looped) == {'a', 'b', 'c', 'tail'} and set(one.frames) == {'root', 'good', *one.looped}


@pytest.mark.parametrize('apart, several', [(0.1, True), (60.0, False)])
def test_two_parents_at_the_same_time(apart, several):
    one = tree(link('cup', 'table', arrival=100.0, parents={'hand': 100.0 - apart, 'table': 100.0}))
    assert one.problems('table') == (['[cup] has several parents: [hand], [table]'] if several else [])
