"""Write the page on which motions and fronts are explored, one file that needs no network.

The page holds what datasets hold, rounded; only a chain of the reader's own is computed in it.  The
controls are the browser's own, since these have a name, a value in words and keys for readers who
see no picture.
"""

import gzip
import json
from base64 import b64encode
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import jinja2
import matplotlib
import numpy as np
import xarray as xr
import yaml
from matplotlib.colors import Colormap, to_hex

from granular_fronts.output.datasets import configuration_of, read_dataset
from granular_fronts.output.departures import describe, physical_departures
from granular_fronts.output.files import complete_file
from granular_fronts.output.panels import contacts_open, moving_parts
from granular_fronts.output.provenance import code_version, source_of, write_provenance
from granular_fronts.output.style import (
    ALARM_COLOUR,
    CONTINUUM_LOOKS,
    LOOKS,
    compression_map,
    velocity_map,
)
from step import run_step

LARGEST_PAGE = 5_000_000
DIGITS = 6
"""Of the largest number of an array; the others are rounded to the same decimal."""

CRITICAL = ("tail", "double_root", "long_wave", "overshoot")
MULTIPLIERS = ("multiplier_real", "multiplier_imaginary")
PROFILES = ("relative_displacement", *(f"relative_displacement_{name}" for name in CONTINUUM_LOOKS))
READINGS = (
    "overshoot",
    "width_10_90",
    "error",
    "beads_behind",
    "translation_defect",
    "verdict",
    *(f"distance_{name}" for name in CONTINUUM_LOOKS),
    "tail_root_real",
    "tail_root_imaginary",
)


def write_explorer(
    template: Path,
    scripts: list[Path],
    motions: list[Path],
    collection: Path,
    plane: Path,
    reference: dict,
    page: Path,
    provenance: Path,
) -> None:
    """Fill the template of the page, and write what it was made from.

    Parameters
    ----------
    template : Path
        Jinja template of the page.
    scripts : list of Path
        Its JavaScript, in the order of the page.
    motions : list of Path
        Datasets of chains and rings with a space–time grid.
    collection, plane : Path
        Datasets of fronts and of the plane that they are chosen in.
    reference : dict
        What the paper computes, by scene.
    page, provenance : Path
        The HTML and the JSON file to write.

    Raises
    ------
    ValueError
        If the page would be larger than a page should be.
    """
    sources = [read_dataset(file) for file in [*motions, collection, plane]]
    *moving, fronts, atlas = sources
    looks = {
        name: {"label": label, "colour": colour, "dash": list(line[1]) if line != "-" else []}
        for name, (label, colour, line) in LOOKS.items()
    }
    content = {
        "motions": {data.attrs["scene"]: motion_for_page(data) for data in moving},
        "fronts": fronts_for_page(fronts),
        "plane": {name: atlas[name].values for name in ("alpha", "gamma", "overshoot")}
        | {"critical": {name: atlas[f"critical_damping_{name}"].values for name in CRITICAL}},
        "looks": looks,
        "palettes": {
            "relative_displacement": _palette(compression_map()),
            "velocity": _palette(velocity_map()),
            "overshoot": _palette(matplotlib.colormaps["viridis_r"]),
        },
        "alarm": ALARM_COLOUR,
    }
    environment = jinja2.Environment(undefined=jinja2.StrictUndefined, autoescape=True)
    html = environment.from_string(template.read_text(encoding="utf-8")).render(
        scenes=[describe_scene(data) for data in moving],
        fronts=fronts,
        legends={
            "atlas": [looks[name] for name in CRITICAL],
            "front": [looks[name] for name in ("exact", *CONTINUUM_LOOKS)],
        },
        sources=[_describe_source(data, reference) for data in sources],
        made_from=[source_of(data) for data in sources],
        code_version=code_version(),
        content=pack(content),
        scripts="\n".join(script.read_text(encoding="utf-8") for script in scripts),
    )
    if (size := len(html.encode())) > LARGEST_PAGE:
        raise ValueError(
            f"The page has {size / 1e6:.1f} MB, more than {LARGEST_PAGE / 1e6:g}: record fewer "
            "times (record.grid.step of scenes.chain and scenes.periodic) or fewer fronts "
            "(explorer)."
        )
    with complete_file(page) as unfinished:
        unfinished.write_text(html, encoding="utf-8")
    write_provenance(provenance, [page], sources)


