"""Fluxes and stationary fronts of the amplitude equations; James (2021), equations (40) to (46).

python workflow/scripts/evaluate_fronts.py --exponents "[1.5, 1.1]" --dataset log_burgers.nc
"""

from pathlib import Path

import numpy as np
import xarray as xr

from granular_fronts.continuum.log_burgers.equation import flux, limit_flux, log_burgers_front
from granular_fronts.output.datasets import write_dataset
from step import run_step

ROUNDING = {"error_estimate": 4.0e-16, "error_method": "rounding of a closed formula"}


def evaluate_fronts(exponents: list[float], dataset: Path) -> None:
    """Tabulate f_α, y^(1/α) and the fronts of (46) for some α, and their limits.

    Parameters
    ----------
    exponents : list of float
        Values of α.
    dataset : Path
        The netCDF file to write.
    """
    force = np.linspace(0.0, 1.0, 401)
    xi = np.linspace(-6.0, 4.0, 501)
    fronts = [log_burgers_front(xi, alpha) ** (1.0 / alpha) for alpha in exponents]
    tabulated = xr.Dataset(
        {
            "flux": (("alpha", "force"), [flux(force, alpha) for alpha in exponents], ROUNDING),
            "flux_limit": ("force", limit_flux(force), ROUNDING),
            "compression": (
                ("alpha", "force"),
                [force ** (1.0 / alpha) for alpha in exponents],
                ROUNDING,
            ),
            "front": (("alpha", "xi"), fronts, ROUNDING),
            "front_limit": ("xi", log_burgers_front(xi), ROUNDING),
        },
        {"alpha": exponents, "force": force, "xi": xi},
    )
    config = {"exponents": list(exponents)}
    write_dataset(tabulated, dataset, scene_id="log_burgers_fronts", config=config)


if __name__ == "__main__":
    run_step(evaluate_fronts, globals().get("snakemake"))
