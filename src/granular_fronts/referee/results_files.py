"""Read the results of a code: dumps of LAMMPS, or tables with the columns t, bead, x, v.

A file is named PROBLEM_STEP.dump or PROBLEM_STEP.csv, for example ``front_steel_dashpot_0.05.csv``.
In a table x is the displacement of a bead from where it just touches, or its position in diameters
with bead 1 at 0.  Times and beads may come in any order.
"""

import csv
import math
import reprlib
from pathlib import Path
from typing import NamedTuple

import numpy as np

from granular_fronts.errors import InputError

COLUMNS = ("t", "bead", "x", "v")


class Result(NamedTuple):
    """A motion as somebody's code computed it: step h, t (T,), displacements x and v (T, N)."""

    problem: str
    step: float
    t: np.ndarray
    x: np.ndarray
    v: np.ndarray


def read_result(path, problems):
    """Read a file, whose name says step and problem, one of `problems`.

    An InputError says that there is no such file or problem, or why the file cannot be read.
    """
    path = Path(path)
    problem, step = _read_name(path, problems)
    if not path.is_file():
        raise InputError(f"There is no file {path}: name one that exists.")
    rows = _lammps_rows(path) if path.suffix == ".dump" else _table_rows(path)
    t, x, v = _by_time_and_bead(path, rows)
    _check_last_line(path)
    return Result(problem, step, t, _displacements(x), v)


def _check_last_line(path):
    """A file that was cut inside its last number still ends with a number, but not with a line."""
    if not path.read_bytes().endswith((b"\n", b"\r")):
        raise InputError(
            f"{path} ends inside a line, so its last number may be cut off: "
            "write the file again, or end the line."
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


def _lammps_rows(path):
    """Return the rows (t, bead, x, v) of a dump with ``dump_modify time yes``."""
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    rows, time, at = [], None, 0
    while at < len(lines):
        head = lines[at]
        if head == "ITEM: TIME":
            time = _number(path, *lines[at + 1 : at + 2])
        if not head.startswith("ITEM: ATOMS"):
            at += 1
            continue
        names = head.split()[2:]
        if not {"id", "x", "vx"} <= set(names) or time is None:
            raise InputError(
                f"{path} holds {' '.join(names)} and {'no' if time is None else 'the'} time, but "
                "id, x, vx and the time are needed: dump custom … id x vx, with dump_modify … "
                "time yes."
            )
        chosen = [names.index(name) for name in ("id", "x", "vx")]
        at += 1
        while at < len(lines) and not lines[at].startswith("ITEM:"):
            words = lines[at].split()
            rows.append((time, *(_number(path, *words[one : one + 1]) for one in chosen)))
            at += 1
    return rows


def _table_rows(path):
    """Return the rows (t, bead, x, v) of a table; lines that begin with # are comments."""
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
    return [tuple(_number(path, row[name]) for name in COLUMNS) for row in rows]


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
        raise InputError(f"{path} holds {text!r}, so that the run was lost: take a smaller step.")
    return found


def _by_time_and_bead(path, rows):
    if not rows:
        raise InputError(f"{path} holds no states: write some.")
    table = np.array(rows)
    t, beads = np.unique(table[:, 0]), np.unique(table[:, 1])
    states = np.unique(table[:, :2], axis=0).shape[0]
    numbered = np.array_equal(beads, np.arange(1, beads.size + 1))
    if not (states == table.shape[0] == t.size * beads.size and numbered):
        raise InputError(
            f"{path} has {table.shape[0]} rows for {t.size} times and beads {beads[0]:g} to "
            f"{beads[-1]:g}: give each bead, from 1 on, once at each time."
        )
    x, v = table[np.lexsort((table[:, 1], table[:, 0]))][:, 2:].T.reshape(2, t.size, beads.size)
    return t, x, v


def _displacements(x):
    """Return the displacements: x, less the places where beads just touch if it holds positions."""
    beads = np.arange(x.shape[1])
    return x - beads if np.mean(np.diff(x[0])) > 0.5 else x
