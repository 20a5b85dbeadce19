"""Make the small pictures of the manual: docs/beads.png, docs/front.png, and docs/figures.

python docs/pictures.py

Those of docs/figures come from a finished run.  Each names the scenes that it shows with a digest
of their parameters, so that a test sees whether it still belongs to config/default.yaml.
"""

import hashlib
import json
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from PIL import Image, PngImagePlugin

import granular_fronts as gf
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


def draw_beads(picture: Path) -> None:
    """Draw a front as beads and as a curve, with an overlap that is far too large."""
    front = gf.solve_front(alpha=1.5, gamma=0.05)
    u = gf.evaluate_front(front, np.arange(-15, 6))
    left = np.concatenate([[0.0], np.cumsum(1.0 - 0.35 * u)])
    beads = left - left[-5]
    figure, (row, curve) = plt.subplots(
        2, 1, figsize=(8, 3.4), height_ratios=(2, 3), sharex=True, layout="constrained"
    )
    for x, pressed in zip(beads, np.append(u, 0.0), strict=True):
        colour = plt.cm.Blues(0.15 + 0.6 * min(pressed, 1.3))
        row.add_patch(plt.Circle((x, 0.0), 0.5, facecolor=colour, edgecolor="0.2", alpha=0.8))
    arrow = {"arrowstyle": "-|>", "lw": 2}
    row.annotate("", (beads[0] - 0.6, 0), (beads[0] - 2.2, 0), arrowprops=arrow)
    row.text(beads[0] - 1.5, 0.5, "press", ha="center")
    row.text(beads[6], 0.85, "compressed, moving", ha="center")
    row.text(beads[-3], 0.85, "at rest", ha="center")
    row.set(aspect="equal", ylim=(-0.7, 1.3), xlim=(beads[0] - 2.4, beads[-1] + 0.7))
    row.axis("off")
    curve.plot((beads[:-1] + beads[1:]) / 2, u, "o-")
    curve.set(ylabel="compression / δ", xlabel="place, in diameters")
    curve.axhline(1.0, lw=0.8, color="0.6")
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    draw_beads(ROOT / "docs/beads.png")
    gf.plot.front(gf.solve_front(alpha=1.5, gamma=0.05)).figure.savefig(ROOT / "docs/front.png")
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
