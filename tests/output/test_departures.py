"""Where one configuration departs from another."""

import copy

from granular_fronts.output.departures import departures

SCENE = {
    "law": {"alpha": 1.5, "gamma": 0.06},
    "beads": 420,
    "boundary": {"kind": "pressure", "left": 0.1},
    "record": {"snapshots": [450], "probes": {}},
}


def test_equal_scenes_have_no_departures_and_numbers_compare_by_value():
    assert departures(copy.deepcopy(SCENE), SCENE) == []
    assert departures({**SCENE, "beads": 420.0}, SCENE) == []


def test_each_departure_is_named_with_both_values_in_the_order_of_the_reference():
    asked = copy.deepcopy(SCENE)
    asked["law"]["gamma"] = 0.21
    asked["record"]["snapshots"] = [450, 500]
    asked["end_time"] = 7
    del asked["beads"]
    assert departures(asked, SCENE) == [
        ("law.gamma", 0.21, 0.06),
        ("beads", None, 420),
        ("record.snapshots", [450, 500], [450]),
        ("end_time", 7, None),
    ]


def test_an_empty_mapping_differs_from_a_filled_one_and_from_none():
    assert departures({"probes": {}}, {"probes": {}}) == []
    assert departures({}, {"probes": {}}) == [("probes", None, {})]
    assert departures({"probes": {"step": 1}}, {"probes": {}}) == [
        ("probes", None, {}),
        ("probes.step", 1, None),
    ]
