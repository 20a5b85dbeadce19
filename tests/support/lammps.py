"""The installed LAMMPS, if it is recent enough for the inputs of the tests."""

import re
import subprocess

import pytest

from granular_fronts.referee.lammps_run import find_lammps

# Debian 12 has a version of 2021, which lacks a damping model and a style of atoms.
FIRST_YEAR = 2022


def find_recent():
    """Return the command, or None where LAMMPS is absent or too old."""
    command = find_lammps()
    if not command:
        return None
    said = subprocess.run([command, "-h"], capture_output=True, text=True, check=False).stdout
    year = re.search(r"Simulator - \d+ \w+ (\d{4})", said)
    return command if year and int(year[1]) >= FIRST_YEAR else None


LAMMPS = find_recent()
needs_lammps = pytest.mark.skipif(not LAMMPS, reason=f"There is no LAMMPS of {FIRST_YEAR} or later")
