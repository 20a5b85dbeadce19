"""The one place that writes and reads netCDF: names, units, error estimates.

Files follow CF-1.11.  Everything is dimensionless, units "1"; the time coordinate is called `t`,
since `time` means clock time to CF tools.  A recording with coordinates of its own carries its name
as a suffix on variable and coordinates alike: `relative_displacement_grid` on (`t_grid`, `bead`),
`relative_displacement_steady` on (`t_steady`, `bead_steady`).

Every variable says how wrong it can be: `error_estimate` is an estimate of its largest absolute
error, by `error_method`.  Every file says which scene it belongs to (`scene`, `config` as JSON),
how it was solved, and with which versions (`software`, `code_version`).  A digest of its numbers
(`data_digest`), the first 16 hexadecimals of a SHA-256, is compared where it is read.  A file
appears under its name only when it is complete.
"""

import hashlib
import importlib.metadata
import json
import math
from collections.abc import Hashable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
import yaml

from granular_fronts import __version__
from granular_fronts.numerics.source_code import code_digest
from granular_fronts.output.files import complete_file

PAPER = "G. James, Nonlinearity 34 (2021) 1758-1790, doi:10.1088/1361-6544/abdbbe"

SOURCES = Path(__file__).parents[1]

LONG_NAMES = Path(__file__).with_name("long_names.yaml")

_PACKAGES = ("numpy", "scipy", "numba", "xarray", "netCDF4")
_COMPRESSION = {"zlib": True, "complevel": 2, "shuffle": True}


class DatasetError(ValueError):
    """A result file that is missing, damaged, or belongs to something else."""


@cache
def long_names() -> dict[str, str]:
    """Return what the variables and coordinates of all datasets are, in words."""
    return yaml.safe_load(LONG_NAMES.read_text(encoding="utf-8"))


@cache
def long_name(variable: str) -> str:
    """Return what a variable or coordinate is, in words, from its name and suffix."""
    known = [name for name in long_names() if variable == name or variable.startswith(f"{name}_")]
    if not known:
        raise KeyError(f"{variable} has no long_name: add it, or an entry in {LONG_NAMES.name}.")
    name = max(known, key=len)
    suffix = variable[len(name) + 1 :].replace("_", " ")
    return f"{long_names()[name]} ({suffix})" if suffix else long_names()[name]


def name_variables(dataset: xr.Dataset) -> xr.Dataset:
    """Give all variables and coordinates of a dataset, in place, names in words and units."""
    for name, variable in dataset.variables.items():
        given = variable.attrs
        words = given.get("long_name") or long_name(str(name))
        variable.attrs = {"long_name": words, "units": "1", **given}
    return dataset


@cache
def code_version() -> str:
    """Return the version of the package and digest of its code, the same on every machine."""
    return f"{__version__}+{code_digest(SOURCES.rglob('*.py'), SOURCES)}"


def data_digest(dataset: xr.Dataset) -> str:
    """Return the digest of all values of a dataset with their names, not attributes."""
    found = hashlib.sha256()
    for name in sorted(map(str, dataset.variables)):
        values = dataset.variables[name].values
        # A file keeps neither the width of text nor its type, nor the sign of what is not a number.
        kind = values.dtype.kind if values.dtype.kind in "biuf" else "U"
        found.update(f"{name} {kind} {values.shape} ".encode())
        if kind == "U":
            found.update(json.dumps(values.astype(str).tolist()).encode())
            continue
        if kind == "f":
            values = values.copy()
            values[values != values] = math.nan
        found.update(values.tobytes())
    return found.hexdigest()[:16]


def write_dataset(
    dataset: xr.Dataset, path: Path | str, *, scene_id: str, config: Mapping[str, Any]
) -> None:
    """Write a dataset with names, units and a digest, atomically.

    Parameters
    ----------
    dataset : xarray.Dataset
        Its data variables should carry `error_estimate` and `error_method`.
    path : Path or str
        Final name of the netCDF file.
    scene_id : str
    config : mapping
        The part of the configuration that was computed, stored as JSON.  A `Law` in it is stored
        by its description.
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
        If the file is missing, damaged, foreign or of another scene, or if its values were changed.
    """
    remedy = "delete it and run the workflow again."
    if not Path(path).exists():
        raise DatasetError(f"{path} does not exist: run the workflow to make it.")
    try:
        with xr.open_dataset(path, engine="netcdf4") as dataset:
            loaded = dataset.load()
    except (OSError, ValueError, RuntimeError) as error:
        raise DatasetError(f"{path} is not a readable netCDF file ({error}): {remedy}") from error
    if not {"scene", "config", "data_digest"} <= loaded.attrs.keys():
        raise DatasetError(f"{path} was not written by this project (no scene in it): {remedy}")
    if scene_id is not None and loaded.attrs["scene"] != scene_id:
        raise DatasetError(
            f"{path} holds scene {loaded.attrs['scene']}, but {scene_id} is expected: {remedy}"
        )
    if data_digest(loaded) != loaded.attrs["data_digest"]:
        raise DatasetError(f"{path} was altered after it was written: {remedy}")
    return loaded


def configuration_of(dataset: xr.Dataset) -> dict[str, Any]:
    """Return the part of the configuration that a dataset was computed with."""
    return json.loads(dataset.attrs["config"])


def _plain(value: Any) -> Any:
    """Return an attribute value that netCDF can hold."""
    return value.item() if isinstance(value, np.generic) else value


def _encoding(dataset: xr.Dataset) -> dict[Hashable, dict[str, Any]]:
    encoding: dict[Hashable, dict[str, Any]] = {}
    for name, variable in dataset.variables.items():
        encoding[name] = dict(_COMPRESSION) if variable.ndim else {}
        if name in dataset.coords:
            encoding[name]["_FillValue"] = None
    return encoding
