"""Small facts that others have published, each with its source."""

import numpy as np
import pytest
from numpy.polynomial import Chebyshev, Polynomial

import granular_fronts as gf
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.studies.strikers import struck_chain

HERTZ, TOLERANCE = (1.5, 1.5, 0.0), {"relative": 1.0e-10, "absolute": 1.0e-12}


def test_restitution_is_the_series_of_viscoelastic_spheres():
    """Ramírez, Pöschel, Brilliantov and Schwager (1999), Phys. Rev. E 60, 4465.

    With the reduced mass 1/2 their x is (3/2) A (2k/m)^(2/5) v^(1/5), where A is our γ.  They print
    1.15344, 0.79826, 0.483582 and 0.285279, with alternating signs.  The first and the second are
    those of the equation, the second as 3/5 of the square of the first.  The others are not.
    """
    to_gamma = 1.0 / (1.5 * 2.0**0.4)

    def loss(x):
        return np.array([(gf.restitution(to_gamma * one) - 1.0) / one for one in x])

    series = Chebyshev.interpolate(loss, 9, [0.0, 0.35]).convert(kind=Polynomial)
    first, second, third, fourth = series.coef[:4] * [-1.0, 1.0, -1.0, 1.0]
    assert first == pytest.approx(1.15344, abs=1.0e-5)
    assert second == pytest.approx(0.79826, abs=1.0e-5)
    assert second == pytest.approx(0.6 * first**2, abs=1.0e-8)
    # With the printed one e would be larger by 0.0393 x³, which is 0.001 at x = 0.3.
    assert third == pytest.approx(0.522883, abs=1.0e-6)
    assert fourth == pytest.approx(0.348743, abs=1.0e-5)


@pytest.mark.parametrize("strikers", [1, 3])
def test_so_many_beads_that_hit_a_chain_make_so_many_solitary_waves(strikers):
    """Phys. Rev. E 67, 066607 (2003), abstract.

    Their speeds go like the sixth root of their forces, Nesterenko (1984); the factor is that of
    the exact wave, not of the long one, (4/5)^(1/2).
    """
    sensor = {"contacts": [50, 60], "start": 0.0, "stop": 110.0, "step": 0.05}
    record = {"snapshots": [], "sensors": {"two": sensor}}
    scene = struck_chain(HERTZ, 120, 110.0, TOLERANCE, record)
    scene["start"] |= {"velocity": 1.0, "beads": strikers}
    found = gf.pulses(gf.simulate_chain(scene)["contact_force_two"], 0.1)
    speeds, forces = 10.0 / np.diff(found["arrival"], axis=1)[:, 0], found["peak"].values[:, 0]
    assert speeds.size == strikers
    assert (np.diff(forces) < 0.0).all()
    exact = solitary_wave(1.5).u.max() ** -0.25
    assert exact == pytest.approx(0.905516, abs=1.0e-6)
    near = 1.0e-4 if strikers == 1 else 3.0e-3
    assert speeds / forces ** (1.0 / 6.0) == pytest.approx(exact, rel=near)


def test_a_front_is_as_fast_as_the_fifth_root_of_the_velocity_of_its_piston():
    """By mass V = cδ and momentum cV = δ^(3/2), James (2021), eq. (14)."""
    beads, velocity, speed = 100, 0.32, 0.32**0.2
    scene = struck_chain((1.5, 1.5, 1.0), beads, beads / speed, TOLERANCE, {"snapshots": []})
    scene |= {"boundary": {"kind": "piston", "velocity": velocity}, "start": {"kind": "rest"}}
    scene["record"]["arrival_level"] = 0.5 * velocity**0.8
    assert float(gf.simulate_chain(scene)["front_speed"]) == pytest.approx(speed, rel=1.0e-3)
