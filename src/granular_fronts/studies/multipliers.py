"""Floquet multipliers of exact fronts in windows of several lengths: they decide stability."""

import numpy as np
import xarray as xr

from granular_fronts.fronts.linear.floquet import compressed_chain_multipliers, front_multipliers
from granular_fronts.studies.front_survey import solve_converged

WAVENUMBERS = 401
SCALARS = (
    "translation_defect",
    "spectral_radius_without_translation",
    "reflection_radius",
    "flow_residual",
    "beads_ahead",
)


def compute_multipliers(fronts, beads_behind):
    """Multipliers of every front, by name, in windows with so many beads behind it.

    `multiplier_real`, `_imaginary` and the errors of `_rounding` on (scene, beads_behind,
    multiplier), those of the compressed chain behind on (scene, branch, wavenumber).  A
    NoFrontError says that there is no front.
    """
    return xr.concat(
        [_spectra_of(law, beads_behind) for law in fronts.values()],
        dim=xr.DataArray(list(fronts), dims="scene", name="scene"),
        join="outer",
    )


def _spectra_of(law, windows):
    """Multipliers of one front in every window, and those of the compressed chain behind it."""
    front = solve_converged(**law)
    found = [front_multipliers(front, beads_behind=behind) for behind in windows]
    spectra = xr.concat(
        [_split(values) for values in found],
        dim=xr.DataArray(windows, dims="beads_behind", name="beads_behind"),
        join="outer",
    )
    q = np.linspace(-np.pi, np.pi, WAVENUMBERS)
    essential = compressed_chain_multipliers(law["alpha"], law["gamma"], law["alpha"], q)
    for name, part in (("real", essential.real), ("imaginary", essential.imag)):
        spectra[f"essential_multiplier_{name}"] = (("branch", "wavenumber"), part)
    return spectra.assign(law).assign_coords(wavenumber=q)


def _split(values):
    """Complex multipliers as real and imaginary parts, which netCDF can hold, and scalars."""
    parts = {
        "multiplier_real": values.real,
        "multiplier_imaginary": values.imag,
        "multiplier_rounding": values["rounding"],
    }
    scalars = {name: values.attrs[name] for name in SCALARS}
    return xr.Dataset(parts | scalars).drop_vars("rounding").drop_attrs()
