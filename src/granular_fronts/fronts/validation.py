"""Validate the arguments of fronts before anything is computed.

James (2021), section 2.  Every function returns plain numbers, or raises an `InputError`.
"""

import math

import numpy as np
import xarray as xr

from granular_fronts.arguments import instance, scalar, sequence
from granular_fronts.errors import InputError
from granular_fronts.model.laws import make_law

SAME = 1e-12  # by how much an untouched front may be off, over its spacing or its larger state


def check_law(alpha, gamma, beta=None):
    """Return the law of a front as three floats, beta = alpha by default."""
    alpha = check_alpha(alpha)
    gamma = scalar(
        "gamma",
        gamma,
        above=0.0,
        advice="a conservative chain whose V''' keeps one sign has no fronts, so give a damping",
    )
    return alpha, gamma, check_beta(alpha, beta)


def check_alpha(alpha):
    """Return the exponent alpha as a float above 1."""
    return scalar(
        "alpha",
        alpha,
        above=1.0,
        advice="a linear chain (alpha = 1) has no fronts, eq. (18), and for alpha < 1 the front "
        "runs the other way, eq. (21)",
    )


def check_beta(alpha, beta=None):
    """Return the exponent beta as a float of at least 1, alpha by default."""
    return scalar(
        "beta",
        alpha if beta is None else beta,
        least=1.0,
        advice="below 1 the damping force is not differentiable where a contact closes",
    )


def check_right_state(right_state):
    """Return the relative displacement ahead, as a float in [0, 1)."""
    return scalar(
        "right_state",
        right_state,
        least=0.0,
        below=1.0,
        advice="for alpha > 1 a front leaves the larger compression, here 1, behind it, eqs. (17) "
        "and (18)",
    )


def is_given_by_law(powers, parts):
    """Return whether a front is given by a law with states, and not by numbers of two powers."""
    powers, parts = (
        [name for name, value in form.items() if value is not None] for form in (powers, parts)
    )
    if powers and parts:
        raise InputError(
            f"{powers[0]} and {parts[0]} are given together: give either alpha and gamma, or a law "
            "with its states."
        )
    return bool(parts)


def check_given_law(law, states):
    """Return a law, and the strains R_b and R_a that its front joins."""
    for name, value in (("law", law), ("states", states)):
        if value is None:
            raise InputError(
                f"{name} is missing: a front of any law needs law and states=(R_behind, R_ahead)."
            )
    law = make_law(law)
    states = sequence("states", states, advice="give the strains R_behind and R_ahead")
    if states.size != 2:
        raise InputError(
            f"states holds {states.size} numbers, but a front joins two: give the strains "
            "R_behind and R_ahead."
        )
    return law, tuple(map(float, states))


def check_front_of_powers(front):
    """Return a front as data of two powers, from compression 1 into a chain at rest."""
    check_front(front)
    if not {"alpha", "beta", "gamma"} <= front.attrs.keys() or front.attrs.get("right_state"):
        raise InputError(
            f"front has the law {front.attrs.get('law')} and joins R = "
            f"{front.attrs.get('state_behind')} to {front.attrs.get('state_ahead')}. "
            "Multipliers are known only for two powers from compression 1 into a chain at rest: "
            "give such a front, scaled by eq. (30)."
        )
    return front


def check_grid(front):
    """Refuse a front that is not on the grid of its solution, from end to end."""
    if front["relative_displacement"].dims != ("xi",) or not front.sizes["xi"]:
        raise InputError(
            f"front has relative_displacement of shape {front['relative_displacement'].shape}, "
            "but must have points along xi alone: "
            "evaluate the front as it was solved, and thin, crop or shift the values."
        )
    xi, u = front["xi"].values, front["relative_displacement"].values
    spacing, middle = front.attrs.get("spacing", math.nan), int(np.argmin(np.abs(xi)))
    behind, ahead = (-front.attrs.get(f"state_{end}", math.nan) for end in ("behind", "ahead"))
    off_grid = np.abs(xi - spacing * (np.arange(xi.size) - middle)).max()
    off_state = np.abs(u[[0, middle, -1]] - [behind, 0.5 * (behind + ahead), ahead]).max()
    if rounded := [name for name, values in front.variables.items() if values.dtype == "float32"]:
        raise InputError(
            f"front holds {', '.join(rounded)} in single precision, but errors are stated for "
            "double: give the front as solve_front returns it."
        )
    if not (off_grid <= SAME * spacing and off_state <= SAME * max(abs(behind), abs(ahead))):
        raise InputError(
            f"front has {xi.size} points on xi, from {xi[0]:g} to {xi[-1]:g}, but solve_front "
            f"steps by {spacing:g} sites, from rest to rest, half-way at xi = 0. Evaluate the "
            "front as it was solved, and thin, crop or shift the values."
        )


def check_front(front):
    """Return a front as data, unless it says itself that it has not converged."""
    instance("front", front, xr.Dataset, "take one from solve_front")
    needed = {"relative_displacement", "velocity", "xi"}
    if missing := sorted(needed - {*front.attrs, *front.variables}):
        raise InputError(f"front has no {', '.join(missing)}: take a front from solve_front.")
    if not front.attrs.get("converged", 1):
        raise InputError(
            f"front has not converged ({front.attrs['reason']}): there is nothing to evaluate."
        )
    return front
