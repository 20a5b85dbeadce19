"""Colliding waves: symmetry, scaling, walls as mirrors, two methods, stated errors, controls."""

import numpy as np
import pytest

from granular_fronts.chain.simulate import simulate_once
from granular_fronts.fronts.solitary_waves import POINTS_PER_BEAD, solitary_wave, start_in_waves
from granular_fronts.studies.colliding_waves import (
    _read,
    energy_found,
    even_over_odd,
    find_collisions,
    lead,
    methods_apart,
    proportionality,
    share,
)

TOLERANCE = {"relative": 1e-10, "absolute": 1e-13}


@pytest.mark.parametrize("alpha", [1.3, 1.5, 2.0])
@pytest.mark.parametrize("centre", [20.0, 20.37, 20.5])
def test_sums_over_contacts_have_no_error_of_the_lattice(alpha, centre):
    """Poisson's formula, with a transform that has double zeros at 2πk."""
    beads, content = 42, solitary_wave(alpha).u.sum() / POINTS_PER_BEAD
    start = start_in_waves(alpha, beads, [(centre, 1.0)])
    u, places = np.array(start["relative_displacement"]), np.arange(1, beads)
    assert u.sum() == pytest.approx(content, rel=1e-10)
    assert places @ u / u.sum() == pytest.approx(centre, rel=1e-10)
    assert sum(start["velocity"]) == pytest.approx(content, rel=1e-10)
    # A negative control: the sum of squares is no integral.
    other = np.array(start_in_waves(alpha, beads, [(centre + 0.5, 1.0)])["relative_displacement"])
    assert abs(u @ u / (other @ other) - 1.0) > 1e-9


@pytest.fixture(scope="module")
def found():
    return find_collisions(1.5, [[1, 1], [2, 2], [1, 2]], [0, 0.25, 0.5, 0.75], TOLERANCE)


@pytest.mark.slow
def test_collisions_are_symmetric_and_scale(found):
    """The reflection of the chain exchanges places p and 1 − p, and both directions."""
    for name in ("shift", "speed_after", "secondary"):
        equal = found[name].sel(pair=0)
        for place in (0, 0.25, 0.5):
            right, left = equal.sel(direction=1), equal.sel(direction=-1)
            mirrored = left.sel(place=(1 - place) % 1).item()
            assert right.sel(place=place).item() == pytest.approx(mirrored, abs=1e-7), name
        np.testing.assert_allclose(equal, found[name].sel(pair=1), atol=1e-7)
    assert proportionality(found, 0).value == pytest.approx(1.0, abs=1e-6)
    # Waves that exchange energy are a negative control of the symmetry of both directions.
    assert abs(found["shift"].sel(pair=0, place=0.25).diff("direction").item()) > 0.02
    assert even_over_odd(found).value > 3.0


@pytest.mark.slow
def test_energy_and_momentum_of_both_sides_are_bounded_by_those_before(found):
    """Three waves have nearly all energy, and never more than there was."""
    for place in (0, 0.5):
        behind = sum(energy_found(found, name, place).value for name in ("secondary", "third"))
        assert 0.95 < behind < 1.0
        momenta = [
            share(found, name, "momentum", place).value for name in ("speed_after", "secondary")
        ]
        assert sum(momenta) > 1.01
    assert energy_found(found, "secondary", 0).value > 0.9
    assert energy_found(found, "third", 0.5).value > 0.1


@pytest.mark.slow
def test_the_lead_over_a_free_wave_is_where_its_content_is(found):
    """It is the place of the wave, by its speed and shift, less that of the free wave."""
    for pair, speed in ((0, 1.0), (1, 2.0), (2, 1.0)):
        one = found.sel(pair=pair, place=0, direction=1)
        place = one["speed_after"] * speed * (40.0 / speed) + one["shift"]
        assert lead(found, 40.0, 0, pair).value == pytest.approx(float(place) - 40.0, abs=1e-12)


@pytest.mark.slow
def test_momenta_and_times_of_peaks_give_the_same(found):
    for pair in range(3):
        for place in (0, 0.25, 0.5, 0.75):
            apart = methods_apart(found, "shift", "times", place, pair)
            assert abs(apart.value) < 2.0 * apart.error
            assert apart.error < 3e-4
            for name in ("shift", "speed_after", "secondary"):
                assert abs(methods_apart(found, name, "momenta", place, pair).value) < 1e-8
    for place in (0, 0.5):
        assert abs(methods_apart(found, "third", "momenta", place).value) < 1e-7


@pytest.mark.slow
@pytest.mark.parametrize(("alpha", "pair"), [(1.5, [1, 1.5]), (1.4, [1, 1])])
def test_stated_errors_are_those_to_a_finer_run(alpha, pair):
    usual, finer = (
        find_collisions(alpha, [pair], [0.2, 0.5], {"relative": one, "absolute": 1e-3 * one})
        for one in (1e-9, 1e-12)
    )
    for name in ("shift", "speed_after", "secondary"):
        largest = abs(usual[name] - finer[name]).max()
        assert 0.5 * largest < usual[f"{name}_error"].max() < 10.0 * largest, name
    apart = abs(usual["shift_by_times"] - usual["shift"].sel(direction=1))
    assert np.all(apart < usual["shift_by_times_error"])


@pytest.mark.slow
def test_a_wave_that_is_not_yet_by_itself_has_a_large_error():
    """A negative control, in which another wave runs within the one that is read."""
    found = find_collisions(1.4, [[1, 1.5]], [0.5], {"relative": 1e-9, "absolute": 1e-12})
    assert found["secondary_error"].min() > 1e-3
    assert found["shift_error"].max() < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize(("place", "factor"), [(0.0, 2.0**1.5), (0.5, 1.0)])
def test_a_wall_is_a_mirror(found, place, factor):
    """Half a chain before a wall, as stiff as a bead or as a contact of two, repeats the whole."""
    beads = 500
    start = start_in_waves(1.5, 2 * beads, [(beads + place - 24.0, 1.0)])
    scene = {
        "law": {"alpha": 1.5, "beta": 1.5, "gamma": 0.0},
        "beads": beads,
        "contacts": {"elastic": {"impurity": {"contact": beads, "factor": factor}}},
        "boundary": {"kind": "wall"},
        "start": {
            "kind": "given",
            "relative_displacement": start["relative_displacement"][:beads],
            "velocity": start["velocity"][:beads],
        },
        "end_time": 324.0,
        "tolerance": TOLERANCE,
        "record": {"snapshots": [324.0]},
    }
    motion = simulate_once(scene)
    u = np.maximum(motion["relative_displacement"].values[0, ::-1], 0.0)
    shown = _read(1.5, 1.0, u, -motion["velocity"].values[0, ::-1], 1.0 - place, 300.0, False)
    wanted = found.sel(pair=0, place=place, direction=1)
    for value, name in zip(shown, ("speed_after", "shift", "secondary", "third"), strict=True):
        assert value == pytest.approx(wanted[name].item(), abs=1e-7), name
