"""One run at a time in a results folder, and no job that outlives its run.

Snakemake's own lock is a file that a killed run leaves behind, and that only a flag removes. The
lock of the operating system (``flock``) is released when the process that holds it ends, however it
ends.  So the same command goes on after a crash. Jobs on the same machine wait for the same lock.
A job that gets it has outlived its run, and ends before it overwrites the files of a later run.
"""

import fcntl
import os
import threading
from contextlib import suppress
from pathlib import Path

LOCK_VARIABLE = "GRANULAR_FRONTS_RUN_LOCK"  # Of the environment: names the locked file to jobs.


def lock_folder(folder: Path) -> int:
    """Lock a results folder until the process ends or the returned descriptor is closed.

    Raises SystemExit with a sentence for people if another run works there.
    """
    folder.mkdir(parents=True, exist_ok=True)
    file = os.path.abspath(folder / ".lock")
    lock = os.open(file, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(lock)
        raise SystemExit(
            f"Another run, or a job that it left, is at work in {folder}: wait for its end, or "
            "name another folder (--config results=...)."
        ) from None
    os.environ[LOCK_VARIABLE] = file
    return lock


def end_with_run() -> None:
    """End this process when the run that started it has ended, however it did."""
    if file := os.environ.get(LOCK_VARIABLE):
        threading.Thread(target=_end_after, args=[file], daemon=True).start()


def _end_after(file: str) -> None:
    with suppress(FileNotFoundError), open(file, encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_SH)  # Waits until the run releases it.
        os._exit(1)
