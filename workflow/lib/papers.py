"""Papers of others: each is a folder of ``papers`` whose `paper.yaml` adds to the lists.

Its `scenes` are like those of config/default.yaml.  Its `figures` and `tables` are like the files
of these names in ``workflow``.  Its `studies` have the `folder` of their dataset, a `function` of
the package, the `kernels` that it needs, and its `parameters`.  Every name begins with that of the
paper's folder, so that no two papers share one. All is made on demand.  The folder ``weak_damping``
is about no paper, and has findings alone.
"""

from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from granular_fronts.errors import InputError
from granular_fronts.scenes.configuration import SCENES
from granular_fronts.scenes.yaml_files import read_yaml

FOLDER = Path(__file__).parents[2] / "papers"
LISTS = "scenes", "studies", "figures", "tables"


@cache
def papers() -> dict[str, dict[str, Any]]:
    """Return what each paper lists, by the name of its folder.

    Raises
    ------
    InputError
        With a sentence for the first thing in a `paper.yaml` that is wrong.
    """
    return {file.parent.name: _read_paper(file) for file in sorted(FOLDER.glob("*/paper.yaml"))}


def scenes_of_papers(family: str) -> dict[str, Any]:
    """Return the scenes of a family that papers have, by their names."""
    return _joined(paper["scenes"].get(family, {}) for paper in papers().values())


def listed_in_papers(kind: str) -> dict[str, Any]:
    """Return the studies, figures or tables of all papers by their names."""
    return _joined(paper[kind] for paper in papers().values())


def _joined(parts: Iterator[dict[str, Any]]) -> dict[str, Any]:
    return {name: one for part in parts for name, one in part.items()}


def _read_paper(file: Path) -> dict[str, Any]:
    """Return what a paper lists, each list in full, and each entry with the paper's folder."""
    paper, given = file.parent.name, read_yaml(file)
    if unknown := sorted(set(given) - {"title", *LISTS}):
        raise InputError(f"{file} has {unknown[0]}: its keys are title, {', '.join(LISTS)}.")
    listed = {kind: given.get(kind, {}) for kind in LISTS}
    if strange := sorted(set(listed["scenes"]) - set(SCENES)):
        raise InputError(f"{file} has scenes.{strange[0]}: choose {' or '.join(SCENES)}.")
    lists = [*listed["scenes"].values(), *(listed[kind] for kind in LISTS[1:])]
    for name in [name for one in lists for name in one]:
        if not name.startswith(f"{paper}_"):
            raise InputError(f"{file} names {name}, but its names begin with {paper}_: rename it.")
    for family, scenes in listed["scenes"].items():
        for name, scene in scenes.items():
            SCENES[family].read(scene, name)
    place = {"on_demand": True, "folder": f"papers/{paper}"}
    for kind in ("figures", "tables"):
        listed[kind] = {name: one | place for name, one in listed[kind].items()}
    return {"title": given.get("title", paper), **listed}
