r"""Overdamped fronts with linear dashpots: rates of both tails, their limit, and proofs.

A front of the law (28) with β = 1, from compression 1 into a chain at rest, has the speed 1.  As
γ → ∞ it obeys :math:`\gamma u' = u^\alpha - u` in long waves, by our derivation, so that

.. math::  u \to (1 + (2^{\alpha-1} - 1)\, e^{(\alpha-1)\xi/\gamma})^{-1/(\alpha-1)} .
"""

import math
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import xarray as xr

from granular_fronts.accuracy import Estimate, tabulated, variable_and_errors
from granular_fronts.errors import SolveError
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.linear.tails import rate_of_tail_ahead, tail_roots
from granular_fronts.fronts.solve import solve_front
from granular_fronts.output.datasets import write_dataset
from granular_fronts.proofs.certificate import prove_front
from granular_fronts.proofs.checker import check_certificate
from job import job

ALPHA = 1.5
GAMMA = 2.0 ** np.arange(-1.0, 4.5, 0.5)
"""Dampings of fronts, all above the critical one."""

PROVED_HERE = ("1/2", "1")

BEHIND, AHEAD = (1e-6, 1.0), (1e-8, ALPHA - 1.0)
"""Where a tail is measured, and the power of it by which its rate is not yet the last one."""


def overdamped_fronts(certificate):
    """Return what is measured on (gamma), and `overshoot_bound` on (certificate), their γ."""
    variables, records = {}, proofs(certificate)
    named = {
        "rise": "largest rise of a front",
        "width": "width of a front over that of the limit",
        "behind": "rate of decay behind",
        "ahead": "rate of decay ahead",
    }
    method = "a refined front; of rates, another decade"
    for name, found in zip(named, zip(*map(look_at, GAMMA), strict=True), strict=True):
        variables |= variable_and_errors(name, "gamma", found, method, named[name])
    tops = [record["numbers"].get("overshoot", math.nan) - 1.0 for record in records]
    variables["overshoot_bound"] = "certificate", tops
    proved = [float(record["gamma"][0]) for record in records]
    critical = {"critical_damping": critical_damping(ALPHA, 1.0)}
    return xr.Dataset(variables, {"gamma": GAMMA, "certificate": proved}, critical)


def look_at(gamma):
    """Return how far a front rises, its width over that of the limit, and its rates."""
    front = solve_front(ALPHA, gamma, 1.0)
    xi, u, error = front["xi"].values, front["relative_displacement"].values, front.error_estimate
    return (
        Estimate(float((u - np.minimum.accumulate(u)).max()), 2.0 * error),
        Estimate(front.width_10_90, front.width_10_90_error) / width_of_limit(gamma),
        decay(-xi, 1.0 - u, *BEHIND),
        decay(xi, u, *AHEAD),
    )


def width_of_limit(gamma):
    """Return the width from 0.9 to 0.1 of the front of strong damping."""
    power = ALPHA - 1.0
    return gamma / power * math.log((0.1**-power - 1.0) / (0.9**-power - 1.0))


def decay(distance, tail, level, power):
    """Return the rate in the decade above a level; its error falls as a power of the tail."""

    def rate(lowest):
        there = (tail > lowest) & (tail < 10.0 * lowest)
        return -np.polyfit(distance[there], np.log(tail[there]), 1)[0]

    found = rate(level)
    return Estimate(found, abs(found - rate(100.0 * level)) / (100.0**power - 1.0))


def roots(gamma):
    """Return the rate of the slowest tail root behind, and of the one ahead."""
    slowest = tail_roots(ALPHA, gamma, 1.0, count=1)[0].real
    return {"behind": slowest, "ahead": rate_of_tail_ahead(0.0, gamma, 1.0)}


def proofs(certificate):
    """Return what a certificate proves, and what is proved here."""
    with TemporaryDirectory() as folder:
        path = Path(folder, "front.npz")
        made = [prove_front("3/2", gamma, path, beta=1) for gamma in PROVED_HERE]
    records = [check_certificate(certificate), *made]
    if reasons := [record["reason"] for record in records if not record["proved"]]:
        raise SolveError(f"Not all of {certificate} and γ = {PROVED_HERE} is proved: {reasons}.")
    return records


def largest_rise(found):
    """Return by how much any front rises."""
    return tabulated(found.isel(gamma=int(np.argmax(found["rise"].values))), "rise")


def over_root(found, tail):
    """Return the measured rate over that of the root, for the γ where it differs most."""
    ratios = [
        tabulated(found, tail, gamma=gamma) / roots(gamma)[tail] for gamma in found["gamma"].values
    ]
    return max(ratios, key=lambda ratio: abs(ratio.value - 1.0))


def width_where_proved(found):
    """Return the width over that of the limit at the largest damping of a proof."""
    return tabulated(found, "width", gamma=float(found["certificate"].max()))


if __name__ == "__main__":
    with job(snakemake):
        found = overdamped_fronts(snakemake.input.certificate)
        write_dataset(found, snakemake.output.dataset, scene_id="fronts", config={})
