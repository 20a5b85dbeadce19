r"""One front by every method: profile equation, shooting, a driven chain, three continuum models.

Everything is shown in the frame δ = c = 1 with the phase u(0) = 1/2, where u is
`relative_displacement` and the velocity is in units of :math:`\delta^{(\alpha+1)/2}`.  The profile
method gives the reference on a regular grid of ξ.  Each other method is compared with it where
known: shooting on its own grid, the chain at beads, continuum fronts on ξ.

The driven chain is semi-infinite, at rest, and pressed on by δ = 1.  After many beads its front no
longer feels the sudden start; what is left of the transient decays only algebraically.  In units of
δ = c = 1 the strength of the viscous force is the γc of (30).

Each variable of another method carries its `distance` to the exact front, the largest absolute
difference over the window.  There is no freedom to shift in it, since all have the same phase.
"""

import numpy as np
import xarray as xr

from granular_fronts.accuracy import EPSILON, sampled_maximum
from granular_fronts.chain.simulate import simulate_chain, simulate_once
from granular_fronts.errors import NoFrontError
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.numerics.grids import regular_points
from granular_fronts.scenes.front import Front
from granular_fronts.studies.chain_scenes import kuwabara_kono, pressed_chain
from granular_fronts.studies.continuum_fronts import continuum_fronts

BEADS_AHEAD = 60
"""Beads between the one looked at and the free end, which the front has not reached by then."""

TOLERANCE = 1e-12, 1e-14

FIELDS = ("relative_displacement", "velocity")
CONTINUUM_METHOD = "a formula, or an orbit solved to a few units of the last digit"


def compare_front(scene, name="given"):
    """Solve a front by both exact methods and compare the approximations with it.

    Parameters
    ----------
    scene : mapping
        One entry of `scenes.front` of the configuration.
    name : str, optional
        What error messages call the scene.

    Returns
    -------
    xarray.Dataset
        `relative_displacement` and `velocity` on `xi` and, with a suffix, by each other method:
        `_shooting` on `xi_shooting`, `_driven` on `xi_driven`, each continuum front on `xi`.
        `<field>_difference` is the difference of the two exact methods on `xi_shooting`.
        `residual_history_<method>` on `iteration_<method>` belongs to the two exact methods.  The
        properties of the front are attributes, as in `solve_front`.

    Raises
    ------
    InputError
        If the scene is impossible.
    NoFrontError
        If one of the two methods does not converge.
    """
    scene = Front.read(scene, name)
    alpha, gamma, window = scene.law.alpha, scene.normalised_damping, scene.window
    front, shot = (_solve(alpha, gamma, method, name) for method in ("profile", "shooting"))
    xi = regular_points(window.start, window.stop, window.step)
    coordinate = {"xi": ("xi", xi, front["xi"].attrs)}
    dataset = xr.Dataset(coords=coordinate, attrs=front.attrs)
    for field in FIELDS:
        exact = evaluate_front(front, xi, field)
        errors = {key: front[field].attrs[key] for key in ("error_estimate", "error_method")}
        dataset[field] = ("xi", exact, errors)
    seen = shot.sel(xi=slice(xi[0], xi[-1])).rename(xi="xi_shooting")
    driven = drive_front(alpha, gamma, scene.driven_bead, name)
    driven = driven.sel(xi=slice(xi[0], xi[-1])).rename(xi="xi_driven")
    for method, other in (("shooting", seen), ("driven", driven)):
        for field in FIELDS:
            dataset[f"{field}_{method}"] = _with_distance(other[field], front, field)
    for field in FIELDS:
        exact = evaluate_front(front, seen["xi_shooting"].values, field)
        dataset[f"{field}_difference"] = seen[field] - exact
    for method, values in continuum_fronts(alpha, gamma, xi).items():
        for field, value in zip(FIELDS, values, strict=True):
            attributes = {"error_estimate": EPSILON, "error_method": CONTINUUM_METHOD}
            variable = xr.DataArray(value, {"xi": xi}, attrs=attributes)
            dataset[f"{field}_{method}"] = _with_distance(variable, front, field)
    for method, solution in (("profile", front), ("shooting", shot)):
        history = solution["residual_history"].rename(iteration=f"iteration_{method}")
        dataset[f"residual_history_{method}"] = history
    return dataset


def drive_front(alpha, gamma, bead, name="driven"):
    """Press on a chain at rest and look at the front when it has come to a bead n₀; γ is γc.

    `relative_displacement` and `velocity` on `xi` = n − n₀, with u = 1/2 at ξ = 0.
    """
    law, record = kuwabara_kono(alpha, gamma), {"snapshots": [], "arrival_level": 0.5}
    scene = pressed_chain(law, bead + BEADS_AHEAD, 1.1 * bead, TOLERANCE, record)
    moment = float(simulate_once(scene, name)["arrival_time"].sel(bead=bead))
    scene |= {"end_time": moment, "record": {"snapshots": [moment]}}
    snapshot = simulate_chain(scene, name).isel(t=0, drop=True)
    return snapshot.assign_coords(bead=snapshot["bead"] - bead).rename(bead="xi")


def _solve(alpha, gamma, method, name):
    front = solve_front(alpha, gamma, method=method)
    if not front.attrs["converged"]:
        raise NoFrontError(f"Scene {name}: no front by {method}: {front.attrs['reason']}.")
    return front


def _with_distance(variable, front, field):
    """Return a variable with its largest difference to the exact front."""
    (dimension,) = variable.dims
    exact = evaluate_front(front, variable[dimension].values, field)
    distance = sampled_maximum(np.abs(variable.values - exact))
    return variable.assign_attrs(distance=distance.value, distance_error=distance.error)
