"""Write the solved points of a chunk into its file, and merge all chunks into the grid.

The file of a chunk holds its variables on (line, point).  Its `config` attribute is its request, so
that it can be placed without any other file.  The merged file has the varied parameters as
dimensions, the recorded variables, and

- `status` (a flag): 0 solved, 1 failed;
- `reason`: number of a sentence in `reason_text`, 0 where the point is solved.
"""

import json
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr

from granular_fronts.campaign.chunks import Chunk, locate
from granular_fronts.campaign.definition import Campaign
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.campaign.points import Solved
from granular_fronts.output.datasets import DatasetError, read_dataset

SOLVED, FAILED = 0, 1


def chunk_dataset(chunk: Chunk, solved: Solved, seconds: float) -> xr.Dataset:
    """Return dataset of a chunk's file, from what its kind made of it in so much processor time."""
    kind = KINDS[chunk.kind]
    coordinates = _profile_coordinate(kind, chunk.settings["profile"])
    dataset = xr.Dataset(coords=coordinates)
    for name, values in solved.values.items():
        along = list(coordinates) if name == kind.profile[0] else []
        attributes = _attributes(kind, name, solved.errors[name], solved.error_method)
        dataset[name] = (["line", "point", *along], values, attributes)
    texts, numbers = _number_reasons(solved.reasons)
    dataset["reason"] = (["line", "point"], numbers, {"long_name": "number of the reason"})
    dataset["reason_text"] = ("sentence", texts, {"long_name": "why a point failed"})
    dataset.attrs = {"points": chunk.size, "seconds": seconds}
    return dataset


def _attributes(kind, name, error, method):
    meaning = {**kind.scalars, kind.profile[0]: kind.profile[1]}[name]
    return {"long_name": meaning, "error_estimate": float(error), "error_method": method}


def merge_chunks(campaign: Campaign, files: list[Path]) -> xr.Dataset:
    """Put the files of chunks together on the grid of a campaign; points outside are left out.

    A DatasetError says that a file is damaged or of another campaign, or that points are missing.
    """
    gathered = _gather(campaign, files)
    kind = campaign.kind
    coordinates = _profile_coordinate(kind, campaign.settings["profile"])
    sizes = [len(campaign.grid[axis]) for axis in campaign.axes]
    axes = {
        axis: (axis, list(campaign.grid[axis]), {"long_name": meaning})
        for axis, meaning in campaign.axes.items()
    }
    merged = xr.Dataset(coords=coordinates | axes)
    for name, value in gathered.values.items():
        along = list(coordinates) if name == kind.profile[0] else []
        method = "; ".join(sorted(gathered.methods))
        attributes = _attributes(kind, name, gathered.errors[name], method)
        shape = [*sizes, *value.shape[1:]]
        merged[name] = ([*campaign.axes, *along], value.reshape(shape), attributes)
    _add_status(merged, campaign, gathered.reasons.reshape(sizes), gathered.texts)
    merged.attrs = {
        "kind": campaign.file.kind,
        "points": campaign.size,
        "failed_points": int(np.sum(gathered.reasons > 0)),
        "chunks": len(files),
        "seconds": gathered.seconds,
        "seconds_per_point": gathered.seconds / gathered.points,
        **{
            name: values[0]
            for name, values in campaign.grid.items()
            if name not in campaign.axes and values != (None,)
        },
    }
    return merged


class _Gathered(NamedTuple):
    """What all chunks hold together, arrays along the flat grid."""

    values: dict
    errors: dict
    methods: set  # by which errors are estimated
    reasons: np.ndarray  # number of a text, 0 where the point is solved
    texts: list
    seconds: float  # processor time
    points: int  # of all chunks, those outside the grid too


def _gather(campaign, files):
    """Read all chunks and lay their points on the grid."""
    kind, profile = campaign.kind, campaign.settings["profile"]
    values = {name: np.full(campaign.size, np.nan) for name in campaign.settings["scalars"]}
    if profile:
        values[kind.profile[0]] = np.full((campaign.size, profile["count"]), np.nan)
    reasons, errors, methods = np.full(campaign.size, -1), dict.fromkeys(values, np.nan), set()
    texts, seconds, points = {"": 0}, 0.0, 0
    for file in files:
        data, where = _read_chunk(file, campaign)
        inside = where >= 0
        for name, value in values.items():
            value[where[inside]] = data[name].values[inside]
            errors[name] = np.fmax(errors[name], data[name].attrs["error_estimate"])
            methods.add(data[name].attrs["error_method"])
        numbers = [texts.setdefault(str(text), len(texts)) for text in data["reason_text"].values]
        reasons[where[inside]] = np.array(numbers)[data["reason"].values[inside]]
        seconds, points = seconds + data.attrs["seconds"], points + data.attrs["points"]
    if (reasons < 0).any():
        raise DatasetError(
            f"Campaign {campaign.name}: {np.sum(reasons < 0)} points are in no chunk: "
            "run the workflow again."
        )
    return _Gathered(values, errors, methods, reasons, list(texts), seconds, points)


def _read_chunk(file, campaign):
    """Return the dataset of a chunk, and where its points lie on the grid."""
    data = read_dataset(file, scene_id=file.stem)
    chunk = Chunk(**json.loads(data.attrs["config"]))
    if (chunk.kind, chunk.settings) != (campaign.file.kind, campaign.settings):
        raise DatasetError(
            f"{file} was solved with other settings than campaign {campaign.name} has: "
            "delete it and run the workflow again."
        )
    return data, locate(chunk, campaign)


def _number_reasons(reasons):
    """Return the distinct sentences, the empty one first, and the number of each point's."""
    texts = {"": 0}
    numbers = [texts.setdefault(str(reason), len(texts)) for reason in reasons.ravel()]
    return list(texts), np.array(numbers, dtype=np.int32).reshape(reasons.shape)


def _add_status(merged, campaign, reasons, texts):
    """Status flag, number of the reason, and the sentences."""
    flags = {
        "long_name": "whether the point is solved",
        "flag_values": np.array([SOLVED, FAILED], dtype=np.int8),
        "flag_meanings": "solved failed",
    }
    status = np.where(reasons > 0, FAILED, SOLVED).astype(np.int8)
    merged["status"] = ([*campaign.axes], status, flags)
    numbered = {"long_name": "number of the sentence in reason_text"}
    merged["reason"] = ([*campaign.axes], reasons.astype(np.int32), numbered)
    merged["reason_text"] = ("sentence", texts, {"long_name": "why a point failed"})


def _profile_coordinate(kind, profile):
    """Return the coordinate of the recorded profile, none if there is no profile."""
    if profile is None:
        return {}
    name, meaning = kind.profile_along
    return {name: (name, kind.profile_points(profile), {"long_name": meaning})}