def motion_for_page(data: xr.Dataset) -> dict[str, Any]:
    """Return what the page holds of a motion."""
    fields = moving_parts(data, "_grid")
    velocity = fields["velocity"]
    return {name: round_array(values) for name, values in fields.items()} | {
        "times": data["t_grid"].values,
        "beads": data.sizes["bead"],
        "opens": contacts_open(data),
        # Colours and axes go this far; gaps may be much wider.
        "largest": float(fields["relative_displacement"].max()),
        "slowest": float(velocity.min()),
        "fastest": float(velocity.max()),
    }


def fronts_for_page(collection: xr.Dataset) -> dict[str, Any]:
    """Return what the page holds of fronts, a row for each, α after α."""
    rows = collection.stack(front=("alpha", "gamma"), create_index=False).transpose("front", ...)
    return {name: round_array(rows[name]) for name in (*PROFILES, *MULTIPLIERS)} | {
        "alpha": collection["alpha"].values,
        "gamma": collection["gamma"].values,
        "window": rows["xi"].values[:, [0, -1]],
        **{name: rows[name].values for name in READINGS},
    }


def round_array(values: xr.DataArray) -> dict[str, Any]:
    """Round to a decimal: the rows, and their largest error, of the solver and of rounding."""
    decimals = DIGITS - int(np.ceil(np.log10(np.abs(values).max())))
    error = values.attrs["error_estimate"] + 0.5 * 10.0**-decimals
    return {"rows": np.round(values.values, decimals), "error": float(error)}


def pack(content: Any) -> str:
    """Return mappings, lists and arrays as compressed JSON in base 64, null where a number is."""
    text = json.dumps(_plain(content), allow_nan=False, separators=(",", ":"))
    return b64encode(gzip.compress(text.encode(), mtime=0)).decode("ascii")


def _plain(content: Any) -> Any:
    match content:
        case dict():
            return {name: _plain(value) for name, value in content.items()}
        case list() | tuple():
            return [_plain(value) for value in content]
        case np.ndarray():
            return _plain(content.tolist())
        case float() if np.isnan(content) or content.is_integer():
            return None if np.isnan(content) else int(content)
    return content


def _palette(colour_map: Colormap) -> list[str]:
    return [to_hex(colour_map(share)) for share in np.linspace(0.0, 1.0, 128)]


def describe_scene(data: xr.Dataset) -> dict[str, str]:
    """What the page calls a scene: its name, its beads, its law as it was asked for."""
    asked, scene = configuration_of(data), data.attrs["scene"]
    is_ring = "half_beads" in asked or asked["boundary"]["kind"] == "ring"
    law = yaml.safe_dump(asked["law"], default_flow_style=True, width=1000, sort_keys=False)
    beads = f"{'ring' if is_ring else 'chain'} of {data.sizes['bead']} beads"
    return {"name": scene, "title": f"{scene.replace('_', ' ')}, {beads}, {law.strip()[1:-1]}"}


def _describe_source(data: xr.Dataset, reference: Mapping[str, Any]) -> dict[str, str]:
    """What the page says of a dataset: its scene, its configuration, its digests."""
    asked, scene = configuration_of(data), data.attrs["scene"]
    departures = "not one of the paper's"
    if scene in reference:
        departures = describe(physical_departures(asked, reference[scene]))
    return {
        **source_of(data),
        "departures": departures,
        "configuration": yaml.safe_dump(asked, sort_keys=False, allow_unicode=True),
    }


if __name__ == "__main__":
    run_step(write_explorer, globals().get("snakemake"))
