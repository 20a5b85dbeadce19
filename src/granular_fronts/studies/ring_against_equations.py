r"""A wave on a ring of beads against its amplitude equations (James 2021, section 4.3).

The ring of N = 2p − 1 beads starts from the rescaled force :math:`y^0` of the scene,

.. math::

    u_n(0) = \delta\, y^0(\varepsilon(n-p))^{1/\alpha}, \qquad
    \dot x_n(0) = \delta^{(\alpha+1)/2}\, y^0(\varepsilon(n-p)),

and is integrated as a chain (26).  The equations (50) and (40) start from the same :math:`y^0`, and
give :math:`u_n` and :math:`\dot x_n` by (51) at :math:`\tilde\xi = \varepsilon(n - p - \tilde ct)`,
modulo the length of the ring.

Distances are taken over all N beads: `sup` is the largest absolute difference and `rms` the root
mean square, of the compressions :math:`u_{n,+}/\delta` and of :math:`\dot
x_n/\delta^{(\alpha+1)/2}`.  An equation for :math:`u^\alpha` cannot open a gap, so that gaps count
as no compression here.  Their depth is recorded separately.  In addition `floor` is what the
solvers contribute to `sup`.  It is the chain's error estimate plus the difference of the equation
to its refined run at the same beads and time (`evolution`).

The paper's own scheme is run too if the scene names its points.  The percentages that the paper
quotes contain its error.
"""

import numpy as np
import xarray as xr

from granular_fronts.accuracy import error_attributes
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.continuum.evolution import (
    ERROR_METHOD,
    LOGARITHMIC,
    UNLIMITED,
    solve_refined,
)
from granular_fronts.continuum.log_burgers.starts import make_start
from granular_fronts.numerics.grids import regular_points
from granular_fronts.reference_methods import upwind
from granular_fronts.scenes.ring import Ring
from granular_fronts.studies.chain_scenes import chain_scene, kuwabara_kono

SITES_PER_BEAD = 5
FLOOR_METHOD = "of the two solutions compared, carried through"


def compare_with_chain(scene, name="given"):
    """Solve a periodic scene as a chain and by the equations that it names, of (50) and (40).

    Parameters
    ----------
    scene : mapping
        One entry of `scenes.periodic` of the configuration.
    name : str, optional
        What error messages and progress bars call the scene.

    Returns
    -------
    xarray.Dataset
        The chain's `relative_displacement` and `velocity` on (t, bead) and on (t_grid, bead), and
        its extremes.  The fields of each equation are on (t, site), where a site is a bead number
        that need not be whole.  Distances and floors are on (t_grid).

    Raises
    ------
    InputError
        If the scene is impossible.
    SolveError
        If a solver stops.
    """
    scene = Ring.read(scene, name)
    dataset = simulate_chain(make_chain_scene(scene), name)
    for equation in (LOGARITHMIC, UNLIMITED):
        if getattr(scene.equations, equation):
            solved = _solve_equation(scene, equation, dataset)
            dataset = dataset.merge(solved, combine_attrs="no_conflicts")
    if scene.equations.upwind:
        dataset = dataset.merge(_solve_upwind(scene, dataset), combine_attrs="no_conflicts")
    return dataset


def make_chain_scene(scene):
    """Return the chain scene of a ring, with the start of section 4.3."""
    scaling, places = scene.scaling, start_positions(scene, bead_numbers(scene))
    force = make_start(scene.start).values(places, scene.half_length)
    return chain_scene(
        kuwabara_kono(scene.law.alpha, scene.law.gamma),
        scene.beads,
        {"kind": "ring"},
        scene.end_time,
        (scene.tolerance.relative, scene.tolerance.absolute),
        {**scene.record.plain(), "extremes": True, "balances": True},
        (scaling.displacement(force), scaling.velocity(force)),
    )


def bead_numbers(scene):
    """Return 1 … 2p − 1."""
    return np.arange(1, scene.beads + 1)


def start_positions(scene, site):
    """Return ξ = ε(n − p) of bead numbers that need not be whole."""
    return scene.scaling.epsilon * (np.asarray(site, dtype=float) - scene.half_beads)


