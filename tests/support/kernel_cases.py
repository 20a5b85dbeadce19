"""Small problems, whose cases return the arrays that they solve for."""

import numpy as np
from chains import driven_scene, ring_scene, smooth_ring
from rings import scene_with

import granular_fronts as gf
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.continuum.log_burgers import solution as log_burgers
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import heteroclinic
from granular_fronts.scenes.ring import Ring

EVERYTHING = {
    "snapshots": [0.0, 2.0, 4.0],
    "probes": {"near": {"beads": [1, 3], "start": 0.5, "stop": 3.0, "step": 0.25}},
    "grid": {"step": 0.5},
    "extremes": True,
}
LOOSE = {"relative": 1e-4, "absolute": 1e-6}


def variables(dataset):
    return [each.values for _, each in sorted(dataset.items())]


def driven_chain():
    """Hertz's law, with every kind of recording and a refinement."""
    scene = driven_scene(0.1, 6, 4.0, delta=1.0, tolerance=LOOSE, record=EVERYTHING)
    return variables(simulate_chain(scene))


def ring_of_two_powers():
    """Powers that have no special form, on a ring."""
    scene = ring_scene(*smooth_ring(6), 0.1, 1.3, 1.1, 2.0, tolerance=LOOSE)
    return variables(simulate_chain(scene))


def log_burgers_in_time():
    """Both equations, from a plateau, whose cells are joined on the way."""
    scene, found = scene_with("hertz", half_beads=20, start__half_width=3), []
    for alpha in (1.0, 1.5):
        run = log_burgers.solve(
            Ring.read(scene), alpha, [6.0], 16, 1e-2, levels=1, smooth_cells=1.0
        )
        found.append(run.averages[0])
    return found


def heteroclinic_orbits():
    """Without, with weak and with strong damping, by Taylor series and by the slow manifold."""
    s = np.linspace(-3.0, 3.0, 7)
    orbits = [heteroclinic(mu, s) for mu in (0.0, 0.3, 2.0, 50.0)]
    return [values for orbit in orbits for values in variables(orbit)]


def fronts():
    """By the profile equation and by shooting, with one exponent and two; and a sweep."""
    found = [gf.solve_front(1.5, 0.65, beta) for beta in (1.5, 1.0)]
    found += [gf.solve_front(1.5, 0.4, method="shooting"), gf.sweep_fronts(1.5, [0.65, 0.6, 0.55])]
    return [values for front in found for values in variables(front)]


def multipliers():
    """Eigenvalues of the front, by LAPACK: rounding moves the small ones."""
    found = gf.front_multipliers(gf.solve_front(1.5, 0.3))
    return [found.values, found["rounding"].values]


CASES = (
    driven_chain,
    ring_of_two_powers,
    log_burgers_in_time,
    heteroclinic_orbits,
    fronts,
    multipliers,
)


def solve_cases(cases):
    """All arrays of some cases, by the name of the case and a number."""
    return {f"{case.__name__} {i}": each for case in cases for i, each in enumerate(case())}


def save(file, cases):
    np.savez(file, **solve_cases(cases))
