"""Files appear complete or not at all; killed writers leave nothing; a full disk is named."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from granular_fronts.arguments import new_file
from granular_fronts.errors import InputError, NoSpaceError
from granular_fronts.output.files import HOST, complete_file, remove_leftovers

ABOVE_ANY_PROCESS = 2**22 + 1
"""Linux numbers no process above 2^22."""


def fill(path, text="all of it"):
    with complete_file(path) as unfinished:
        unfinished.write_text(text)


def test_a_failed_write_leaves_nothing(tmp_path):
    def fail():
        with complete_file(tmp_path / "result.txt") as unfinished:
            unfinished.write_text("half")
            raise RuntimeError("something else")

    with pytest.raises(RuntimeError, match="something else"):
        fail()
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("make", [os.mkfifo, os.mkdir, lambda path: path.symlink_to("/dev/null")])
def test_only_a_file_is_replaced(tmp_path, make):
    target = tmp_path / "result.nc"
    make(target)
    with pytest.raises(InputError, match=r"result\.nc is no file that can be replaced"):
        fill(target)
    with pytest.raises(InputError, match="must be a file in a folder that exists"):
        new_file("path", target)
    assert not target.is_file()
    assert list(tmp_path.iterdir()) == [target]


def test_an_interrupted_write_keeps_the_old_file(tmp_path):
    target = tmp_path / "result.txt"
    target.write_text("old")
    with complete_file(target) as unfinished:
        unfinished.write_text("new")
        assert target.read_text() == "old"
    assert target.read_text() == "new"
    assert list(tmp_path.iterdir()) == [target]


SLEEPER = """
import sys, time
from pathlib import Path
from granular_fronts.output.files import complete_file
with complete_file(Path(sys.argv[1])) as unfinished:
    unfinished.write_text("half")
    print("begun", flush=True)
    time.sleep(60)
"""


@pytest.fixture
def writer(tmp_path):
    """A process that is in the middle of writing result.txt."""
    command = [sys.executable, "-c", SLEEPER, str(tmp_path / "result.txt")]
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2] / "src")}
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
    assert process.stdout.readline() == "begun\n"
    yield process
    process.kill()
    process.communicate()


def test_what_a_killed_writer_leaves_is_removed_by_the_next(tmp_path, writer):
    writer.kill()
    writer.wait()
    other = tmp_path / f"unfinished-{HOST}-{ABOVE_ANY_PROCESS}-other.txt"
    other.touch()
    assert len(list(tmp_path.iterdir())) == 2
    fill(tmp_path / "result.txt")
    assert {file.name for file in tmp_path.iterdir()} == {"result.txt", other.name}
    remove_leftovers(tmp_path)
    assert [file.name for file in tmp_path.iterdir()] == ["result.txt"]


def test_what_a_running_writer_has_begun_is_left_alone(tmp_path, writer):
    begun = tmp_path / f"unfinished-{HOST}-{writer.pid}-result.txt"
    fill(tmp_path / "result.txt")
    remove_leftovers(tmp_path)
    assert begun.exists()


def write_to_full_disk(path, error):
    """Every write to /dev/full fails as on a disk without space."""
    with complete_file(path) as unfinished:
        unfinished.symlink_to("/dev/full")
        if error:
            raise error
        unfinished.write_text("too much")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full here")
@pytest.mark.parametrize("error", [None, RuntimeError("NetCDF: HDF error")], ids=["system", "HDF"])
def test_full_disk_is_named_with_its_folder(tmp_path, error):
    with pytest.raises(NoSpaceError) as caught:
        write_to_full_disk(tmp_path / "result.nc", error)
    sentence = f"There is no space left in {tmp_path}: free some and run the same command again."
    assert str(caught.value) == sentence
    assert not list(tmp_path.iterdir())


def test_another_error_is_not_taken_for_a_full_disk(tmp_path):
    def fail():
        with complete_file(tmp_path / "result.nc"):
            raise OSError("NetCDF: HDF error")

    with pytest.raises(OSError, match="HDF error") as caught:
        fail()
    assert not isinstance(caught.value, NoSpaceError)
    assert not list(tmp_path.iterdir())


LIMITED = """
import resource, signal, sys
import numpy as np, xarray as xr
from granular_fronts.errors import NoSpaceError
from granular_fronts.output.files import complete_file
resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000))
data = xr.Dataset({"u": ("x", np.random.default_rng(1).random(100_000))})
try:
    with complete_file(sys.argv[1]) as unfinished:
        data.to_netcdf(unfinished, engine="netcdf4")
except NoSpaceError as error:
    print(error)
"""


def test_netcdf_file_that_may_not_grow_is_named(tmp_path):
    """The netCDF library alone says no more than "HDF error"."""
    command = [sys.executable, "-c", LIMITED, str(tmp_path / "result.nc")]
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2] / "src")}
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert f"There is no space left in {tmp_path}" in run.stdout, run.stderr
    assert not list(tmp_path.iterdir())
