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


def test_overflow_at_the_start_is_reported():
    """The solver does not rely on the validation of scenes, which refuses such sizes."""
    scene = driven_scene(delta=1.0e250, end_time=1.0e10)
    with pytest.raises(SolveError, match=r"scene huge.*forces at t = 0 overflow.*scale"):
        solve(scene, scene["tolerance"], "scene huge")


def test_step_size_collapse_is_reported():
    """After a flight of unit duration the beads collide faster than double precision resolves t."""
    start = given([-1.0e77], [1.0e77, 0.0])
    scene = driven_scene(beads=2, delta=0.0, end_time=2.0, start=start)
    with pytest.raises(SolveError, match=r"scene fast.*At t = 1 the step size collapsed.*bead 1.*"):
        solve(scene, scene["tolerance"], "scene fast")
