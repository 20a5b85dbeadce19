"""One run at a time in a results folder, by a lock that ends with its process.

Snakemake's own lock is a file that a killed run leaves behind, and that only a flag removes. The
lock of the operating system (``flock``) is released when the process that holds it ends, however
it ends, so that after a crash the same command goes on.
"""

import fcntl
from pathlib import Path
from typing import TextIO


class FolderInUseError(Exception):
    """Another run works in the results folder; the message is for people."""


def lock_folder(folder: Path) -> TextIO:
    """Lock a results folder until the process ends or the returned file is closed."""
    folder.mkdir(parents=True, exist_ok=True)
    lock = (folder / ".lock").open("w", encoding="utf-8")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        lock.close()
        raise FolderInUseError(
            f"Another run is at work in {folder}: wait for its end, or name another folder "
            "(--config results=...)."
        ) from None
    return lock
