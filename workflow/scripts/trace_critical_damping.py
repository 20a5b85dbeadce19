"""Critical damping in its several meanings, along the exponents α of a campaign of fronts.

python workflow/scripts/trace_critical_damping.py --dataset results/data/campaigns/fronts_atlas.nc
    --curves critical_damping.nc
"""

from pathlib import Path

import numpy as np
import xarray as xr

from granular_fronts.datasets import read_dataset, write_dataset
from granular_fronts.fronts.critical_damping import critical_damping, meaning_changes_at
from step import run_step

CURVES = {
    "tail": "damping at which the slowest root of the tail turns real",
    "double-root": "damping at which two real roots of the tail merge",
    "long-wave": "critical damping of the long-wave limit, mu = 2",
}
ROUNDING = {"error_estimate": 1.0e-15, "error_method": "a few units of the last digit of a root"}
POINTS = 401


def trace_critical_damping(dataset: Path, curves: Path) -> None:
    """Compute the curves for β = α over the range of α of a merged campaign.

    Parameters
    ----------
    dataset : Path
        A merged campaign with the axis alpha.
    curves : Path
        The netCDF file to write.
    """
    alphas = read_dataset(dataset)["alpha"].values
    alpha = np.linspace(alphas[0], alphas[-1], POINTS)
    traced = xr.Dataset(coords={"alpha": alpha})
    for definition, meaning in CURVES.items():
        values = [
            critical_damping(value, definition=definition) if applies(value, definition) else np.nan
            for value in alpha
        ]
        name = f"critical_damping_{definition.replace('-', '_')}"
        traced[name] = ("alpha", values, {"long_name": meaning, **ROUNDING})
    config = {"alpha": [float(alpha[0]), float(alpha[-1]), POINTS]}
    write_dataset(traced, curves, scene_id="critical_damping", config=config)


def applies(alpha, definition):
    """Whether critical damping has this meaning: a double root only up to α*."""
    return definition != "double-root" or alpha <= meaning_changes_at()


if __name__ == "__main__":
    run_step(trace_critical_damping, globals().get("snakemake"))
