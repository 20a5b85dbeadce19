"""Read the results of a code: dumps of LAMMPS or LIGGGHTS, or tables with columns t, bead, x, v.

A file is named PROBLEM_STEP.dump or PROBLEM_STEP.csv, for example ``front_steel_dashpot_0.05.csv``.
In a table x is the displacement of a bead from where it just touches, or its position in diameters
with bead 1 at 0.  Times and beads may come in any order.
"""

import csv
import math
import re
import reprlib
from collections import defaultdict
from itertools import zip_longest
from pathlib import Path
from typing import NamedTuple

import numpy as np

from granular_fronts.errors import InputError

COLUMNS = ("t", "bead", "x", "v")
POSITIONS = ("xu", "xsu", "x", "xs")  # of a dump: s in lengths of the box, u not wrapped into it

ALL_DIGITS = 17  # of numbers of double precision
SAME_STEP = 0.01  # share by which the step in a name may be rounded
SAME_TIME = 1.0e-9  # distance of two times that count as one, over the last time

# How files of other formats begin.
FORMATS = {
    rb"\s*$": "empty",
    rb"\x1f\x8b": "compressed by gzip (unpack it)",
    rb"BZh|\xfd7zXZ|\x28\xb5\x2f\xfd": "compressed by bzip2, xz or zstd (unpack it)",
    rb"PK\x03\x04": "a ZIP archive, as spreadsheets are",
    rb".{8}DUMP": "a binary dump of LAMMPS",
    rb"(?i)LAMMPS (Restart|data|\()": "a restart, data or log file of LAMMPS",
    rb"(ITEM: .*)?ITEM: (ENTRIES|GRID)": "a dump local or grid of LAMMPS, not of beads",
    rb"---\s": "YAML",
    rb"\d+\r?\nAtoms|Number of particles": "an XYZ or CFG file",
    rb".{4}CORD|\0\0\x07\xcb": "a DCD or XTC file, without velocities",
    rb"# vtk|<VTK|<\?xml": "a VTK file",
    rb"\x89HDF|CDF[\1-\5]": "HDF5 or netCDF",
    rb"\xff\xfe|\xfe\xff": "text in UTF-16",
    rb"[^\0]*\0": "binary, of a format unknown here",
    rb"\s*[{\[]": "JSON",
}


class Result(NamedTuple):
    """A motion as somebody's code computed it: step h, t (T,), displacements x and v (T, N).

    `digits` are the significant ones in its file; they round x and v by up to `rounding`.
    """

    problem: str
    step: float
    t: np.ndarray
    x: np.ndarray
    v: np.ndarray
    digits: int = ALL_DIGITS
    rounding: tuple[float, float] = (0.0, 0.0)


def read_results(paths, problems):
    """Read files, of which each problem has one for a step, and return lists by problem.

    The largest step comes first.  An InputError says which file cannot be read, or is too many.
    """
    found = defaultdict(list)
    for result in (read_result(path, problems) for path in paths):
        if any(result.step == other.step for other in found[result.problem]):
            raise InputError(
                f"{result.problem} is there twice with step {result.step:g}: give each step once."
            )
        found[result.problem].append(result)
    return {
        name: sorted(results, key=lambda result: -result.step) for name, results in found.items()
    }


def read_result(path, problems):
    """Read a file, whose name says step and problem, one of `problems`.

    An InputError says that there is no such file or problem, or why the file cannot be read.
    """
    path = Path(path)
    if not path.is_file():
        raise InputError(f"There is no file {path}: name one that exists.")
    _check_format(path)
    problem, step = _read_name(path, problems)
    parts = _read_dump(path, step) if path.suffix == ".dump" else _read_table(path)
    if not parts:
        raise InputError(f"{path} holds no states: write ITEM: ATOMS, or rows of a table.")
    rows, written, counts, boxes = zip(*parts, strict=True)
    t, x, v = _by_time_and_bead(path, np.concatenate(rows))
    for times, steps in (t, np.full(t.size, np.nan)), ([one[0, 0] for one in rows], counts):
        _check_step(path, step, np.array(times), np.array(steps))
    if np.abs(np.diff(x, axis=0)).max(initial=0.0) > 0.5 * min(boxes):
        raise InputError(
            f"{path} has beads that move by half the box between two states: if x was wrapped "
            "into it, write ix too, or xu in place of x."
        )
    digits, decades = np.max(written, axis=0).T
    rounding = np.where(digits < ALL_DIGITS, 0.5 * 10.0 ** (decades - digits), 0.0)
    return Result(problem, step, t, _displacements(x), v, int(min(digits)), tuple(rounding))


