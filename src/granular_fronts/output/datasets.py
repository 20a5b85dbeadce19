"""The one place that writes and reads netCDF: names, units, provenance, error estimates.

Files follow CF-1.11.  Everything is dimensionless, units "1"; the time coordinate is called `t`,
since `time` means clock time to CF tools.  A recording with coordinates of its own carries its name
as a suffix on variable and coordinates alike: `relative_displacement_grid` on (`t_grid`, `bead`),
`relative_displacement_steady` on (`t_steady`, `bead_steady`).

Every variable says how wrong it can be: `error_estimate` is an estimate of its largest absolute
error, by `error_method`.  Every file says which scene it belongs to (`scene`, `config` as JSON),
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
import yaml

from granular_fronts.output.files import complete_file
from granular_fronts.output.provenance import (
    code_version,
    config_digest,
    data_digest,
    digest,
    source_of,
)

PAPER = "G. James, Nonlinearity 34 (2021) 1758-1790, doi:10.1088/1361-6544/abdbbe"

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
        The part of the configuration that was computed, stored as JSON with its digest.  A `Law` in
        it is stored by its description.
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
        "config_digest": config_digest(config),
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
        If the file is missing, damaged, foreign or of another scene, or if its values or its
        configuration were changed.
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
    digests = digest(str(loaded.attrs["config"]).encode()), data_digest(loaded)
    if digests != (loaded.attrs["config_digest"], loaded.attrs["data_digest"]):
        raise DatasetError(f"{path} was altered after it was written: {remedy}")
    return loaded


def read_sources(folder: Path, names: Iterable[str]) -> list[dict[str, str]]:
    """Return the sources, see `provenance`, of those datasets of a folder that are there."""
    files = [Path(folder, f"{name}.nc") for name in names]
    return [source_of(read_dataset(path)) for path in files if path.exists()]


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
