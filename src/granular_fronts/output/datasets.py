"""The one place that writes and reads netCDF: names, units, provenance, error estimates.

Files follow CF-1.11.  Everything is dimensionless, units "1"; the time coordinate is called `t`,
since `time` means clock time to CF tools.  A recording with coordinates of its own carries its name
as a suffix on variable and coordinates alike: `relative_displacement_grid` on (`t_grid`, `bead`),
`relative_displacement_steady` on (`t_steady`, `bead_steady`).

Every variable says how wrong it can be (`error_estimate`, an estimate of its largest absolute
error, and `error_method`); every file says which scene it belongs to (`scene`, `config` as JSON),
how it was solved, and with which versions (`software`, `code_version`).  A file appears under its
name only when it is complete.
"""

import importlib.metadata
import json
from collections.abc import Hashable, Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from granular_fronts.output.files import complete_file
from granular_fronts.output.provenance import (
    code_version,
    data_digest,
    digest,
    origin,
    question_digest,
)

PAPER = "G. James, Nonlinearity 34 (2021) 1758-1790, doi:10.1088/1361-6544/abdbbe"

LONG_NAMES = {
    "alpha": "exponent of the contact law",
    "amplitude": "amplitude A of the slowest mode behind, u = 1 - A exp(rate xi)",
    "angular_frequency": "angular frequency of the oscillations of y about 1",
    "arrival_time": "time at which u_n first reaches the arrival level",
    "bead": "bead number n",
    "beads_ahead": "beads ahead of the front in the window",
    "beads_behind": "beads behind the front in the window",
    "below_reference": "whether the reference is too coarse to measure the error",
    "beta": "exponent of the viscous force",
    "bytes": "size of the certificate",
    "case": "name of the hard case",
    "approximation": "approximation of u",
    "certificate": "certificate of fronts that are proved",
    "compression": "rescaled relative displacement y^(1/alpha)",
    "compression_behind": "compression behind the front",
    "conservative_distance": "largest difference of u_n/delta, theta-method to conservative chain",
    "contact_damping": "coefficient gamma_0 of the viscous force",
    "contact": "number n of the contact between beads n and n + 1",
    "converged": "1 where a front was found, 0 elsewhere",
    "cpu_share": "processor time over wall-clock time",
    "criterion": "what the error is a distance from, or a defect of",
    "critical_damping": "damping from which on fronts do not oscillate",
    "critical_gamma": "damping below which a front oscillates, by its tail",
    "damping_distance": "largest difference of u_n/delta, theta-method to damped chain",
    "decay_high": "upper bound of -ln u",
    "decay_low": "lower bound of -ln u",
    "critical": "1 where fronts are monotone above the critical damping and overshoot below it",
    "direction": "+1 if the front runs to larger n, -1 otherwise",
    "dissipated_power": "power that all contacts of a front dissipate",
    "distance": "largest difference of u/delta to the exact front",
    "disturbed": "whether the time was taken while something else took part of the machine",
    "error": "largest error of all fields",
    "error_bound": "bound of the distance of u to its approximation",
    "energy_defect": "energy less work done and dissipated, over the work",
    "error_estimate": "estimate of the error of u",
    "essential_multiplier_imaginary": "imaginary part of the multiplier of a wave behind the front",
    "essential_multiplier_real": "real part of the multiplier of a wave behind the front",
    "event_error": "median error of the velocity after a collision",
    "event_steps": "median number of steps through a collision",
    "expected": "what the solution must do",
    "excess": "damping of the accurate chain that does the same, over gamma, less 1",
    "factor": "number that the viscous potential is multiplied by",
    "file": "file of the certificate",
    "first_gap_bead": "bead n whose contact with n + 1 opens first",
    "first_gap_time": "time at which the first contact opens",
    "first_peak": "first maximum of u_n after the arrival",
    "first_peak_time": "time of the first maximum of u_n after the arrival",
    "flow_residual": "largest change of the front by flow-then-shift",
    "flux": "flux f_alpha(y) of the amplitude equation",
    "force": "rescaled force y",
    "front": "stationary front, rescaled relative displacement y^(1/alpha)",
    "front_speed": "slope of bead number over arrival time, middle of the chain",
    "gamma": "strength of the viscous force",
    "grid": "number of cells or points",
    "growth_rate": "rate at which y leaves 1",
    "inequality": "inequality that a proof needs",
    "joined": "1 where the fronts continue those of the certificate before",
    "largest_relative_displacement": "largest relative displacement of all beads and times",
    "law": "law of contact",
    "left": "left-hand side of an inequality",
    "limit": "largest error that passes",
    "log_rescaled_force": "logarithm of the rescaled force, ln y",
    "material": "material of the beads",
    "mean_relative_displacement": "mean relative displacement (x_1 - x_N)/N",
    "measured": "measured value of the quantity",
    "message": "why there is no result, or an uncertain one",
    "method": "integrator",
    "momentum_defect": "momentum over the impulse of the pressure, less 1",
    "monotone": "1 where the front is monotone",
    "mu": "damping parameter of the logarithmic KdV-Burgers equation",
    "mu_front": "damping parameter of the front's logarithmic KdV-Burgers equation",
    "multiplier": "number of the multiplier, that of translation first",
    "multiplier_imaginary": "imaginary part of a multiplier of flow-then-shift",
    "multiplier_real": "real part of a multiplier of flow-then-shift",
    "observed_order": "slope of error against steps",
    "order": "observed order of convergence",
    "order_error": "error of the observed order",
    "oscillates": "1 where u crosses 1 infinitely often behind, so that max u > 1",
    "overshoot": "deviation from 1, the value behind a front, at an extremum",
    "own_method": "method that this project stands for",
    "passed": "1 if the error is within the limit",
    "peak": "first maximum of u in the middle of the chain",
    "piston_velocity": "velocity of the beads behind the front",
    "potential": "double-well potential W(y)",
    "power": "power that the front dissipates",
    "problem": "problem solved",
    "processor_seconds": "processor time to make and to prove a certificate",
    "overshoot_bound": "number that the largest u exceeds 1 by",
    "profile": "strain over its jump, 1 behind the front and 0 ahead",
    "quantity": "what is measured",
    "radius": "radius of the ball in which the fixed point lies",
    "ramp": "time over which a piston rises to its velocity",
    "rate": "rate of the slowest mode behind, per site",
    "reading": "number that falls with the damping",
    "reason": "why there is no front",
    "reference_error": "error of the reference itself",
    "reflection_radius": "what long waves reflected in the window give for it",
    "relative_displacement": "relative displacement u_n = x_n - x_(n+1), compression > 0",
    "relative_displacement_difference": "relative displacement by shooting less that by profile",
    "relative_displacement_error": "error of the relative displacements",
    "relative_displacement_floor": "error of the solvers in u_n/delta",
    "relative_displacement_rms": "rms difference of compressions u_n/delta, chain to equation",
    "relative_displacement_sup": "largest difference of compressions u_n/delta, chain to equation",
    "rescaled_force": "rescaled force y",
    "rescaled_force_error": "error of the rescaled force",
    "residual": "largest residual of the equations of a front",
    "residual_history": "largest residual before each step of the iteration and after the last",
    "restitution": "coefficient of restitution",
    "restitution_defect": "1 - e of a collision over the exact one, less 1",
    "right": "right-hand side of an inequality",
    "right_hand_sides": "evaluations of the right-hand side",
    "run": "number of the run",
    "rung": "rung of a ladder of tolerances or numbers of steps",
    "s": "rescaled coordinate 2 sqrt(3) epsilon (n - ct)",
    "scene": "scene solved",
    "scheme": "numerical scheme",
    "seconds": "wall-clock time of the solve alone",
    "setting": "error per step allowed, or longest step",
    "site": "bead number n, between beads too",
    "slope": "slope y' of the rescaled force",
    "slope_error": "error of the slope of the rescaled force",
    "slow_time": "slow time tau of the amplitude equation",
    "smallest_relative_displacement": "smallest relative displacement of all beads and times",
    "spectral_radius_without_translation": "largest modulus of the other multipliers",
    "speed": "speed of the front, negative if it runs to smaller n",
    "speed_defect": "speed found over the exact speed, less 1",
    "squared_slope_at_one": "squared slope q where y first reaches 1 from the foot of the front",
    "start": "kind of start",
    "statements": "what is proved, in words",
    "state": "strain x_(n+1) - x_n far from the front",
    "step": "time step; of the half-step scheme in collision times",
    "steps": "steps taken",
    "stiffness": "stiffness k of the contact",
    "strain": "strain r = x_(n+1) - x_n, negative in compression",
    "t": "time",
    "tail_frequency": "angular frequency of the tail behind the front, per site",
    "tail_root_imaginary": "imaginary part of a root of the tail behind the front",
    "tail_root_real": "real part of a root of the tail behind the front",
    "tail_rate": "rate at which u approaches 1 behind the front, per site",
    "theta": "parameter of the theta-method",
    "tolerance": "relative tolerance asked for, or the longest step",
    "total_velocity": "sum of all bead velocities",
    "trajectory": "number of the trajectory",
    "translation_defect": "distance of the multiplier of translation from 1",
    "turn": "number of the extremum of y, from the foot of the front",
    "turning_point": "s of an extremum of y",
    "value": "value of the quantity",
    "value_error": "error of the value",
    "verdict": "what the multipliers say of the front",
    "velocity": "bead velocity",
    "velocity_behind": "velocity of the beads behind the front",
    "velocity_difference": "velocity by shooting less that by profile",
    "velocity_drift": "largest relative change of the piston's velocity from what is prescribed",
    "velocity_error": "error of the velocities",
    "velocity_floor": "error of the solvers in velocities over their scale",
    "velocity_jump": "velocity at n -> +infinity less that at n -> -infinity",
    "velocity_ratio": "velocity over the velocity v_c at which gamma is 1",
    "velocity_rms": "rms difference of velocities over their scale, chain to equation",
    "velocity_sup": "largest difference of velocities over their scale, chain to equation",
    "wavenumber": "wavenumber per bead",
    "width_10_90": "distance from 90 to 10 per cent of a front, in beads",
    "xi": "coordinate along the wave, epsilon (n - c t)",
    "y": "rescaled force y",
}

