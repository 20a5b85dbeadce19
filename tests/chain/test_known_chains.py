"""Chains against exact waves, collisions in pairs, and a pulse that opens all contacts."""

import numpy as np
import pytest
from chains import FREE, STRIKER, TIGHT, driven_scene, given

import granular_fronts as gf
from granular_fronts.chain.simulate import solve
from granular_fronts.fronts.solitary_waves import solitary_wave


def free_scene(beads, start, end_time, **changes):
    """A conservative chain that nothing holds."""
    changes = {"boundary": FREE, "start": start, "end_time": end_time} | changes
    record = {"snapshots": [end_time], "balances": True}
    return driven_scene(**({"beads": beads, "gamma": 0.0, "record": record} | changes))


def test_a_struck_chain_carries_the_exact_solitary_wave():
    """The wave of speed c is c⁴ times the wave of speed 1."""
    record = {"snapshots": [60.0], "arrival_level": 0.05, "extremes": True}
    tolerance = {"relative": 1.0e-12, "absolute": 1.0e-14}
    motion = solve(free_scene(80, STRIKER, 90.0, record=record), tolerance).dataset
    first, last = motion["first_peak_time"].sel(bead=[50, 70]).values
    speed, wave = 20.0 / (last - first), solitary_wave(1.5, 64)
    peak = float(motion["first_peak"].sel(bead=60))
    assert peak == pytest.approx(speed**4 * wave.u.max(), rel=1.0e-11)
    u = motion["relative_displacement"].isel(t=0)
    passed = motion["first_peak_time"].sel(bead=60) + (u["bead"] - 60.0) / speed
    near = np.abs(speed * (passed - 60.0)) < 4.0
    xi = speed * (60.0 - passed)[near]
    modes = np.fft.rfft(wave.u) / wave.u.size
    phases = (
        2.0j * np.pi * np.fft.rfftfreq(wave.u.size, 1.0 / 64.0) * (xi.values[:, None] - wave.xi[0])
    )
    exact = 2.0 * (modes * np.exp(phases)).real.sum(axis=1) - modes[0].real
    np.testing.assert_allclose(u[near], speed**4 * exact, rtol=0, atol=1.0e-10)


def by_pairs(masses, gaps):
    """Velocities after bead 1, of velocity 1, has hit the others in pairs; number of hits."""
    masses, gaps, count = np.array(masses), np.array(gaps), 0
    velocity = np.append(1.0, np.zeros(masses.size - 1))
    while ((closing := -np.diff(velocity)) > 0.0).any():
        times = np.where(closing > 0.0, gaps / np.maximum(closing, 1.0e-300), np.inf)
        pair, count = int(np.argmin(times)), count + 1
        gaps = gaps - closing * times[pair]
        two = slice(pair, pair + 2)
        velocity[two] = 2.0 * (masses[two] @ velocity[two]) / masses[two].sum() - velocity[two]
    return velocity, count


@pytest.mark.parametrize(
    ("masses", "gap", "count"),
    [
        ((1, 1e-4, 1e-4), 40, 3),
        ((1, 0.02, 1), 4000, 15),
    ],
)
def test_three_beads_at_a_distance_collide_in_pairs(masses, gap, count):
    """Elastic collisions one after the other; a light bead bounces between the two others."""
    expected, collisions = by_pairs(masses, [0.5, gap])
    assert collisions == count
    start = given([-0.5, -gap], [1.0, 0.0, 0.0])
    scene = free_scene({"count": 3, "mass": {"list": masses}}, start, 3.0 * gap)
    velocity = gf.simulate_chain(scene)["velocity"]
    error = np.abs(velocity.values[-1] - expected).max()
    assert error < 2.0 * velocity.attrs["error_estimate"] < 1.0e-11


def test_three_hundred_contacts_open_behind_a_pulse_in_a_taper():
    beads = {"count": 301, "mass": {"taper": {"ratio": 0.99}}}
    scene = free_scene(beads, STRIKER, 420.0, tolerance={"relative": 1.0e-9, "absolute": 1.0e-11})
    exact = solve(scene | {"record": scene["record"] | {"extremes": True}}, TIGHT)
    assert np.isfinite(exact.recording.opening[1, 1:301]).sum() == 300
    motion = gf.simulate_chain(scene)
    for name in ("relative_displacement", "velocity"):
        error = np.abs(motion[name] - exact.dataset[name]).max()
        assert 0.5 < motion[name].attrs["error_estimate"] / error < 2.0
    assert motion.attrs["momentum_drift"] < 1.0e-11
    assert exact.drifts["energy_drift"] < 1.0e-11
