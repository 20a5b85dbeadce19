r"""Hard cases of contacts that open: collisions, free flight, and many events in a row.

A contact that opens or closes is a point where the force is not smooth; `chain.contact_events` ends
a step there.  Known in advance are

- the collision of two beads with :math:`\alpha = \beta = 1`, where
  :math:`\ddot u = -2(u + \gamma\dot u)` while they touch, so that they part with the fraction
  :math:`e^{-\gamma\pi/\omega}`, :math:`\omega = (2 - \gamma^2)^{1/2}`, of their relative velocity,
- momentum and energy, and the constant velocities of beads in flight.

A long motion after contact loss need not be predictable.  In the paper's chain (N = 420, γ = 0.06)
damping keeps the beads together, and nearby motions stay near.  For N = 20 and γ = 10⁻³ the free
bead goes on bouncing and nearby motions part exponentially.  No method in double precision can
follow one of them to t = 10⁴.  There only what holds for every motion can be asked for.

The dissipated power of a contact goes to zero like :math:`u^{\beta-1}`, less smoothly than the
force, whose kink the located steps make negligible.  The energy balance through openings is
therefore kept in the variables u and w (`chain.equations`), where it is as smooth as the force.
"""

import math

import numpy as np

from granular_fronts.accuracy import largest_difference, with_refinement
from granular_fronts.chain.simulate import solve
from granular_fronts.studies.chain_scenes import kuwabara_kono
from granular_fronts.studies.hard_cases import HardCase
from granular_fronts.studies.hard_cases.chain_cases import final_state, make_scene

FINER = {"relative": 1.0e-15, "absolute": 1.0e-17}
NO_PRESSURE = {"left": 0.0, "right": 0.0}


def solve_refined(scene):
    """The scene at its tolerance, and the largest change of u and ẋ at a hundredth of it."""
    solutions = with_refinement(
        lambda tolerance: solve(scene, tolerance), scene["tolerance"], FINER
    )
    differences = [
        largest_difference(*solutions.map(lambda solved, name=name: solved.dataset[name]))
        for name in FIELDS
    ]
    return solutions.usual, max(differences)


def many_contact_losses():
    """The paper's chain far beyond its figures: front, reflections, ejected beads, to t = 10⁴."""
    scene = make_scene(kuwabara_kono(1.5, 0.06), 420, 1.0e4, left=0.1)
    solution, difference = solve_refined(scene)
    return HardCase(
        problem="initiation, α = β = 3/2, γ = 0.06, δ = 0.1, N = 420, to t = 10⁴",
        expected="hundreds of openings and closings without loss of accuracy",
        criterion="change of u and ẋ at the end by a hundredth of the tolerance, and relative "
        "drifts of momentum and energy",
        quantity="steps cut at contacts",
        measured=float(solution.counts["steps_cut_at_contacts"]),
        error=max(difference, *solution.drifts.values()),
        limit=1.0e-11,
    )


def bouncing_bead():
    """Weak damping, short chain, t = 10⁴: the motion is chaotic, the balance laws still hold."""
    scene = make_scene(kuwabara_kono(1.5, 1.0e-3), 20, 1.0e4, left=0.1)
    solution, difference = solve_refined(scene)
    return HardCase(
        problem="initiation, α = β = 3/2, γ = 0.001, δ = 0.1, N = 20, to t = 10⁴",
        expected="chaotic bouncing: no state can be predicted, momentum and energy can",
        criterion="relative drifts of momentum and energy",
        quantity="change of u and ẋ at the end by a hundredth of the tolerance",
        measured=difference,
        error=max(solution.drifts.values()),
        limit=1.0e-12,
    )


