"""The folders of the package: no import upward, and no circle, those inside functions included."""

from graphlib import TopologicalSorter

from granular_fronts.numerics.imports import module_files, named_in
from projects import ROOT

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
    "__main__",
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