def _solve_equation(scene, equation, chain):
    """Return what one equation says, and how far from it the chain is."""
    snapshots = np.asarray(scene.record.snapshots, dtype=float)
    grid = regular_points(0.0, scene.end_time, scene.record.grid.step)
    solutions = solve_refined(scene, equation, np.concatenate([snapshots, grid]))
    beads = bead_numbers(scene)
    site = np.linspace(beads[0], beads[-1], SITES_PER_BEAD * (beads.size - 1) + 1)
    drawn = np.arange(snapshots.size)
    compared = snapshots.size + np.arange(grid.size)
    curves = solutions.map(lambda solution: _forces(scene, solution, drawn, site))
    at_beads = solutions.map(lambda solution: _forces(scene, solution, compared, beads))
    dataset = xr.Dataset(coords={"t": snapshots, "t_grid": grid, "site": site, "bead": beads})
    for field, scale, convert in _fields(scene):
        curve = curves.map(convert)
        attributes = error_attributes(*curve, ERROR_METHOD)
        dataset[f"{field}_{equation}"] = (("t", "site"), curve.usual, attributes)
        distances = _distances(chain[f"{field}_grid"], *at_beads.map(convert), scale)
        for kind, distance in distances.items():
            dataset[f"{field}_{kind}_{equation}"] = distance
    facts = solutions.usual.facts()
    return dataset.assign_attrs({f"{equation}_{key}": value for key, value in facts.items()})


def _forces(scene, solution, rows, sites):
    """Return the rescaled force of an equation at bead numbers at the times of some rows."""
    scaling = scene.scaling
    shift = scaling.epsilon * scaling.frame_speed * solution.times[rows]
    xi = start_positions(scene, sites) - shift[:, None]
    return np.array([solution.rescaled_force(row, xi[i]) for i, row in enumerate(rows)])


def _fields(scene):
    """Return each field of the chain, its scale, and its map from a rescaled force (51)."""
    scaling = scene.scaling
    return (
        ("relative_displacement", scaling.delta, scaling.displacement),
        ("velocity", scaling.velocity_scale, scaling.velocity),
    )


def _distances(chain, values, finer, scale):
    """Distances of a chain's field to an equation's, and what both solvers contribute."""
    # A gap counts as no compression; velocities keep their sign.
    found = chain.values if chain.name.startswith("velocity") else np.maximum(chain.values, 0.0)
    difference = np.abs(found - values) / scale
    floor = (chain.attrs["error_estimate"] + np.abs(values - finer).max(axis=1)) / scale
    attributes = {"error_estimate": float(floor.max()), "error_method": FLOOR_METHOD}
    kinds = {
        "sup": difference.max(axis=1),
        "rms": np.sqrt((difference**2).mean(axis=1)),
        "floor": floor,
    }
    return {kind: ("t_grid", distance, attributes) for kind, distance in kinds.items()}


def _solve_upwind(scene, dataset):
    """Return what the paper's scheme says of (50), on its own points, at the snapshot times."""
    scaling, half_length = scene.scaling, scene.half_length
    xi = upwind.grid(half_length, scene.equations.upwind.points)
    values, passed, rows = make_start(scene.start).values(xi, half_length), 0.0, {}
    for t in sorted(scene.record.snapshots):
        if t > passed:
            end = scaling.slow_rate * (t - passed)
            values, passed = upwind.evolve_upwind(values, half_length, end).values, t
        moved = scaling.epsilon * scaling.frame_speed * t
        positions = start_positions(scene, dataset["site"]) - moved
        rows[t] = np.interp(positions, xi, values, period=2.0 * half_length)
    force = np.array([rows[t] for t in scene.record.snapshots])
    solved = xr.Dataset(coords={"t": dataset["t"], "site": dataset["site"]})
    for field, _, convert in _fields(scene):
        accurate, curve = dataset[f"{field}_{LOGARITHMIC}"], convert(force)
        attributes = {
            "error_estimate": float(np.abs(accurate.values - curve).max()),
            "error_method": "largest difference to the sixth-order finite volumes",
        }
        solved[f"{field}_upwind"] = (("t", "site"), curve, attributes)
    return solved
