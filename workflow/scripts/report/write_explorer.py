"""Write the page on which motions and fronts are explored, one file that needs no network.

The page holds what datasets hold, with fewer digits; only a chain of the reader's own is computed
in it.  The controls are the browser's own, with names and keys for readers who see no picture.
"""

import gzip
import json
from base64 import b64encode
from pathlib import Path
from typing import Any

import jinja2
import matplotlib
import numpy as np
import xarray as xr
import yaml
from matplotlib.colors import to_hex

from granular_fronts.output.datasets import configuration_of, read_dataset
from granular_fronts.output.files import complete_file
from granular_fronts.output.panels import contacts_open, moving_parts
from granular_fronts.output.provenance import code_version, write_provenance
from granular_fronts.output.style import ALARM_COLOUR, LOOKS, compression_map, velocity_map
from step import run_step

DIGITS = 4
"""Significant digits of every number of the page."""


def write_explorer(
    template: Path,
    scripts: list[Path],
    motions: list[Path],
    collection: Path,
    plane: Path,
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
    page, provenance : Path
        The HTML and the JSON file to write.
    """
    sources = [read_dataset(file) for file in [*motions, collection, plane]]
    *moving, fronts, atlas = sources
    looks = {
        name: {"label": label, "colour": colour, "dash": list(line[1]) if line != "-" else []}
        for name, (label, colour, line) in LOOKS.items()
    }
    maps = {"relative_displacement": compression_map(), "velocity": velocity_map()}
    maps["overshoot"] = matplotlib.colormaps["viridis_r"]
    shares = np.linspace(0.0, 1.0, 128)
    content = {
        "motions": {data.attrs["scene"]: motion_for_page(data) for data in moving},
        "fronts": {name: variable.values for name, variable in fronts.variables.items()},
        "plane": {name: variable.values for name, variable in atlas.variables.items()},
        "looks": looks,
        "palettes": {name: [to_hex(colours(x)) for x in shares] for name, colours in maps.items()},
        "alarm": ALARM_COLOUR,
        "digits": DIGITS,
    }
    environment = jinja2.Environment(undefined=jinja2.StrictUndefined, autoescape=True)
    html = environment.from_string(template.read_text(encoding="utf-8")).render(
        scenes={data.attrs["scene"]: title_of(data) for data in moving},
        sizes=fronts.sizes,
        looks=looks,
        configurations={
            data.attrs["scene"]: yaml.safe_dump(configuration_of(data), sort_keys=False)
            for data in sources
        },
        code_version=code_version(),
        digits=DIGITS,
        content=pack(content),
        scripts="\n".join(script.read_text(encoding="utf-8") for script in scripts),
    )
    with complete_file(page) as unfinished:
        unfinished.write_text(html, encoding="utf-8")
    write_provenance(provenance, [page], sources)


def motion_for_page(data: xr.Dataset) -> dict[str, Any]:
    """Return what the page holds of a motion."""
    fields = {
        name: {"rows": values.values, "error": float(values.attrs["error_estimate"])}
        for name, values in moving_parts(data, "_grid").items()
    }
    return {"times": data["t_grid"].values, "opens": contacts_open(data), **fields}


def title_of(data: xr.Dataset) -> str:
    """What the page calls a scene: its name, its beads, its law as it was asked for."""
    asked = configuration_of(data)
    is_ring = "half_beads" in asked or asked["boundary"]["kind"] == "ring"
    law = yaml.safe_dump(asked["law"], default_flow_style=True, width=1000, sort_keys=False)
    beads = f"{'ring' if is_ring else 'chain'} of {data.sizes['bead']} beads"
    return f"{data.attrs['scene'].replace('_', ' ')}, {beads}, {law.strip()[1:-1]}"


def pack(content: Any) -> str:
    """Return mappings, lists and arrays as compressed JSON in base 64, null for NaN."""
    text = json.dumps(content, default=_plain, allow_nan=False, separators=(",", ":"))
    return b64encode(gzip.compress(text.encode(), mtime=0)).decode("ascii")


def _plain(values: np.ndarray) -> Any:
    """An array as lists of numbers with the digits of the page, or of words."""

    def rounded(value: float) -> float | None:
        return float(f"{value:.{DIGITS}g}") if np.isfinite(value) else None

    numbers = values.dtype.kind == "f"
    return (np.vectorize(rounded, otypes=[object])(values) if numbers else values).tolist()


if __name__ == "__main__":
    run_step(write_explorer, globals().get("snakemake"))
