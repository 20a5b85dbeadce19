"""Files appear complete or not at all; killed writers leave nothing; a full disk is named."""

import os
import resource
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from granular_fronts.arguments import new_file
from granular_fronts.errors import InputError, NoSpaceError
from granular_fronts.output.files import HOST, complete_file, is_running, remove_leftovers
from projects import ROOT

ABOVE_ANY_PROCESS = 2**22 + 1
"""Linux numbers no process above 2^22."""

ENVIRONMENT = os.environ | {"PYTHONPATH": str(ROOT / "src")}


def fill(path, error=None):
    with complete_file(path) as unfinished:
        unfinished.write_text("all of it")
        if error:
            raise error


def test_a_file_is_replaced_when_its_successor_is_complete_and_not_before(tmp_path):
    target = tmp_path / "result.txt"
    fill(target)
    target.write_text("old")
    # Another error of the netCDF library is not taken for a full disk.
    for error in (RuntimeError("something else"), OSError("NetCDF: HDF error")):
        with pytest.raises(type(error), match=str(error)) as caught:
            fill(target, error)
        assert not isinstance(caught.value, NoSpaceError)
        assert target.read_text() == "old"
    with complete_file(target) as unfinished:
        unfinished.write_text("new")
        assert target.read_text() == "old"
    assert target.read_text() == "new"
    assert list(tmp_path.iterdir()) == [target]


@pytest.mark.parametrize("make", [os.mkfifo, os.mkdir, lambda path: path.symlink_to("/dev/null")])
def test_only_a_file_is_replaced(tmp_path, make):
    target = tmp_path / "result.nc"
    make(target)
    with pytest.raises(InputError, match=r"result\.nc is no file"):
        fill(target)
    with pytest.raises(InputError, match="must be a file"):
        new_file("path", target)
    assert not target.is_file()
    assert list(tmp_path.iterdir()) == [target]


SLEEPER = """
import sys
from granular_fronts.output.files import complete_file
with complete_file(sys.argv[1]) as unfinished:
    unfinished.write_text("half")
    print("begun", flush=True)
    sys.stdin.read()
"""


def test_what_a_killed_writer_leaves_is_removed_and_what_a_running_one_has_begun_is_not(tmp_path):
    target = tmp_path / "result.txt"
    command = [sys.executable, "-c", SLEEPER, str(target)]
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with subprocess.Popen(command, **pipes, text=True, env=ENVIRONMENT) as writer:
        assert writer.stdout.readline() == "begun\n"
        begun = tmp_path / f"unfinished-{HOST}-{writer.pid}-result.txt"
        fill(target)
        remove_leftovers(tmp_path)
        assert begun.exists()
        writer.kill()
    other = tmp_path / f"unfinished-{HOST}-{ABOVE_ANY_PROCESS}-other.txt"
    other.touch()
    fill(target)
    assert set(tmp_path.iterdir()) == {target, other}
    remove_leftovers(tmp_path)
    assert list(tmp_path.iterdir()) == [target]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full here")
@pytest.mark.parametrize("error", [None, RuntimeError("NetCDF: HDF error")], ids=["system", "HDF"])
def test_full_disk_is_named_with_its_folder(tmp_path, error):
    """Every write to /dev/full fails as on a disk without space."""

    def write():
        with complete_file(tmp_path / "result.nc") as unfinished:
            unfinished.symlink_to("/dev/full")
            if error:
                raise error
            unfinished.write_text("too much")

    with pytest.raises(NoSpaceError, match=f"no space left in {tmp_path}"):
        write()
    assert not list(tmp_path.iterdir())


def test_netcdf_file_that_may_not_grow_is_named(tmp_path):
    """The netCDF library alone says no more than "HDF error"."""
    data = xr.Dataset({"u": ("x", np.random.default_rng(1).random(100_000))})
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, hard))
    try:
        with (
            pytest.raises(NoSpaceError, match=f"no space left in {tmp_path}"),
            complete_file(tmp_path / "result.nc") as unfinished,
        ):
            data.to_netcdf(unfinished, engine="netcdf4")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert not list(tmp_path.iterdir())


def test_a_process_of_another_user_runs(monkeypatch):
    def forbidden(process, signal):
        raise PermissionError

    monkeypatch.setattr(os, "kill", forbidden)
    assert is_running(1)
