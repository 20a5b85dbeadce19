"""Where one configuration departs from another."""

import copy

import pytest

from granular_fronts.output.departures import departures, describe, physical_departures

SCENE = {
    "law": {"alpha": 1.5, "gamma": 0.06},
    "beads": 420,
    "tolerance": {"relative": 1e-13},
    "own_tolerance": 3,
    "record": {"snapshots": [450], "probes": {}},
}


def test_each_departure_is_named_with_both_values_in_the_order_of_the_reference():
    given = copy.deepcopy(SCENE)
    assert departures(given | {"beads": 420.0}, SCENE) == []
    given |= {"law": {"alpha": 1.5, "gamma": 0.21}, "tolerance": {"relative": 1e-9}, "end_time": 7}
    given["record"]["snapshots"] = [450, 500]
    given["own_tolerance"] = 5
    del given["beads"]
    found = departures(given, SCENE)
    assert found == [
        ("law.gamma", 0.21, 0.06),
        ("beads", None, 420),
        ("tolerance.relative", 1e-9, 1e-13),
        ("own_tolerance", 5, 3),
        ("record.snapshots", [450, 500], [450]),
        ("end_time", 7, None),
    ]
    assert physical_departures(given, SCENE) == [*found[:2], *found[3:]]
    assert describe(found).endswith("relative is 1e-09 instead of 1e-13; and 3 more")


@pytest.mark.parametrize(
    ("given", "keys"),
    [({"probes": {}}, []), ({}, ["probes"]), ({"probes": {"step": 1}}, ["probes", "probes.step"])],
)
def test_an_empty_mapping_differs_from_a_filled_one_and_from_none(given, keys):
    assert [key for key, *_ in departures(given, {"probes": {}})] == keys
