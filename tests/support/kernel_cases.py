"""Small problems, whose cases return the arrays that they solve for."""

import numpy as np
from chains import driven_scene, ring_scene, smooth_ring
from potentials import fpu, toda
from rings import scene_with

import granular_fronts as gf
from granular_fronts.chain.fourier_ring import FourierRing, solve_fourier_ring
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.continuum.log_burgers import solution as log_burgers
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import heteroclinic
from granular_fronts.reference_methods import half_step
from granular_fronts.reference_methods.theta_method import integrate_from_rest
from granular_fronts.reference_methods.upwind import evolve_upwind
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


def chain_with_gaps():
    """Weak damping, where contacts open, with arrivals and the first peaks and gap."""
    record = {"snapshots": [20.0], "extremes": True, "arrival_level": 0.5}
    scene = driven_scene(0.02, 6, 20.0, delta=1.0, tolerance=LOOSE, record=record)
    return variables(simulate_chain(scene))


def chains_of_other_laws():
    """Toda's law with a dashpot, FPU's with two nonlinear forces, another power, and a piston."""
    dashpot = {"kind": "linear", "gamma": 0.3}
    piston = {"kind": "piston", "velocity": 0.1, "ramp": 1.0, "right": 0.0}
    scene = driven_scene(beads=6, end_time=2.0, tolerance=LOOSE)
    return [
        values
        for change in (
            {"law": gf.make_law(elastic=toda(0.7, 1.3), viscous=dashpot)},
            {"law": gf.make_law(elastic=fpu(1.0, -0.3, 0.2), viscous=toda(0.7, 1.3))},
            {"law": {"alpha": 2.5, "beta": 2.5, "gamma": 0.1}},
            {"boundary": piston},
        )
        for values in variables(simulate_chain(scene | change))
    ]


def ring_of_two_powers():
    """Powers that have no special form, on a ring."""
    scene = ring_scene(*smooth_ring(6), 0.1, 1.3, 1.1, 2.0, tolerance=LOOSE)
    return variables(simulate_chain(scene))


def ring_by_fourier_series():
    """A compressed wave of 16 points on a ring of 32 beads."""
    phase = 2.0 * np.pi * np.arange(16) / 16
    start = 1.0 + 0.1 * np.cos(phase), 0.1 * np.sin(phase)
    wave = solve_fourier_ring(FourierRing(1.5, 0.2, 32, 16), *start, np.array([1.0]), 1e-6)
    return [wave.relative_displacement, wave.velocity]


def theta_method():
    motion = integrate_from_rest(1.5, 6, 0.1, 0.0, 0.75, 0.2, 5)
    return [motion.u, motion.d]


def half_steps():
    motion = half_step.integrate(half_step.Chain(1.5, 1.2, 0.3, 0.1), *np.zeros((2, 6)), 0.05, 20)
    return [motion.x, motion.v]


def upwind():
    return [evolve_upwind(np.linspace(0.1, 1.0, 16), 5.0, 0.5).values]


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
    chain_with_gaps,
    chains_of_other_laws,
    ring_of_two_powers,
    ring_by_fourier_series,
    theta_method,
    half_steps,
    upwind,
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
