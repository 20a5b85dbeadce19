"""Draw a figure: datasets in; picture and caption out.

A script of a figure holds one function, which is given datasets and returns a figure.

The caption is a Jinja template.  Its variables are the names of the datasets.  Each is the
configuration of its dataset, so that a caption cannot name other values than the picture shows, and
`measured` in it is the dataset, for sentences that other values would make false.
Where these are not the ones that the figure was made for, the paper's above all, the caption ends
with the difference.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import jinja2
import matplotlib
import xarray as xr
from matplotlib.figure import Figure

from captions import read_texts
from granular_fronts.output.datasets import DatasetError, configuration_of, read_dataset
from granular_fronts.output.departures import describe, physical_departures
from granular_fronts.output.files import complete_file
from granular_fronts.output.style import save_figure


def write_figure(
    draw: Callable[..., Figure],
    texts: str,
    files: Any,
    shown: Mapping[str, Any],
    **paths: str | list[str],
) -> None:
    """Read the datasets of a figure, draw it, and write its files.

    Parameters
    ----------
    draw : callable
        What draws the figure from its datasets.
    texts : str
        File of its title and its caption.
    files : object
        The files to write, as attributes: `pdf`, `png` and `caption`.
    shown : mapping
        For each scene its parameters and the paper's, or None where the paper has no such scene. It
        is empty where nothing is compared with the paper.
    **paths
        For each argument of `draw` the file of a dataset, or a list.
    """
    data = {name: _for_each(lambda path: read_dataset(Path(path)), paths[name]) for name in paths}
    every = [
        one for given in data.values() for one in (given if isinstance(given, list) else [given])
    ]
    matplotlib.rcdefaults()  # Whatever looks the user's own matplotlibrc asks for.
    save_figure(_drawn(draw, data, paths), Path(files.pdf), Path(files.png), every)
    computed = {name: _for_each(_described, given) for name, given in data.items()}
    words = [_fill(read_texts(texts).caption, computed).strip()]
    if shown:
        words += _departure_notes(every, {scene: paper for scene, (_, paper) in shown.items()})
    with complete_file(Path(files.caption)) as unfinished:
        unfinished.write_text("\n\n".join(words) + "\n", encoding="utf-8")


def _drawn(
    draw: Callable[..., Figure], data: Mapping[str, Any], paths: Mapping[str, Any]
) -> Figure:
    """Draw a figure; a DatasetError says that the files hold something else than it shows."""
    try:
        return draw(**data)
    except KeyError as error:
        files = ", ".join(str(path) for path in paths.values())
        missing = str(error.args[0]).partition(". ")[0]  # What follows is a list of like names.
        raise DatasetError(
            f"{files} does not hold what {draw.__name__} draws ({missing}): let its scene "
            "record it, or delete a file that was put there from elsewhere."
        ) from error


def _for_each(function: Callable[[Any], Any], given: Any) -> Any:
    """Return what a function makes of one thing, or of each in a list."""
    return [function(one) for one in given] if isinstance(given, list) else function(given)


def _described(dataset: xr.Dataset) -> dict[str, Any]:
    """Return what a caption may name of a dataset."""
    return configuration_of(dataset) | {"measured": dataset}


def _fill(template: str, computed: Mapping[str, Any]) -> str:
    """Fill a caption with what each dataset was computed with; an unknown name is an error."""
    environment = jinja2.Environment(
        undefined=jinja2.StrictUndefined, autoescape=False, finalize=_without_markup
    )
    environment.filters["number"] = "{:g}".format
    try:
        return environment.from_string(template).render(computed)
    except jinja2.UndefinedError as error:
        raise DatasetError(
            f"The caption speaks of what its scene does not have ({error.message}): draw a scene "
            "of this kind by a figure of your own."
        ) from error


def _without_markup(value: Any) -> str:
    """Return a value of a data file as words of a caption, whatever reStructuredText it holds."""
    return re.sub(r"([_*`|\\:])", r"\\\1", re.sub(r"\s+", " ", str(value)))


def _departure_notes(datasets: list[xr.Dataset], reference: Mapping[str, Any]) -> Iterator[str]:
    """Say for each dataset where its parameters are not the paper's."""
    for dataset in datasets:
        scene = dataset.attrs["scene"]
        named = _without_markup(scene)
        if reference.get(scene) is None:
            yield f"**Scene {named} is not one of the paper's.**"
            continue
        if found := physical_departures(configuration_of(dataset), reference[scene]):
            words = _without_markup(describe(found))
            yield f"**Changed parameters** in scene {named}: {words}."
