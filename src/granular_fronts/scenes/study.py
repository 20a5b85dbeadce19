"""Studies as ``workflow/studies.yaml`` lists them: each with its section of the configuration."""

import functools
from pathlib import Path
from typing import Any

from granular_fronts.scenes.yaml_files import read_yaml


def find_file(name: str, *folders: str) -> Path:
    """Return a file of the workflow; an installed package has a copy in this folder."""
    copy = Path(__file__).with_name(name)
    return copy if copy.exists() else Path(__file__).parents[3].joinpath("workflow", *folders, name)


@functools.cache
def studies() -> dict[str, dict[str, Any]]:
    """Return every study of ``workflow/studies.yaml`` by its name."""
    return read_yaml(find_file("studies.yaml"))
