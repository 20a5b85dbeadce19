"""The folders of the package: no import upward, and no circle, those inside functions included."""

import re
from graphlib import TopologicalSorter

from pages import load_script
from projects import ROOT

from granular_fronts.numerics.imports import module_files, named_in

PACKAGES = (
    "errors",
    "arguments",
    "accuracy",
    "numerics",
    "model",
    "output",
    "scenes",
    "chain",
    "continuum",
    "fronts",
    "reference_methods",
    "studies",
    "referee",
    "proofs",
    "campaign",
)
"""From the bottom up: each may import those before it, and itself."""

MODULES = module_files(ROOT / "src")
FILES = {name: file for name, file in MODULES.items() if "." in name}
IMPORTS = {name: named_in(file) & FILES.keys() for name, file in FILES.items()}


def upward(imports):
    """Imports of a package by one below it."""
    height = {name: PACKAGES.index(name.split(".")[1]) for name in FILES}
    return {(low, high) for low in imports for high in imports[low] if height[low] < height[high]}


def test_no_package_imports_one_above_it_and_no_modules_each_other_in_a_circle():
    assert {name.split(".")[1] for name in FILES} == set(PACKAGES)
    assert upward(IMPORTS) == set()
    low, high = "granular_fronts.numerics.band", "granular_fronts.chain.simulate"
    assert upward({low: [high], high: [low]}) == {(low, high)}
    TopologicalSorter(IMPORTS).prepare()


def test_packages_import_nothing_when_they_are_imported():
    """A rule then depends on the modules that its script uses, and on nothing else."""
    packages = [name for name, file in FILES.items() if file.stem == "__init__"]
    assert "granular_fronts.chain" in packages
    assert not any(IMPORTS[name] for name in packages)
    assert not named_in(MODULES["granular_fronts"]) & FILES.keys()


def test_picture_of_the_architecture_is_that_of_the_code():
    script = load_script("architecture")
    picture = script.PICTURE.read_text(encoding="utf-8")
    assert picture == script.draw(script.read_packages()), "run python docs/architecture.py"
    for _, place in script.FLOW:
        if not place.startswith("results"):
            assert any(ROOT.glob(place)), place


def test_way_of_figure_1_names_what_its_files_hold():
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    hops = [row.split("|")[2:4] for row in re.findall(r"^\| \d+ \|.*", page, re.MULTILINE)]
    assert len(hops) == 9
    for said, where in hops:
        files = [ROOT / name for name in re.findall(r"`(\S+)`", where)]
        held = "".join(file.read_text(encoding="utf-8") for file in files)
        for name in re.findall(r"`(\S+)`", said):
            assert re.search(rf"\b{name}\b", held), f"{name} is not in {where}"