_PACKAGES = ("numpy", "scipy", "numba", "xarray", "netCDF4")
_COMPRESSION = {"zlib": True, "complevel": 2, "shuffle": True}


class DatasetError(ValueError):
    """A result file that is missing, damaged, or belongs to something else."""


@cache
def long_name(variable: str) -> str:
    """What a variable or coordinate is, in words, from its name and suffix."""
    matches = [name for name in LONG_NAMES if variable == name or variable.startswith(f"{name}_")]
    if not matches:
        raise KeyError(f"{variable} has no entry in LONG_NAMES of datasets.py: add one.")
    name = max(matches, key=len)
    suffix = variable[len(name) + 1 :].replace("_", " ")
    return f"{LONG_NAMES[name]} ({suffix})" if suffix else LONG_NAMES[name]


def name_variables(dataset: xr.Dataset) -> xr.Dataset:
    """Give all variables and coordinates their names in words and their units.

    Parameters
    ----------
    dataset : xarray.Dataset
        It is changed; names that its variables have already are kept.

    Returns
    -------
    xarray.Dataset
        The same.
    """
    for name, variable in dataset.variables.items():
        given = variable.attrs
        words = given.get("long_name") or long_name(str(name))
        variable.attrs = {"long_name": words, "units": "1", **given}
    return dataset


