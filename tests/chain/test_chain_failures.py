"""A solve that cannot go on says when, where and why."""

import pytest
from chains import driven_scene, given, ring_scene, smooth_ring
from potentials import cosh

from granular_fronts.chain.simulate import simulate_chain, solve
from granular_fronts.errors import SolveError


def test_opening_contact_below_linear_is_refused():
    u, velocity = smooth_ring()
    scene = ring_scene(u, 20.0 * velocity, alpha=0.7, beta=1.0)
    with pytest.raises(
        SolveError, match=r"At t = .* contact of beads \d+ and \d+ opens.*alpha < 1"
    ):
        simulate_chain(scene, "soft")


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_strain_that_leaves_the_interval_of_its_law_is_named(sign):
    start = given([0.0], [10.0 * sign, -10.0 * sign])
    scene = driven_scene(beads=2, delta=0.0, start=start, law={"elastic": cosh()})
    with pytest.raises(SolveError, match=r"strain of contact 1 leaves the interval from -3 to 3"):
        simulate_chain(scene)


def test_step_size_collapse_is_reported():
    """After a flight of duration 10⁶ the beads collide faster than double precision resolves t."""
    start = given([-1.0e55], [1.0e49, 0.0])
    scene = driven_scene(beads=2, delta=0.0, end_time=2.0e6, start=start)
    scene["tolerance"] = {"relative": 1e-9, "absolute": 1e35}
    with pytest.raises(SolveError, match=r"scene fast.*At t = 1e\+06 the step size.*bead 1.*"):
        solve(scene, activity="scene fast")
