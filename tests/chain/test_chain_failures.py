"""A solve that cannot go on says when, where and why."""

import pytest
from chains import driven_scene, given, ring_scene, smooth_ring
from potentials import cosh

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import SolveError

U, VELOCITY = smooth_ring()
# After a flight of duration 10⁶ the beads collide faster than double precision resolves t.
FAR = {"start": given([-1.0e55], [1.0e49, 0.0]), "end_time": 2.0e6}
FAR |= {"tolerance": {"relative": 1e-9, "absolute": 1e35}}
FAST = [{"start": given([0.0], [v, -v]), "law": {"elastic": cosh()}} for v in (10.0, -10.0)]
LEAVES = r"strain of contact 1 leaves the interval from -3 to 3"


@pytest.mark.parametrize(
    ("scene", "sentence"),
    [
        (
            ring_scene(U, 20.0 * VELOCITY, alpha=0.7, beta=1.0),
            r"scene one.*At t = .* contact of beads \d+ and \d+ opens.*alpha < 1",
        ),
        *[(driven_scene(beads=2, delta=0.0, **one), LEAVES) for one in FAST],
        (driven_scene(beads=2, delta=0.0, **FAR), r"At t = 1e\+06 the step size.*bead 1"),
    ],
)
def test_what_cannot_be_solved_is_named(scene, sentence):
    with pytest.raises(SolveError, match=sentence):
        simulate_chain(scene, "one")