def write_dataset(
    dataset: xr.Dataset, path: Path, *, scene_id: str, config: Mapping[str, Any]
) -> None:
    """Write a dataset with names, units and provenance, atomically.

    Parameters
    ----------
    dataset : xarray.Dataset
        Its data variables should carry `error_estimate` and `error_method`.
    path : Path
        Final name of the netCDF file.
    scene_id : str
    config : mapping
        The part of the configuration that was computed, stored as JSON with its digest; a `Law` in
        it is stored as it describes itself.
    """
    config = json.loads(json.dumps(config, default=lambda law: law.describe()))
    described = name_variables(dataset.copy())
    described.attrs = {
        **{key: _plain(value) for key, value in dataset.attrs.items()},
        "Conventions": "CF-1.11",
        "title": f"Scene {scene_id}",
        "references": PAPER,
        "history": f"written by granular_fronts {code_version()}",
        "scene": scene_id,
        "config": json.dumps(config, sort_keys=True),
        "config_digest": question_digest(config),
        "data_digest": data_digest(described),
        "software": ", ".join(f"{name} {importlib.metadata.version(name)}" for name in _PACKAGES),
        "code_version": code_version(),
    }
    with complete_file(path) as unfinished:
        described.to_netcdf(unfinished, engine="netcdf4", encoding=_encoding(described))


