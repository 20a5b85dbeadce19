"""A small page to explore, from a chain whose beads fly off and a few fronts."""

from functools import cache

import numpy as np
from chains import driven_scene
from projects import ROOT
from write_explorer import write_explorer

import granular_fronts as gf
from granular_fronts.output.datasets import read_dataset, write_dataset
from granular_fronts.studies.damping_map import map_critical_damping
from granular_fronts.studies.front_collection import collect_fronts

ALPHAS, GAMMAS = (1.2, 1.5), (0.1, 0.3, 0.9)
TOLERANCE = {"relative": 1.0e-9, "absolute": 1.0e-12}
RECORD = {"snapshots": [], "grid": {"step": 2}}
SCENE = driven_scene(beads=20, end_time=80.0, tolerance=TOLERANCE, record=RECORD)
FOLDER = ROOT / "workflow/report/explorer"


@cache
def solved():
    """The datasets of the page, with the part of a configuration that each answers."""
    gammas = {"start": GAMMAS[0], "stop": GAMMAS[-1], "num": len(GAMMAS)}
    plane = map_critical_damping(np.linspace(1.2, 1.6, 3), np.geomspace(0.1, 1.0, 4), 1e-3)
    return {
        "flying": (gf.simulate_chain(SCENE), SCENE),
        "collection": (collect_fronts(ALPHAS, GAMMAS), {"alpha": list(ALPHAS), "gamma": gammas}),
        "critical_damping": (plane, {}),
    }


def write_page(folder):
    """Write the page into a folder; return its file and the datasets by name."""
    files = {name: folder / f"{name}.nc" for name in solved()}
    for name, (dataset, config) in solved().items():
        write_dataset(dataset, files[name], scene_id=name, config=config)
    page = folder / "explore.html"
    write_explorer(
        template=FOLDER / "page.html.j2",
        scripts=[FOLDER / f"{script}.js" for script in ("shared", "chain", "motions", "fronts")],
        motions=[files["flying"]],
        collection=files["collection"],
        plane=files["critical_damping"],
        page=page,
        provenance=page.with_suffix(".json"),
    )
    return page, {name: read_dataset(file) for name, file in files.items()}
