"""Write the page on which motions and fronts are explored, one file that needs no network.

The page shows what its datasets hold and computes nothing.
"""

from pathlib import Path

from explorer.page import make_page
from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.files import complete_file
from granular_fronts.output.provenance import write_provenance
from step import run_step

LARGEST_PAGE = 5_000_000


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
        Its JavaScript: shared.js, motions.js and fronts.js.
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
    moving = [read_dataset(file) for file in motions]
    fronts, atlas = read_dataset(collection), read_dataset(plane)
    texts = {script.stem: script.read_text(encoding="utf-8") for script in scripts}
    html = make_page(template.read_text(encoding="utf-8"), texts, moving, fronts, atlas, reference)
    if (size := len(html.encode())) > LARGEST_PAGE:
        raise ValueError(
            f"The page has {size / 1e6:.1f} MB, more than {LARGEST_PAGE / 1e6:g}: record fewer "
            "times (record.grid.step of scenes.chain and scenes.periodic) or fewer fronts "
            "(explorer)."
        )
    with complete_file(page) as unfinished:
        unfinished.write_text(html, encoding="utf-8")
    write_provenance(provenance, [page], [*moving, fronts, atlas])


if __name__ == "__main__":
    run_step(write_explorer, globals().get("snakemake"))
