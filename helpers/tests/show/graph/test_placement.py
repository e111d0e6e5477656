"""Boxes in columns: what a reader expects of a layered picture."""

from helpers.show.graph.placement import Edge, NodeBox, place


def boxes(names, width=80.0, height=30.0):
    return {name: NodeBox(width, height) for name in names}


def test_arrows_lead_to_the_right_and_the_picture_is_as_large_as_what_is_in_it():
    placed = boxes('abc')
    edges = [Edge('a', 'b'), Edge('b', 'c', room_end=60.0)]
    width, height = place(placed, edges, 40.0, 10.0)
    assert [placed[name].x for name in 'abc'] == [40.0, 160.0, 340.0], 'a label widens the gap that it stands in'
    assert (width, height) == (380.0, 30.0)
    assert {placed[name].y for name in 'abc'} == {15.0}, 'a chain is straight'
    assert not any(edge.backward for edge in edges)


def test_one_edge_of_a_circle_leads_back():
    placed = boxes('abc')
    edges = [Edge('a', 'b'), Edge('b', 'c'), Edge('c', 'a')]
    place(placed, edges, 40.0, 10.0)
    assert [edge.backward for edge in edges] == [False, False, True]
    assert placed['a'].x < placed['b'].x < placed['c'].x
    assert len(edges[2].points) == 2, 'it passes the column between'


def test_boxes_do_not_overlap_and_edges_do_not_cross_without_need():
    placed = boxes(['p', 'q', 'x', 'y', 'z', 'alone'])
    edges = [Edge('p', 'z'), Edge('q', 'x'), Edge('q', 'y'), Edge('p', 'y')]
    place(placed, edges, 40.0, 10.0)
    for one in placed.values():
        for other in placed.values():
            assert one is other or one.x != other.x or abs(one.y - other.y) >= 40.0 - 1e-9
    order = sorted('xyz', key=lambda name: placed[name].y)
    assert order in (['x', 'y', 'z'], ['z', 'y', 'x'])
    assert (placed['p'].y < placed['q'].y) == (order[0] == 'z')
    assert placed['alone'].y > max(placed[name].y for name in 'pqxyz')


def test_nothing():
    assert place({}, [], 40.0, 10.0) == (0.0, 0.0)
