"""Make the small pictures of the manual, docs/figures, from the figures of a finished run.

python docs/pictures.py

Each names the scenes that it shows with a digest of their parameters, so that a test sees whether
a picture still belongs to config/default.yaml.
"""

import hashlib
import json
from pathlib import Path

from PIL import Image, PngImagePlugin

from granular_fronts.output.datasets import configuration_of, read_dataset

ROOT = Path(__file__).parents[1]
COLOURS = 256


def digest(parameters: dict) -> str:
    """Return a digest of the parameters of a scene."""
    text = json.dumps(parameters, sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def shrink(figure: Path, scenes: dict[str, str], picture: Path) -> None:
    """Write a figure in fewer colours, at most 60 kB; scenes are by the keywords of figures."""
    with Image.open(figure) as drawn:
        shown = [scenes[word] for word in drawn.text["Keywords"].split()]
        small = drawn.convert("RGB").quantize(COLOURS, Image.Quantize.MAXCOVERAGE, kmeans=3)
    information = PngImagePlugin.PngInfo()
    information.add_text("Keywords", " ".join(shown))
    small.save(picture, optimize=True, pnginfo=information)


if __name__ == "__main__":
    data = [read_dataset(file) for file in sorted((ROOT / "results/data").glob("*/*.nc"))]
    # Scenes of projects may have the same names.
    known = {
        f"{one.attrs['scene']}:{one.attrs['data_digest']}": (
            f"{one.attrs['scene']}:{digest(configuration_of(one))}"
        )
        for one in data
    }
    (ROOT / "docs/figures").mkdir(exist_ok=True)
    for texts in sorted((ROOT / "workflow/captions").glob("[!t]*.rst")):
        shrink(
            ROOT / f"results/figures/{texts.stem}.png",
            known,
            ROOT / f"docs/figures/{texts.stem}.png",
        )
