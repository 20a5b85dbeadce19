"""Files that appear under their name only when they are complete, and a full disk named as such.

A file is written under the name ``unfinished-HOST-PID-NAME`` and renamed once all of it is on the
disk.  A killed process leaves its unfinished file behind.  The next process on that machine that
writes the same file removes it.
"""

import errno
import os
import platform
import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TypeGuard

from granular_fronts.errors import InputError, NoSpaceError

FULL_DISK = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG})
"""The system's answers where a disk or the user's share of it is full, or a file may not grow."""

PROBE_BYTES = 2**20

HOST = re.sub(r"\W", "_", platform.node())
"""Name of this machine, without signs that a name of a file should not have."""


@contextmanager
def complete_file(path: Path | str) -> Iterator[Path]:
    """Give the name of a file to fill; it takes its final name when the block ends well.

    Parameters
    ----------
    path : Path or str
        Final name. The folder is made if it is missing.

    Yields
    ------
    Path
        A name in the same folder and with the same ending. If the block fails, nothing is left.

    Raises
    ------
    InputError
        If something lies there that is no file: a folder, a device or a pipe is never replaced.
    NoSpaceError
        If the block fails because the disk is full.
    """
    path = Path(path)
    if path.exists() and not path.is_file():
        raise InputError(f"{path} is no file that can be replaced: name another one.")
    unfinished = path.with_name(f"unfinished-{HOST}-{os.getpid()}-{path.name}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        remove_leftovers(path.parent, path.name)
        yield unfinished
        _store(unfinished)
        os.replace(unfinished, path)
    except (OSError, RuntimeError) as error:
        # The netCDF library says "HDF error", and not why a write failed.
        if is_full(error) or _is_disk_full(unfinished):
            raise NoSpaceError(path.parent) from error
        raise
    finally:
        with suppress(FileNotFoundError, NotADirectoryError):
            unfinished.unlink()


def is_full(error: BaseException) -> TypeGuard[OSError]:
    """Return whether an error is the system's answer that a disk is full."""
    return isinstance(error, OSError) and error.errno in FULL_DISK


def remove_leftovers(folder: Path, name: str | None = None) -> None:
    """Remove the unfinished files, of one final name or of all, whose process has ended."""
    written = ".+" if name is None else re.escape(name)
    pattern = re.compile(rf"unfinished-{re.escape(HOST)}-(\d+)-{written}")
    with os.scandir(folder) as entries:
        for entry in entries:
            match = pattern.fullmatch(entry.name)
            if match and not is_running(int(match[1])):
                Path(entry.path).unlink(missing_ok=True)


def is_running(process: int) -> bool:
    """Return whether there is a process of this number on this machine."""
    try:
        os.kill(process, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except PermissionError:
        return True
    return True


def _store(file: Path) -> None:
    """Wait until a file is on the disk, so that a machine that stops leaves no empty one."""
    with open(file, "rb") as opened:
        os.fsync(opened.fileno())


def _is_disk_full(file: Path) -> bool:
    """Return whether a file that could not be written has no room to grow, found by trying it."""
    try:
        with open(file, "ab") as opened:
            opened.write(bytes(PROBE_BYTES))
            opened.flush()
            os.fsync(opened.fileno())
    except OSError as error:
        return is_full(error)
    return False
