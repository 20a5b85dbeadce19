"""Cut the points of a campaign that are still to be solved into chunks, one for each job.

A chunk is a set of lines by a block of the fast axis.  Its *request* holds kind, settings and
points, so that a job needs nothing else; it is named after a digest of them.  Solved chunks are
recognised by the points of their requests, wherever these are in the grid now.  So a campaign may
grow along any axis, drop an axis, or turn a fixed parameter into one.

The grid is divided into tiles of at most the wanted number of points.  It is cut between lines
first, and along the fast axis only if one line is longer than a tile.  The missing lines of a tile
are grouped by which of their points are missing, and each group is a chunk.  So the other chunks
stay the same while some are solved.  A job on a cluster cuts the campaign anew and finds its own
chunk. The request of a chunk stays when its data are removed to be solved again, and with it the
cut.
"""

import hashlib
import json
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np

from granular_fronts.campaign.definition import Campaign
from granular_fronts.output.datasets import DatasetError, configuration_of, read_dataset
from granular_fronts.output.files import complete_file


class Chunk(NamedTuple):
    """The points of one job.

    Attributes
    ----------
    kind : str
    settings : dict
        As in `definition.Campaign`.
    lines : dict of str to list
        For each parameter but the fast one its value on every line.
    fast : dict of str to list
        The fast parameter and its values; one entry.
    """

    kind: str
    settings: dict
    lines: dict[str, list]
    fast: dict[str, list]

    @property
    def name(self) -> str:
        """Digest of the content."""
        return hashlib.sha256(self.as_json().encode()).hexdigest()[:16]

    @property
    def size(self) -> int:
        """Number of points."""
        return len(next(iter(self.fast.values()))) * len(next(iter(self.lines.values()), [None]))

    def as_json(self) -> str:
        """Return the request, always written the same way."""
        return json.dumps(self._asdict(), sort_keys=True)

    def points(self) -> dict[str, np.ndarray]:
        """Return every parameter at every point, arrays of shape (lines, fast)."""
        [(fast, values)] = self.fast.items()
        lines = len(next(iter(self.lines.values()), [None]))
        given = {name: np.array(column)[:, None] for name, column in self.lines.items()}
        given[fast] = np.array(values)[None, :]
        if "beta" in given and given["beta"].dtype == object:
            given["beta"] = given["alpha"]
        shape = (lines, len(values))
        return {name: np.broadcast_to(value, shape) for name, value in given.items()}


def chunks_of(campaign: Campaign, folder: Path, chunk_points: int) -> dict[str, Chunk]:
    """Return the chunks of a campaign by name: known ones from a folder, and new ones.

    Only new chunks have at most so many points.  Nothing is written.
    """
    known, missing = find_missing(campaign, folder)
    return {chunk.name: chunk for chunk in (*known, *cut(campaign, missing, chunk_points))}


def find_missing(campaign: Campaign, folder: Path) -> tuple[list[Chunk], np.ndarray]:
    """Lay the chunks of a folder over the grid of a campaign.

    Return the chunks that hold points of the grid, and an array of the grid's shape.  It is true
    where no chunk holds the point.
    """
    missing = np.ones(campaign.size, dtype=bool)
    known = []
    for chunk in _known_chunks(campaign, folder):
        where = locate(chunk, campaign)
        where = where[where >= 0]
        if missing[where].any():
            missing[where] = False
            known.append(chunk)
    return known, missing.reshape(campaign.shape)


def _known_chunks(campaign: Campaign, folder: Path) -> Iterator[Chunk]:
    """Chunks in a folder that have the campaign's settings, in the order of names."""
    files = {file.with_suffix(".nc") for file in folder.glob("[0-9a-f]*.*")}
    for file in sorted(files):
        try:
            chunk = _find_request(file)
        except (DatasetError, TypeError):
            continue  # Its points are solved again.
        same_parameters = {*chunk.lines, *chunk.fast} == {*campaign.grid}
        same_settings = (chunk.kind, chunk.settings) == (campaign.file.kind, campaign.settings)
        if same_parameters and same_settings:
            yield chunk


def _find_request(file: Path) -> Chunk:
    """Return the request of a file of solved points; if it is lost, take it from the file."""
    request = file.with_suffix(".json")
    if request.exists():
        text = request.read_bytes()
        if hashlib.sha256(text).hexdigest()[:16] == file.stem:
            return Chunk(**json.loads(text))
    return Chunk(**configuration_of(read_dataset(file, scene_id=file.stem)))


def write_request(chunk: Chunk, folder: Path) -> None:
    """Write the request of a chunk into a file of its own, which is read faster than its data."""
    with complete_file(folder / f"{chunk.name}.json") as unfinished:
        unfinished.write_text(chunk.as_json(), encoding="utf-8")


def locate(chunk: Chunk, campaign: Campaign) -> np.ndarray:
    """Return flat index into the grid of a campaign of each point (lines, fast), −1 outside it."""
    [(fast, _)] = chunk.fast.items()
    index, outside = np.zeros((1, 1), dtype=np.int64), np.zeros((1, 1), dtype=bool)
    for name, values in campaign.grid.items():
        column = chunk.fast[name] if name == fast else chunk.lines[name]
        position = _positions(tuple(column), values)
        position = position[None, :] if name == fast else position[:, None]
        index = index * len(values) + position
        outside = outside | (position < 0)
    return np.where(outside, -1, index)


def _positions(column: tuple, values: tuple) -> np.ndarray:
    where = {value: position for position, value in enumerate(values)}
    return np.array([where.get(value, -1) for value in column], dtype=np.int64)


def cut(campaign: Campaign, missing: np.ndarray, chunk_points: int) -> Iterator[Chunk]:
    """Cut the missing points of a grid into chunks of at most so many points, tile by tile."""
    *slow, fast = campaign.grid
    rows = missing.reshape(-1, missing.shape[-1])
    for block in _even_parts(range(rows.shape[1]), chunk_points):
        for lines in _even_parts(range(rows.shape[0]), max(1, chunk_points // len(block))):
            tile = rows[lines.start : lines.stop, block.start : block.stop]
            for pattern, members in _groups(tile):
                values = campaign.grid[fast][block.start : block.stop]
                wanted = [values[position] for position in np.flatnonzero(pattern)]
                # A grid of one axis has a single line, without coordinates.
                members += lines.start
                places = np.unravel_index(members, campaign.shape[:-1]) if slow else ()
                columns = {
                    name: [campaign.grid[name][position] for position in column]
                    for name, column in zip(slow, places, strict=True)
                }
                yield Chunk(campaign.file.kind, campaign.settings, columns, {fast: wanted})


def _groups(rows: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Patterns of missing points along a line, each with the lines that have it."""
    groups: dict[bytes, list[int]] = {}
    for number in np.flatnonzero(rows.any(axis=1)):
        groups.setdefault(rows[number].tobytes(), []).append(int(number))
    for members in groups.values():
        yield rows[members[0]], np.array(members)


def _even_parts(items: range, most: int) -> Iterator[range]:
    """Consecutive parts of nearly equal length, none longer than `most`."""
    parts = -(-len(items) // most)
    ends = [round(len(items) * part / parts) for part in range(parts + 1)]
    for first, last in pairwise(ends):
        yield items[first:last]
