r"""A ball that falls on a plate, with and without a load g, and what others have published of it.

In units of its mass, of the stiffness and of the velocity of impact

.. math::

    \ddot x = g - x_+^\alpha - \gamma \frac{d}{dt} x_+^\beta, \qquad x(0) = 0, \quad \dot x(0) = 1 .

The ball leaves where x returns to 0, with the velocity −e.  Then only the load acts on it, so that
:math:`e^2 = \dot x^2 - 2 g x` until it is back.  This is more exact than the velocity at the
opening, where the force has a kink.

Two beads.  Without load two equal beads and the ball are one problem.  Their compression has the
reduced mass 1/2, and in its units :math:`\gamma = \gamma_{plate}/2^{1 - \beta/(\alpha+1)}`.

First order.  The undamped ball has :math:`\dot x^2 = 1 - y` with
:math:`y = 2 x^{\alpha+1}/(\alpha+1)`.  On its way in and out the dashpot takes
:math:`\tfrac12(1 - e^2) \approx 2\gamma\beta \int x^{\beta-1} (1 - y)^{1/2}\,dx`, hence

.. math::

    e = 1 - C_0\gamma + \dots, \qquad C_0 = \beta\Bigl(\frac{\alpha+1}{2}\Bigr)^{\nu-1}
        \mathrm B\bigl(\nu, \tfrac32\bigr), \qquad \nu = \frac{\beta}{\alpha+1} .
"""

import numpy as np
import xarray as xr
from scipy.special import beta as euler_beta

from granular_fronts.accuracy import Estimate, recorded, rounded, variable_and_errors
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import InputError
from granular_fronts.model.collision import restitution, weak_damping_slope
from granular_fronts.output.datasets import write_dataset
from granular_fronts.scenes.yaml_files import read_yaml
from job import job

END = 6.0
"""Time at which the ball is in flight."""

ERROR_OF_RESTITUTION = 1e-12
"""As `granular_fronts.model.collision` states it."""

SMALL = 5e-3 * 0.5 ** np.arange(5)
"""Dampings from which the slope of e is extrapolated to γ = 0."""


def falls(laws, loads, dampings, tolerance, statements):
    """Return e of all laws, loads and dampings beside what is published and what theory says.

    On (law, load, damping): `restitution`, and `published`, NaN where the statements have no point.
    On (law, damping): `two_beads`.  On (law): `slope` of e at γ = 0, and `first_order`, C₀.
    """
    found = [
        [[fall(law, load, gamma, tolerance) for gamma in dampings] for load in loads]
        for law in laws.values()
    ]
    pairs = [
        [(two_beads(law, gamma), ERROR_OF_RESTITUTION) for gamma in dampings]
        for law in laws.values()
    ]
    slopes = [slope_at_rest(law) for law in laws.values()]
    places = ("law", "load", "damping")
    variables = {}
    for name, dims, values, method, meaning in (
        ("restitution", places, found, "the error of the last state", "velocity of release, e"),
        ("two_beads", (places[0], places[2]), pairs, "as the collision states", "e of two beads"),
        ("slope", places[:1], slopes, "another extrapolation", "slope (1 − e)/γ as γ → 0"),
    ):
        variables |= variable_and_errors(name, dims, values, method, meaning)
    closed = np.array([first_order(**law) for law in laws.values()])
    variables["first_order"] = ("law", closed, {"long_name": "C₀ in closed form"})
    coordinates = {
        name: (name, list(of), {"long_name": words})
        for name, of, words in (
            ("law", laws, "law of the contact"),
            ("load", loads, "load g over mass"),
            ("damping", dampings, "strength γ of the viscous force"),
        )
    }
    coordinates |= {
        name: ("law", [law[name] for law in laws.values()], {"long_name": f"exponent {name}"})
        for name in ("alpha", "beta")
    }
    together = xr.Dataset(variables, coordinates)
    published = xr.full_like(together["restitution"], np.nan)
    for statement in read_yaml(statements):
        place = dict(statement.get("arguments", {}))
        is_point = place.pop("name", "") == "restitution"
        # Other settings may leave it out.
        if is_point and all(value in together[name].values for name, value in place.items()):
            published.loc[place] = float(statement["printed"])
    published.attrs = {
        "long_name": "e as published",
        "error_estimate": 5e-11,
        "error_method": "digits",
    }
    return together.assign(published=published)