def _check_format(path):
    """Name a file of another format by what it is, and one that was cut."""
    content = path.read_bytes()
    for mark, kind in FORMATS.items():
        if re.match(mark, content[:1000], re.DOTALL):
            raise InputError(
                f"{path} is {kind}: give a dump custom of LAMMPS as text, or a table with the "
                f"columns {', '.join(COLUMNS)}."
            )
    # A file that was cut inside its last number still ends with a number, but not with a line.
    if not content.endswith((b"\n", b"\r")):
        raise InputError(
            f"{path} ends inside a line, so its last number may be cut off: "
            "write the file again, or end the line."
        )


def _check_step(path, step, times, counts):
    """Check that times lie as many steps apart as are counted, or if none are a whole number."""
    passed, counted = np.diff(times) / step, np.diff(counts)
    steps = np.where(np.isnan(counted), np.maximum(np.round(passed), 1.0), counted)
    off = (passed > 0.0) & (steps > 0.0) & (np.abs(passed - steps) > SAME_STEP * steps)
    for at in np.flatnonzero(off)[:1]:
        told = "a whole number" if np.isnan(counted[at]) else f"TIMESTEP's {steps[at]:g}"
        raise InputError(
            f"{path.name} says step {step:g}, but t = {times[at]:g} and {times[at + 1]:g} are "
            f"{passed[at]:.4g} of these apart, not {told}: name the file after its step."
        )


def _read_name(path, problems):
    problem, _, step = path.stem.rpartition("_")
    try:
        h = float(step)
    except ValueError:
        h = math.nan
    if not (path.suffix in (".dump", ".csv") and 0.0 < h < math.inf):
        raise InputError(
            f"{path.name} does not say what it is: call it PROBLEM_STEP.dump, or PROBLEM_STEP.csv, "
            "for example front_steel_viscoelastic_0.05.dump."
        )
    if problem not in problems:
        raise InputError(
            f"{path.name} is about {problem or 'nothing'}, but the problems are "
            f"{', '.join(problems)}: name the file after one of them."
        )
    return problem, h


def _read_dump(path, step):
    """Return what `_read_frame` finds in each frame that holds beads."""
    frames = [{}]
    for part in path.read_text(encoding="utf-8", errors="replace").split("ITEM: ")[1:]:
        title, *lines = part.splitlines()
        if "ATOMS" in frames[-1]:
            frames.append({})
        name = re.match("[A-Z ]*", title)[0]
        frames[-1][name.strip()] = title.removeprefix(name).split(), lines
    return [_read_frame(path, frame, step) for frame in frames if frame.get("ATOMS", [[], []])[1]]


def _read_frame(path, sections, step):
    """Turn a frame into rows (t, bead, x, v) by all that its header says.

    The time is TIME, or else TIMESTEP × step.  By BOX BOUNDS ix unwraps x, and xs becomes x.  Also
    return `_written` of x and v, TIMESTEP or NaN, and the length of the box, infinite unless x may
    be wrapped into it nobody knows how often.
    """
    names, lines = sections["ATOMS"]
    name = next((one for one in POSITIONS if one in names), "x")
    count, time = (
        _number(path, *sections[title][1][:1]) if title in sections else math.nan
        for title in ("TIMESTEP", "TIME")
    )
    t = count * step if math.isnan(time) else time
    if not {"id", name, "vx"} <= set(names) or math.isnan(t):
        raise InputError(
            f"{path} holds {' '.join(names)} and {'no' if math.isnan(t) else 'the'} time, but id, "
            f"vx, one of {', '.join(POSITIONS)}, and the time are needed: dump custom … id x vx."
        )
    table = zip_longest(names, *map(str.split, lines), fillvalue="")
    words = {column[0]: column[1:] for column in table}
    beads, raw, v = (_numbers(path, words[one]) for one in ("id", name, "vx"))
    scaled, wrapped = "s" in name, "u" not in name
    images = _numbers(path, words["ix"]) if wrapped and "ix" in names else np.zeros(raw.size)
    kinds, lines = sections.get("BOX BOUNDS", ([], []))
    ends = [_numbers(path, line.split()) for line in lines[:3]]
    unknown = not ends or "abc" in kinds or any(any(line[2:]) for line in ends)
    low, high = (0.0, math.inf) if unknown else ends[0][:2]
    if math.isinf(high) and (scaled or images.any()):
        raise InputError(
            f"{path} has {name if scaled else 'ix other than 0'}, but no ITEM: BOX BOUNDS of a box "
            "with right angles: write xu in place of x."
        )
    start, unit = (low, high - low) if scaled else (0.0, 1.0)
    x = start + unit * raw + np.where(images == 0.0, 0.0, high - low) * images
    rows = np.column_stack([np.full(x.size, t), beads, x, v])
    written = [_written(words[name], raw, unit), _written(words["vx"], v)]
    return rows, written, count, high - low if wrapped and "ix" not in names else math.inf


