"""Small problems that call every kernel; each case returns the arrays that it solves for."""

from importlib.util import find_spec

import numpy as np
from chains import driven_scene, ring_scene, smooth_ring
from kernels import mapped
from potentials import cosh, fpu, hertz, toda
from rings import scene_with

import granular_fronts as gf
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.fourier_ring import FourierRing, solve_fourier_ring
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.continuum.log_burgers import solution as log_burgers
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import heteroclinic
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.profile.equation import front_problem, power_problem
from granular_fronts.fronts.profile.solve import refine, solve_profile
from granular_fronts.fronts.shooting import equations
from granular_fronts.fronts.shooting.bead_flow import PowerLaw, spread_of
from granular_fronts.fronts.shooting.initial_guess import continuum_guess, fit
from granular_fronts.fronts.shooting.window import slow_roots
from granular_fronts.fronts.sweep import follow
from granular_fronts.model.laws import make_law
from granular_fronts.numerics import interpolation
from granular_fronts.numerics.banded_qr import solve_least_squares
from granular_fronts.numerics.polynomials import crossing
from granular_fronts.numerics.vector_functions import exponential, exponential_less_one
from granular_fronts.reference_methods import half_step, position_forms
from granular_fronts.reference_methods.theta_method import integrate_from_rest
from granular_fronts.reference_methods.upwind import evolve_upwind
from granular_fronts.studies.choice_of_variables import SCHEMES

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


def laws_of_users():
    """Functions of numpy, and an expression where SymPy is installed: a chain and fronts."""
    laws = [gf.make_law(elastic=cosh(), viscous={"kind": "linear", "gamma": 0.3})]
    if find_spec("sympy"):
        import sympy

        r = sympy.Symbol("r")
        quartic = gf.Potential.from_expression(r**2 / 2 - r**3 / 3, r, interval=(-3.0, 0.4))
        laws.append(gf.make_law(elastic=quartic, viscous={"kind": "linear", "gamma": 0.6}))
    chain = driven_scene(beads=6, end_time=2.0, tolerance=LOOSE) | {"law": laws[0]}
    problem = front_problem(laws[-1], -0.5, 0.0)
    return [*variables(simulate_chain(chain)), solve_profile(problem).s]


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


def powers():
    """Row maps of each special power, and of a potential that a user gives."""
    u, found = np.array([-1.0, 0.0, 0.3, 2.0]), []
    functions = lambda r: 0.5 * r * r, lambda r: 1.0 * r, lambda r: 1.0 + 0.0 * r
    given = gf.Potential(*functions, interval=(-3.0, 3.0))
    for alpha in (1.0, 1.5, 2.0, 2.5):
        found += [mapped(hertz(alpha), order, u) for order in (1, 2)]
    return [*found, *(mapped(given, order, u) for order in (1, 2))]


def interpolants():
    """Between the points of a grid, on them, and beyond its ends."""
    values = np.tanh(np.linspace(3.0, -3.0, 31))
    places = np.array([-50.0, 0.5, 7.0, 29.3, 80.0])
    return [
        interpolation.interpolate_all(values, places, 1.0, -1.0),
        np.array([interpolation.largest(values * (2.0 - values), 1.0, -3.0)]),
    ]


def vector_functions():
    x = np.linspace(-700.0, 700.0, 15)
    pairs = [(exponential(each), exponential_less_one(each)) for each in x]
    return [np.log(np.array(pairs)[:, 0]), np.array(pairs)[7:9, 1]]


def crossings():
    """Where polynomials meet a level: straight, bent so that Newton's step leaves, and flat."""
    polynomials = ([0.0, 1.0], [0.0, 0.01, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0], [0.0, 3.0, -3.0, 1.0])
    levels = (0.3, 0.5, 1.0 - 1e-9)
    return [np.array([crossing(np.array(c), level) for c in polynomials for level in levels])]


