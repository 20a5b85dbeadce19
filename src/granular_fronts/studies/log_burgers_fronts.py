"""Fluxes and stationary fronts of the amplitude equations; James (2021), equations (40) to (46)."""

import numpy as np
import xarray as xr

from granular_fronts.continuum.log_burgers.equation import flux, limit_flux, log_burgers_front

ROUNDING = {"error_estimate": 4.0e-16, "error_method": "rounding of a closed formula"}


def evaluate_fronts(exponents):
    """Return f_α and y^(1/α) on (alpha, force), fronts (46) on (alpha, xi), limits α → 1."""
    force = np.linspace(0.0, 1.0, 401)
    xi = np.linspace(-6.0, 4.0, 501)
    fluxes = [flux(force, alpha) for alpha in exponents]
    compressions = [force ** (1.0 / alpha) for alpha in exponents]
    fronts = [log_burgers_front(xi, alpha) ** (1.0 / alpha) for alpha in exponents]
    return xr.Dataset(
        {
            "flux": (("alpha", "force"), fluxes, ROUNDING),
            "flux_limit": ("force", limit_flux(force), ROUNDING),
            "compression": (("alpha", "force"), compressions, ROUNDING),
            "front": (("alpha", "xi"), fronts, ROUNDING),
            "front_limit": ("xi", log_burgers_front(xi), ROUNDING),
        },
        {"alpha": exponents, "force": force, "xi": xi},
    )
