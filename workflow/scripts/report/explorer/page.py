"""The page on which motions and fronts are explored, one file that asks for nothing else.

Bokeh draws the panels and is part of the page.  The controls are the browser's own, since these
have a name, a value in words and keys for readers who see no picture; Bokeh's sliders have none.
"""

from collections.abc import Iterable, Iterator, Mapping
from decimal import ROUND_CEILING, Context
from typing import Any, NamedTuple

import bokeh
import jinja2
import xarray as xr
import yaml
from bokeh.document import Document
from bokeh.embed import file_html
from bokeh.events import DocumentReady
from bokeh.models import CustomJS
from bokeh.resources import INLINE

from explorer.encoding import Encoded
from explorer.fronts import draw_fronts, encode_fronts, fronts_for_page
from explorer.motions import FIELDS, draw_motions, encode_motion, motion_for_page
from granular_fronts.model.laws import Law, make_law
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.departures import describe, physical_departures
from granular_fronts.output.provenance import code_version, source_of

SYMBOLS = {"alpha": "α", "beta": "β", "gamma": "γ"}

TWO_DIGITS_UP = Context(prec=2, rounding=ROUND_CEILING)

TITLE = "Fronts in granular chains, to explore"


class Sources(NamedTuple):
    """What the page is made from: motions on a space–time grid, fronts, and the plane of both."""

    motions: list[xr.Dataset]
    collection: xr.Dataset
    plane: xr.Dataset

    def all(self) -> list[xr.Dataset]:
        """Every dataset."""
        return [*self.motions, self.collection, self.plane]


def make_page(
    template: str, scripts: Mapping[str, str], sources: Sources, reference: Mapping[str, Any]
) -> str:
    """The text of the page; `scripts` are shared.js, motions.js and fronts.js by their stems."""
    motions = {data.attrs["scene"]: encode_motion(data) for data in sources.motions}
    fronts = encode_fronts(sources.collection)
    parts = {
        "motions": draw_motions(
            {
                data.attrs["scene"]: motion_for_page(data, motions[data.attrs["scene"]])
                for data in sources.motions
            }
        ),
        "fronts": draw_fronts(fronts_for_page(sources.collection, fronts), sources.plane),
    }
    document = Document(title=TITLE)
    for part in parts.values():
        for panel in part.panels.values():
            document.add_root(panel)
    callbacks = [
        CustomJS(args=part.arguments, code=f"{scripts['shared']}\n{scripts[name]}")
        for name, part in parts.items()
    ]
    document.js_on_event(DocumentReady, *callbacks)
    variables = {
        "sources": [_describe_source(data, reference) for data in sources.all()],
        "scenes": [describe_scene(data) for data in sources.motions],
        "errors": list(_errors(sources, motions, fronts)),
        "collection": sources.collection,
        "code_version": code_version(),
        "bokeh_version": bokeh.__version__,
        "made_from": [source_of(data) for data in sources.all()],
    }
    environment = jinja2.Environment(undefined=jinja2.StrictUndefined, autoescape=True)
    return file_html(
        document,
        INLINE,
        TITLE,
        template=environment.from_string(template),
        template_variables=variables,
    )


def _describe_source(data: xr.Dataset, reference: Mapping[str, Any]) -> dict[str, str]:
    """What the page says of a dataset: its scene, its configuration, its digests."""
    asked, scene = configuration_of(data), data.attrs["scene"]
    if scene in reference:
        departures = describe(physical_departures(asked, reference[scene]))
    else:
        departures = "not one of the paper's"
    return {
        **source_of(data),
        "departures": departures,
        "software": data.attrs["software"],
        "configuration": yaml.safe_dump(asked, sort_keys=False, allow_unicode=True),
    }


def describe_scene(data: xr.Dataset) -> dict[str, str]:
    """What the page calls a scene."""
    asked, scene = configuration_of(data), data.attrs["scene"]
    is_ring = "half_beads" in asked or asked["boundary"]["kind"] == "ring"
    beads = f"{'ring' if is_ring else 'chain'} of {data.sizes['bead']} beads"
    words = [scene.replace("_", " "), beads, _law_in_words(make_law(asked["law"]))]
    return {"name": scene, "title": ", ".join(words)}


def _law_in_words(law: Law) -> str:
    """A law with its numbers, those of the paper's law or those of both potentials."""
    described = law.describe()
    if law.is_power:
        return _numbers_in_words(described)
    kind = described["viscous"]["kind"].replace("_", " ")
    elastic = f"{law.elastic.name} ({_numbers_in_words(described['elastic'])})"
    if kind == "none":
        return f"{elastic}, no damping"
    return f"{elastic}, {kind} damping ({_numbers_in_words(described['viscous'])})"


def _numbers_in_words(parameters: Mapping[str, Any]) -> str:
    """The numbers among some parameters, each with its symbol or name."""
    return ", ".join(
        f"{SYMBOLS.get(name, name)} = {value:g}"
        for name, value in parameters.items()
        if name != "kind"
    )


def _errors(
    sources: Sources,
    motions: Mapping[str, Mapping[str, Encoded]],
    fronts: Mapping[str, Encoded],
) -> Iterator[dict[str, str]]:
    """For each array of the page the largest error of its solver and that of rounding it."""
    for data in sources.motions:
        for field in FIELDS:
            encoded = motions[data.attrs["scene"]][field]
            yield _row(f"{field}, {data.attrs['scene']}", [data[f"{field}_grid"]], [encoded])
    by_kind: dict[str, list[str]] = {
        "relative displacement of exact fronts": ["relative_displacement"],
        "relative displacement of continuum fronts": [
            name for name in fronts if name.startswith("relative_displacement_")
        ],
        "multipliers": ["multiplier_real", "multiplier_imaginary"],
    }
    for words, names in by_kind.items():
        yield _row(words, [sources.collection[name] for name in names], [fronts[n] for n in names])


def _row(words: str, solved: Iterable[xr.DataArray], encoded: Iterable[Encoded]) -> dict[str, str]:
    """One row of the table of errors, which are rounded up to two digits."""
    up = TWO_DIGITS_UP.create_decimal
    return {
        "array": words.replace("_", " "),
        "solver": f"{up(max(variable.attrs['error_estimate'] for variable in solved)):.1e}",
        "rounding": f"{up(max(array.error for array in encoded)):.1e}",
    }