def free_flight():
    """A squeezed chain with free ends flies apart; momentum stays zero and velocities constant."""
    scene = squeezed_chain() | {"end_time": 200.0}
    scene["record"] = {"snapshots": [100.0, 200.0]}
    solution, difference = solve_refined(scene)
    u, velocity = (solution.dataset[name].values for name in FIELDS)
    predicted = u[0, :-1] - 100.0 * np.diff(velocity[0])
    defects = velocity[1].sum(), velocity[1] - velocity[0], u[1, :-1] - predicted
    flying = u[:, :-1].max() < 0.0
    return HardCase(
        problem=f"{SQUEEZED}, to t = 200",
        expected="all contacts open, every bead in free flight, momentum zero",
        criterion="total momentum, changes of ẋ and of u against the flight from t = 100 on, and "
        "change by a hundredth of the tolerance",
        quantity="narrowest gap at t = 100",
        measured=float(-u[0, :-1].max()),
        error=max(difference, *largest(defects)) if flying else math.nan,
        limit=1.0e-11,
    )


def energy_of_openings():
    """The energy balance of the same chain while its contacts open one by one."""
    scene = squeezed_chain()
    solution = solve(scene)
    return HardCase(
        problem=f"{SQUEEZED}, to t = 100",
        expected="energy lost by the beads is the energy dissipated in the contacts",
        criterion="relative drift of the energy balance (6), in u and w",
        quantity="steps cut at contacts",
        measured=float(solution.counts["steps_cut_at_contacts"]),
        error=solution.drifts["energy_drift"],
        limit=1.0e-12,
    )


SQUEEZED = "squeezed chain, free ends, α = β = 3/2, γ = 0.06, N = 20"
FIELDS = ("relative_displacement", "velocity")


def squeezed_chain():
    """Twenty beads at rest, squeezed unevenly, with nothing to hold them."""
    start = 0.1 * (1.0 + 0.5 * np.sin(1.7 * np.arange(19))), np.zeros(20)
    return make_scene(kuwabara_kono(1.5, 0.06), 20, 100.0, **NO_PRESSURE, start=start)


def largest(defects):
    """Largest absolute value of each defect."""
    return [float(np.abs(defect).max()) for defect in defects]


def elastic_collision():
    """N = 2, γ = 0: two beads meet and exchange their velocities, whatever the force."""
    u, velocity, _ = final_state(collision(kuwabara_kono(1.5, 0.0)))
    return HardCase(
        problem="N = 2, γ = 0, α = 3/2, free ends, velocities 1 and 0, a gap of 1, to t = 20",
        expected="the beads exchange their velocities",
        criterion="distance of ẋ from (0, 1)",
        quantity="gap at the end",
        measured=-float(u[0]),
        error=float(np.abs(velocity - [0.0, 1.0]).max()),
        limit=2.0e-12,
    )


def dashpot_collision():
    """N = 2, α = β = 1: the force jumps when the beads touch; the closed solution is known."""
    gamma = 0.5
    _, velocity, _ = final_state(collision({"alpha": 1.0, "beta": 1.0, "gamma": gamma}))
    restitution = math.exp(-gamma * math.pi / math.sqrt(2.0 - gamma**2))
    exact = np.array([1.0 - restitution, 1.0 + restitution]) / 2.0
    return HardCase(
        problem=f"N = 2, α = β = 1, γ = {gamma}, free ends, velocities 1 and 0, a gap of 1, "
        "to t = 20",
        expected="in (x, ẋ) the force jumps at the first touch; restitution e^(−γπ/ω)",
        criterion="distance of ẋ from the closed solution",
        quantity="coefficient of restitution",
        measured=float(velocity[1] - velocity[0]),
        error=float(np.abs(velocity - exact).max()),
        limit=2.0e-12,
    )


def collision(law, gap=1.0):
    """Two free beads meet with a relative velocity of 1 after a time equal to their gap."""
    return make_scene(law, 2, 20.0, **NO_PRESSURE, start=([-gap], [1.0, 0.0]))


CASES = {
    "many_contact_losses": many_contact_losses,
    "bouncing_bead": bouncing_bead,
    "free_flight": free_flight,
    "energy_of_openings": energy_of_openings,
    "elastic_collision": elastic_collision,
    "dashpot_collision": dashpot_collision,
}