def _read_table(path):
    """Return of a table what `_read_frame` does of a dump; lines that begin with # are comments."""
    with path.open(encoding="utf-8-sig", errors="replace", newline="") as file:
        lines = (line for line in file if not line.startswith("#"))
        reader = csv.DictReader(lines, skipinitialspace=True)
        try:
            names, rows = reader.fieldnames or [], list(reader)
        except csv.Error as error:
            raise InputError(
                f"{path} is no table ({error}): write rows of numbers with commas between."
            ) from None
    missing = [name for name in COLUMNS if name not in names]
    if missing:
        raise InputError(
            f"{path} has no column {missing[0]}, but {reprlib.repr(', '.join(names))}: give the "
            f"columns {', '.join(COLUMNS)}, with commas between."
        )
    if None in set().union(*rows):
        raise InputError(
            f"{path} has rows of more than {len(names)} numbers: write decimals with a point."
        )
    if not rows:
        return []
    words = {name: [row[name] for row in rows] for name in COLUMNS}
    t, beads, x, v = (_numbers(path, words[name]) for name in COLUMNS)
    written = [_written(words["x"], x), _written(words["v"], v)]
    return [(np.column_stack([t, beads, x, v]), written, math.nan, math.inf)]


def _numbers(path, words):
    return np.array([_number(path, word) for word in words])


def _number(path, text=""):
    """Return a finite number."""
    try:
        found = float(text)
    except (TypeError, ValueError):
        raise InputError(
            f"{path} holds {reprlib.repr(text or '')} where a number should be: write whole "
            "states, with decimal points."
        ) from None
    if not math.isfinite(found):
        raise InputError(
            f"{path} holds {text!r}, no finite number: if the run was lost, take a smaller step."
        )
    return found


def _written(words, numbers, unit=1.0):
    """Return the most digits of a column, less zeros at their ends, and its largest decade."""
    parts = (word.lower().partition("e")[0].lstrip("+-").replace(".", "") for word in words)
    digits = max(1, *(len(part.strip("0")) for part in parts))
    largest = np.abs(numbers).max() or 1.0
    return digits, math.floor(math.log10(largest)) + 1 + math.log10(unit)


def _by_time_and_bead(path, table):
    """Return t, x and v; states that a restarted run wrote again are dropped if they are equal."""
    times = np.unique(table[:, 0])
    times = times[np.diff(times, prepend=-np.inf) > SAME_TIME * np.abs(times[-1])]
    table[:, 0] = times[np.searchsorted(times, table[:, 0], side="right") - 1]
    table = np.unique(table, axis=0)
    again = (table[1:, :2] == table[:-1, :2]).all(axis=1)
    if again.any():
        time, bead = table[1:][again][0, :2]
        raise InputError(
            f"{path} has bead {bead:g} twice at t = {time:g}, with different numbers: keep the "
            "states of one run."
        )
    t, beads = np.unique(table[:, 0]), np.unique(table[:, 1])
    numbered = np.array_equal(beads, np.arange(1, beads.size + 1))
    if not (table.shape[0] == t.size * beads.size and numbered):
        raise InputError(
            f"{path} has {table.shape[0]} rows for {t.size} times and beads {beads[0]:g} to "
            f"{beads[-1]:g}: give each bead, from 1 on, once at each time."
        )
    x, v = table[:, 2:].T.reshape(2, t.size, beads.size)
    return t, x, v


def _displacements(x):
    """Return the displacements: x, less the places where beads just touch if it holds positions."""
    beads = np.arange(x.shape[1])
    return x - beads if x[0, -1] - x[0, 0] > 0.5 * (beads[-1] - 0.5) else x