def positions():
    """(x, w) and (x, ẋ) by fixed, staged and controlled steps."""
    law, start = make_law(alpha=1.5, gamma=0.3), np.array([2.0, 0.0, 0.1, -0.1])
    found = []
    for form in (position_forms.XW, position_forms.XV):
        system = position_forms.make_system(form, law, Boundary(ring=False, left=0.1), 2)
        ring = position_forms.make_system(form, law, Boundary(ring=True), 2, 0.5)
        found += [
            position_forms.integrate_fixed(system, start, 0.05, 3),
            position_forms.integrate_fixed(ring, start, 0.05, 3),
            position_forms.integrate_by_stages(system, start, 0.05, 3, *SCHEMES["euler"]),
            position_forms.integrate_adaptive(system, start, 0.05, 0.5, 1e-5, 1e-7)[0],
        ]
    return found


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
        run = log_burgers.solve(scene, alpha, [6.0], 16, 1e-2, levels=1, smooth_cells=1.0)
        found.append(run.averages[0])
    return found


def heteroclinic_orbits():
    """Without, with weak and with strong damping, by Taylor series and by the slow manifold."""
    s = np.linspace(-3.0, 3.0, 7)
    orbits = [heteroclinic(mu, s) for mu in (0.0, 0.3, 2.0, 50.0)]
    return [values for orbit in orbits for values in variables(orbit)]


def tails():
    """Oscillating and monotone, with one real exponent and with three."""
    laws = ((1.5, 0.05), (1.5, 0.8), (1.05, 0.2), (3.0, 1.2), (1.001, 0.034))
    return [tail_roots(*law, count=count) for law in laws for count in (1, 3)]


def profile():
    """The profile equation from nothing, and the fronts of other dampings on its grid."""
    front = solve_profile(power_problem(1.5, 0.65, 1.5))
    return [front.s, *follow(front, refine(front), np.array([0.65, 0.6, 0.55, 0.5]))]


def profile_of_two_powers():
    return [solve_profile(power_problem(1.5, 0.65, 1.0)).s]


def shooting():
    """Flow over a bead-time, its derivatives, and one step by least squares; β = α and β < α."""
    return [values for beta in (1.5, 1.2) for values in one_step(PowerLaw(1.5, beta, 0.4))]


def one_step(law):
    """Residuals of the continuum front in a short window, and the step of Gauss and Newton."""
    bead = np.arange(-8, 4)
    roots = slow_roots(law.alpha, law.gamma, law.beta)
    state = fit(continuum_guess(law.alpha, law.gamma, law.beta, bead), bead)
    unknowns = equations.join(np.zeros(equations.count_modes(roots)), state)
    beads = equations.Window(law, bead.size, 9, 6, spread_of(law, 6, 1.0), roots)
    rows, stiffness = equations.residual(beads, unknowns)
    matrix, lower = equations.jacobian(beads, stiffness)
    return [rows, solve_least_squares(matrix, lower, unknowns.size, -rows)]


def multipliers():
    """Eigenvalues of the front, by LAPACK: rounding moves the small ones."""
    found = gf.front_multipliers(gf.solve_front(1.5, 0.3))
    return [found.values, found["rounding"].values]


CASES = (
    driven_chain,
    chain_with_gaps,
    chains_of_other_laws,
    laws_of_users,
    ring_of_two_powers,
    ring_by_fourier_series,
    powers,
    interpolants,
    vector_functions,
    crossings,
    positions,
    theta_method,
    half_steps,
    upwind,
    log_burgers_in_time,
    heteroclinic_orbits,
    tails,
    profile,
    profile_of_two_powers,
    shooting,
    multipliers,
)


def solve_cases(cases):
    """All arrays of some cases, by the name of the case and a number."""
    return {f"{case.__name__} {i}": each for case in cases for i, each in enumerate(case())}


def save(file, cases):
    np.savez(file, **solve_cases(cases))
