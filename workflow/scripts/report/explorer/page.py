"""The page on which motions and fronts are explored, one file that asks for nothing else.

Bokeh draws the panels and is part of the page.  The controls are the browser's own, since these
have a name, a value in words and keys for readers who see no picture; Bokeh's sliders have none.
"""

from collections.abc import Mapping
from decimal import ROUND_CEILING, Context
from typing import Any

import bokeh
import jinja2
import xarray as xr
import yaml
from bokeh.document import Document
from bokeh.embed import file_html
from bokeh.events import DocumentReady
from bokeh.models import CustomJS
from bokeh.resources import INLINE

from explorer.fronts import CONTINUUM, MULTIPLIERS, draw_fronts, fronts_for_page
from explorer.motions import FIELDS, draw_motions, motion_for_page
from granular_fronts.model.laws import Law, make_law
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.departures import describe, physical_departures
from granular_fronts.output.provenance import code_version, source_of

SYMBOLS = {"alpha": "α", "beta": "β", "gamma": "γ"}

TWO_DIGITS_UP = Context(prec=2, rounding=ROUND_CEILING)

FRONT_ARRAYS = {
    "relative displacement of exact fronts": ["relative_displacement"],
    "relative displacement of continuum fronts": CONTINUUM,
    "multipliers": MULTIPLIERS,
}

TITLE = "Fronts in granular chains, to explore"


def make_page(
    template: str,
    scripts: Mapping[str, str],
    motions: list[xr.Dataset],
    collection: xr.Dataset,
    plane: xr.Dataset,
    reference: Mapping[str, Any],
) -> str:
    """Return the text of the page, from the arguments of `write_explorer` as they were read.

    The texts of shared.js, motions.js and fronts.js come by their stems.
    """
    moving = {data.attrs["scene"]: motion_for_page(data) for data in motions}
    fronts = fronts_for_page(collection)
    document = Document(title=TITLE)
    for name, (panels, arguments) in {
        "motions": draw_motions(moving),
        "fronts": draw_fronts(fronts, plane),
    }.items():
        for panel in panels:
            document.add_root(panel)
        script = CustomJS(args=arguments, code=f"{scripts['shared']}\n{scripts[name]}")
        document.js_on_event(DocumentReady, script)
    environment = jinja2.Environment(undefined=jinja2.StrictUndefined, autoescape=True)
    sources = [*motions, collection, plane]
    errors = [
        _describe_error(f"{field}, {scene}", [data[f"{field}_grid"]], [moving[scene][field]])
        for data in motions
        for scene in [data.attrs["scene"]]
        for field in FIELDS
    ] + [
        _describe_error(words, [collection[one] for one in names], [fronts[one] for one in names])
        for words, names in FRONT_ARRAYS.items()
    ]
    return file_html(
        document,
        INLINE,
        TITLE,
        template=environment.from_string(template),
        template_variables={
            "sources": [_describe_source(data, reference) for data in sources],
            "scenes": [describe_scene(data) for data in motions],
            "errors": errors,
            "collection": collection,
            "code_version": code_version(),
            "bokeh_version": bokeh.__version__,
            "made_from": [source_of(data) for data in sources],
        },
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


def _describe_error(
    words: str, solved: list[xr.DataArray], encoded: list[dict[str, Any]]
) -> dict[str, str]:
    """Name the largest error of some arrays' solver and of rounding them, both rounded up."""
    up = TWO_DIGITS_UP.create_decimal
    return {
        "array": words.replace("_", " "),
        "solver": f"{up(max(variable.attrs['error_estimate'] for variable in solved)):.1e}",
        "rounding": f"{up(max(array['rounding'] for array in encoded)):.1e}",
    }
