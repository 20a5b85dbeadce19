"""What of a campaign is still to be solved, cut into chunks that are worth a job each.

A chunk is a set of lines by a block of the fast axis.  Its *request* holds kind, settings and
points, so that a job needs nothing else; it is named after a digest of them.  Solved chunks are
recognised by the points they hold, wherever these stand in the grid now, so a campaign may grow
along any axis, let an axis go, or turn a fixed parameter into one.

Missing lines are grouped by which of their points are missing: all of a new line, or only the new
values of the fast axis.  A group is cut into chunks of at most the wanted number of points, first
across lines, and across the fast axis only where one line alone is longer than a chunk.
"""

import hashlib
import json
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np

from granular_fronts.campaign.definition import Campaign
from granular_fronts.errors import InputError
from granular_fronts.output.datasets import DatasetError, configuration_of, read_dataset
from granular_fronts.output.files import complete_file, read_json

IDENTITY = "campaign.json"


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
        """The request, always written the same way."""
        return json.dumps(self._asdict(), sort_keys=True)

    def points(self) -> dict[str, np.ndarray]:
        """Every parameter at every point, arrays of shape (lines, fast)."""
        [(fast, values)] = self.fast.items()
        lines = len(next(iter(self.lines.values()), [None]))
        given = {name: np.array(column)[:, None] for name, column in self.lines.items()}
        given[fast] = np.array(values)[None, :]
        if "beta" in given and given["beta"].dtype == object:
            given["beta"] = given["alpha"]
        shape = (lines, len(values))
        return {name: np.broadcast_to(value, shape) for name, value in given.items()}


def find_missing(campaign: Campaign, folder: Path) -> tuple[list[str], np.ndarray]:
    """Lay the solved chunks of a folder over the grid; requests that are lost are written again.

    Parameters
    ----------
    campaign : Campaign
    folder : Path
        The campaign's folder of chunks.

    Returns
    -------
    solved : list of str
        Names of the solved chunks that hold points of the grid.
    missing : ndarray of bool
        Of the shape of the grid, true where no solved chunk holds the point.
    """
    missing = np.ones(campaign.size, dtype=bool)
    solved = []
    for chunk in solved_chunks(campaign, folder):
        where = locate(chunk, campaign)
        where = where[where >= 0]
        if missing[where].any():
            missing[where] = False
            solved.append(chunk.name)
            write_request(chunk, folder)
    return solved, missing.reshape(campaign.shape)


def claim_folder(campaign: Campaign, folder: Path) -> None:
    """Mark a folder as a campaign's, or raise if it belongs to another.

    Parameters
    ----------
    campaign : Campaign
    folder : Path

    Raises
    ------
    InputError
        If it carries another name or kind.
    """
    identity = {"campaign": campaign.name, "kind": campaign.kind_name}
    mark = folder / IDENTITY
    if not mark.exists():
        with complete_file(mark) as unfinished:
            unfinished.write_text(json.dumps(identity) + "\n", encoding="utf-8")
        return
    found = read_json(mark)
    if found != identity:
        raise InputError(
            f"Campaign {campaign.name}: {folder} holds the results of campaign "
            f"{found['campaign']} of kind {found['kind']}, not of {campaign.name} of kind "
            f"{campaign.kind_name}: name another results folder, or remove that one."
        )


def solved_chunks(campaign: Campaign, folder: Path) -> Iterator[Chunk]:
    """Chunks in a folder that are solved with the campaign's settings, in the order of names."""
    for file in sorted(folder.glob("*.nc")):
        request = file.with_suffix(".json")
        if is_request(request):
            chunk = read_request(request)
        else:
            try:
                chunk = Chunk(**configuration_of(read_dataset(file, scene_id=file.stem)))
            except DatasetError:
                continue  # It is solved again.
        same_parameters = {*chunk.lines, *chunk.fast} == {*campaign.grid}
        same_settings = (chunk.kind, chunk.settings) == (campaign.kind_name, campaign.settings)
        if same_parameters and same_settings:
            yield chunk


def read_request(path: Path) -> Chunk:
    """Read the request of a chunk."""
    return Chunk(**read_json(path))


def is_request(path: Path) -> bool:
    """Whether there is a whole request, by the digest that is its name."""
    return path.exists() and hashlib.sha256(path.read_bytes()).hexdigest()[:16] == path.stem


def write_request(chunk: Chunk, folder: Path) -> None:
    """Write the request of a chunk unless it is there: a newer date would solve it again."""
    path = folder / f"{chunk.name}.json"
    if not is_request(path):
        with complete_file(path) as unfinished:
            unfinished.write_text(chunk.as_json(), encoding="utf-8")


def locate(chunk: Chunk, campaign: Campaign) -> np.ndarray:
    """Place the points of a chunk on the grid of a campaign.

    Parameters
    ----------
    chunk : Chunk
    campaign : Campaign
        Of the same kind.

    Returns
    -------
    ndarray of int, shape (lines, fast)
        Flat index into the grid, −1 for points outside it.
    """
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
    """Cut the missing points into chunks.

    Parameters
    ----------
    campaign : Campaign
    missing : ndarray of bool
        Of the shape of the grid.
    chunk_points : int
        Most points of a chunk.

    Yields
    ------
    Chunk
    """
    *slow, fast = campaign.grid
    rows = missing.reshape(-1, missing.shape[-1])
    for pattern, members in _groups(rows):
        wanted = [campaign.grid[fast][position] for position in np.flatnonzero(pattern)]
        for block in _even_parts(wanted, chunk_points):
            for part in _even_parts(members, max(1, chunk_points // len(block))):
                # A grid of one axis has a single line, without coordinates.
                positions = np.unravel_index(np.array(part), campaign.shape[:-1]) if slow else ()
                columns = {
                    name: [campaign.grid[name][position] for position in column]
                    for name, column in zip(slow, positions, strict=True)
                }
                yield Chunk(campaign.kind_name, campaign.settings, columns, {fast: block})


def _groups(rows: np.ndarray) -> Iterator[tuple[np.ndarray, list[int]]]:
    """Patterns of missing points along a line, each with the lines that have it."""
    groups: dict[bytes, list[int]] = {}
    for number in np.flatnonzero(rows.any(axis=1)):
        groups.setdefault(rows[number].tobytes(), []).append(int(number))
    for members in groups.values():
        yield rows[members[0]], members


def _even_parts(items: list, most: int) -> Iterator[list]:
    """Consecutive parts of nearly equal length, none longer than `most`."""
    parts = -(-len(items) // most)
    ends = [round(len(items) * part / parts) for part in range(parts + 1)]
    for first, last in pairwise(ends):
        yield items[first:last]
