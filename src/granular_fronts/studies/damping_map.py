"""The plane of exponent and damping: overshoot of exact fronts and curves of critical damping.

Where a front with β = α ceases to oscillate has several answers (see `critical_damping`); each is a
curve γ(α) in the frame δ = c = 1.  The overshoot max u − 1 of the exact front shows what they mean
to the eye.  It never vanishes as long as the tail oscillates, but falls by decades below the first
curve that one would draw.
"""

import numpy as np
import xarray as xr

from granular_fronts.fronts.linear.critical_damping import critical_damping, meaning_changes_at
from granular_fronts.fronts.sweep import sweep_fronts

DEFINITIONS = ("tail", "double-root", "long-wave", "overshoot")


def map_critical_damping(exponents, dampings, cut):
    """Return overshoot over the plane, and every definition of critical damping over the exponent.

    `overshoot` on (alpha, gamma) with the largest of its errors, NaN where a front was not found,
    and `converged`. `critical_damping_<definition>` on (alpha), NaN where it does not apply.  The
    attribute `overshoot_cut` says above which overshoot a front oscillates to the eye.
    `exchange_exponent` is the α* where the meaning of "tail" changes.
    """
    sweeps = [sweep_fronts(alpha, dampings) for alpha in exponents]
    plane = xr.concat(sweeps, dim=xr.DataArray(exponents, dims="alpha", name="alpha"))
    largest_error = float(plane["overshoot_error"].where(plane["converged"] == 1).max())
    plane["overshoot"].attrs["error_estimate"] = largest_error
    dataset = plane[["overshoot", "converged"]]
    last = meaning_changes_at()
    for definition in DEFINITIONS:
        options = {"cut": cut} if definition == "overshoot" else {}
        curve = [
            np.nan
            if definition == "double-root" and alpha > last
            else critical_damping(alpha, definition=definition, **options)
            for alpha in exponents
        ]
        dataset[f"critical_damping_{definition.replace('-', '_')}"] = ("alpha", curve)
    return dataset.assign_attrs(overshoot_cut=cut, exchange_exponent=last)


def map_plane(alpha, gamma, overshoot_cut):
    """Map exponents in equal steps and dampings in equal ratios, as numpy takes them."""
    return map_critical_damping(np.linspace(**alpha), np.geomspace(**gamma), overshoot_cut)