def read_dataset(path: Path | str, scene_id: str | None = None) -> xr.Dataset:
    """Read a dataset written by `write_dataset` into memory.

    Parameters
    ----------
    path : Path
    scene_id : str, optional
        Refuse the file of any other scene.

    Returns
    -------
    xarray.Dataset

    Raises
    ------
    DatasetError
        If the file is missing, damaged, not one of this project's, or of another scene, or if its
        values or its configuration are not those that were written.
    """
    remedy = "delete it and run the workflow again."
    if not Path(path).exists():
        raise DatasetError(f"{path} does not exist: run the workflow to make it.")
    try:
        with xr.open_dataset(path, engine="netcdf4") as dataset:
            loaded = dataset.load()
    except (OSError, ValueError, RuntimeError) as error:
        raise DatasetError(f"{path} is not a readable netCDF file ({error}): {remedy}") from error
    if not {"scene", "config", "config_digest", "data_digest"} <= loaded.attrs.keys():
        raise DatasetError(f"{path} was not written by this project (no scene in it): {remedy}")
    if scene_id is not None and loaded.attrs["scene"] != scene_id:
        raise DatasetError(
            f"{path} holds scene {loaded.attrs['scene']}, but {scene_id} is expected: {remedy}"
        )
    asked = digest(str(loaded.attrs["config"]).encode())
    if (asked, data_digest(loaded)) != (loaded.attrs["config_digest"], loaded.attrs["data_digest"]):
        raise DatasetError(f"{path} was altered after it was written: {remedy}")
    return loaded


def read_origins(folder: Path, names: Iterable[str]) -> dict[str, dict[str, str]]:
    """Read what identifies the datasets of a results folder.

    Parameters
    ----------
    folder : Path
        The folder of all data.
    names : iterable of str
        Names of files below it, without ending.

    Returns
    -------
    dict of str to dict
        As `provenance.origin` gives, by name; a dataset that is missing is left out.
    """
    files = {name: Path(folder, f"{name}.nc") for name in names}
    return {name: origin(read_dataset(path).attrs) for name, path in files.items() if path.exists()}


def configuration_of(dataset: xr.Dataset) -> dict[str, Any]:
    """The part of the configuration that a dataset was computed with."""
    return json.loads(dataset.attrs["config"])


def _plain(value: Any) -> Any:
    """An attribute value that netCDF can hold."""
    return value.item() if isinstance(value, np.generic) else value


def _encoding(dataset: xr.Dataset) -> dict[Hashable, dict[str, Any]]:
    encoding: dict[Hashable, dict[str, Any]] = {}
    for name, variable in dataset.variables.items():
        encoding[name] = dict(_COMPRESSION) if variable.ndim else {}
        if name in dataset.coords:
            encoding[name]["_FillValue"] = None
    return encoding
