"""Files that appear under their name only when they are complete."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


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
    """
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    unfinished = path.with_name(f"unfinished-{os.getpid()}-{path.name}")
    try:
        yield unfinished
        os.replace(unfinished, path)
    finally:
        unfinished.unlink(missing_ok=True)