def fall(law, load, gamma, tolerance):
    """Return e of a ball on a plate, from the energy it has in flight."""
    motion = simulate_chain(
        {
            "law": law | {"gamma": gamma},
            "beads": 1,
            "boundary": {"kind": "wall"},
            "gravity": load,
            "start": {"kind": "given", "relative_displacement": [0.0], "velocity": [1.0]},
            "end_time": END,
            "tolerance": tolerance,
            "record": {"snapshots": [END], "extremes": True},
        }
    )
    x, velocity = (
        recorded(motion[name].isel(t=-1, bead=0)) for name in ("relative_displacement", "velocity")
    )
    left, speed = float(motion["first_gap_time"]), -float(motion["first_gap_velocity"])
    if not load * (END - left) < 2.0 * speed:
        raise InputError(
            f"At t = {END:g} a ball with load {load:g} and damping {gamma:g} has not left the "
            "plate, or is back on it: lower load or damping."
        )
    return (velocity * velocity - x * (2.0 * load)) ** 0.5


def two_beads(law, gamma):
    """Return e of two equal beads that lose as much as the ball does without load."""
    alpha, beta = law["alpha"], law["beta"]
    return restitution(gamma / 2.0 ** (1.0 - beta / (alpha + 1.0)), alpha, beta)


def slope_at_rest(law):
    """Return the limit of (1 − e)/γ, from polynomials through five and four dampings."""
    slopes = [(1.0 - two_beads(law, gamma)) / gamma for gamma in SMALL]
    five, four = (
        np.polynomial.Polynomial.fit(SMALL[first:], slopes[first:], 4 - first)(0.0)
        for first in (0, 1)
    )
    rounding = ERROR_OF_RESTITUTION / SMALL[-1]
    return Estimate(float(five), abs(float(five - four)) + rounding)


def first_order(alpha, beta):
    """Return C₀."""
    nu = beta / (alpha + 1.0)
    return beta * (0.5 * (alpha + 1.0)) ** (nu - 1.0) * float(euler_beta(nu, 1.5))


def farthest_from_published(found):
    """Return the largest distance of e from a published point."""
    distance = abs(found["restitution"] - found["published"])
    return Estimate(float(distance.max()), float(found["restitution_error"].max()))


def farthest_from_two_beads(found):
    """Return the largest distance of e without load from that of two beads."""
    distance = abs(found["restitution"].sel(load=0.0) - found["two_beads"])
    errors = found["restitution_error"].sel(load=0.0) + found["two_beads_error"]
    return Estimate(float(distance.max()), float(errors.max()))


def farthest_from_first_order(found):
    """Return the largest distance of the slope from C₀, over C₀."""
    distance = abs(found["slope"] / found["first_order"] - 1.0)
    return Estimate(
        float(distance.max()), float((found["slope_error"] / found["first_order"]).max())
    )


def viscous_time(found, restitution, velocity, radius, mass, modulus):
    """Return γ₀ in s that two spheres get from e at a velocity by the first order.

    Lengths in m, mass in kg, Young's modulus in Pa, with the stiffness (4/3) E R^(1/2).
    """
    rate = (4.0 / 3.0) * modulus * radius**0.5 / mass
    gamma = weak_damping_slope() * (1.0 - restitution)
    return rounded(gamma * velocity**-0.2 * rate**-0.4, units=8.0)


def restitution_of_first_order(found, restitution_aimed_at, plate):
    """Return the exact e at the damping that two spheres get from e by the first order."""
    gamma = weak_damping_slope() * (1.0 - restitution_aimed_at)
    e = two_beads({"alpha": 1.5, "beta": 1.5}, gamma) if plate else restitution(gamma)
    return Estimate(e, ERROR_OF_RESTITUTION)


if __name__ == "__main__":
    with job(snakemake):
        settings = snakemake.params.settings
        found = falls(**settings, statements=snakemake.input.statements)
        write_dataset(found, snakemake.output.dataset, scene_id="falls", config=settings)
