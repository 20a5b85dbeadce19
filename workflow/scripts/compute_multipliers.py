"""Floquet multipliers of exact fronts in windows of several lengths, which decide their stability.

About ten seconds: python workflow/scripts/compute_multipliers.py
    --stability config/default.yaml:exact_fronts.multipliers --dataset multipliers.nc
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from granular_fronts.fronts.linear.floquet import compressed_chain_multipliers, front_multipliers
from granular_fronts.fronts.solve import solve_front
from granular_fronts.output.datasets import write_dataset
from step import run_step

WAVENUMBERS = 401
SCALARS = (
    "translation_defect",
    "spectral_radius_without_translation",
    "reflection_radius",
    "flow_residual",
    "beads_ahead",
)


def compute_multipliers(stability: dict, dataset: Path) -> None:
    """Compute the spectrum of every front in every window.

    Parameters
    ----------
    stability : dict
        As under ``exact_fronts.multipliers`` of the configuration.
    dataset : Path
        The netCDF file to write: real and imaginary parts on (scene, beads_behind, multiplier).
    """
    windows = stability["beads_behind"]
    spectra = xr.concat(
        [spectra_of(law, windows) for law in stability["fronts"].values()],
        dim=xr.DataArray(list(stability["fronts"]), dims="scene", name="scene"),
        join="outer",
    )
    write_dataset(spectra, dataset, scene_id="multipliers", config=stability)


def spectra_of(law: Mapping[str, Any], windows: list[int]) -> xr.Dataset:
    """Multipliers of one front in every window, and those of the compressed chain behind it.

    Parameters
    ----------
    law : dict
        alpha and gamma, for δ = c = 1.
    windows : list of int
        Numbers of beads behind the front.

    Returns
    -------
    xarray.Dataset
    """
    front = solve_front(**law)
    if not front.attrs["converged"]:
        raise ValueError(f"The front of {law} is not solved: {front.attrs['reason']}.")
    found = [front_multipliers(front, beads_behind=behind) for behind in windows]
    spectra = xr.concat(
        [split(values) for values in found],
        dim=xr.DataArray(windows, dims="beads_behind", name="beads_behind"),
        join="outer",
    )
    q = np.linspace(-np.pi, np.pi, WAVENUMBERS)
    essential = compressed_chain_multipliers(law["alpha"], law["gamma"], law["alpha"], q)
    for name, part in (("real", essential.real), ("imaginary", essential.imag)):
        spectra[f"essential_multiplier_{name}"] = (("branch", "wavenumber"), part)
    return spectra.assign(law).assign_coords(wavenumber=q)


def split(values: xr.DataArray) -> xr.Dataset:
    """Complex multipliers as real and imaginary parts, which netCDF can hold, and scalars."""
    parts = {"multiplier_real": values.real, "multiplier_imaginary": values.imag}
    scalars = {name: values.attrs[name] for name in SCALARS}
    return xr.Dataset(parts | scalars).drop_attrs()


if __name__ == "__main__":
    run_step(compute_multipliers, globals().get("snakemake"))
