"""The wings of the package: no import upward, and no circle.

Imports are read with `ast` and not executed, those inside functions included.
"""

import ast

import pytest
from projects import ROOT

PACKAGE = ROOT / "src" / "granular_fronts"
WINGS = (
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


def sources(folder):
    return sorted(path for path in folder.rglob("*.py") if ".ipynb_checkpoints" not in path.parts)


def module_name(path):
    """Dotted name of a file of the package."""
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {module_name(path): path for path in sources(PACKAGE)}


def imports_of(tree):
    """Modules of the package that some code imports."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            named = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            members = [f"{node.module}.{alias.name}" for alias in node.names]
            named = [name if name in MODULES else node.module for name in members]
        else:
            continue
        yield from (name for name in named if name in MODULES)


def wing_of(name):
    """The wing of a module, empty for the package itself."""
    return name.split(".")[1] if "." in name else ""


IMPORTS = {
    name: sorted(set(imports_of(ast.parse(path.read_text(encoding="utf-8")))))
    for name, path in MODULES.items()
}


def upward(imports):
    """Imports of a wing by one below it."""
    return [
        (name, imported)
        for name, found in imports.items()
        for imported in found
        if wing_of(name) and wing_of(imported)
        if WINGS.index(wing_of(imported)) > WINGS.index(wing_of(name))
    ]


def circle(imports):
    """Modules that import each other in turn, empty if there are none."""
    finished = set()

    def follow(name, trail):
        if name in trail:
            return [*trail[trail.index(name) :], name]
        if name in finished:
            return []
        for imported in imports[name]:
            if found := follow(imported, [*trail, name]):
                return found
        finished.add(name)
        return []

    return next((found for name in imports if (found := follow(name, []))), [])


def test_every_folder_of_the_package_is_a_wing():
    assert {wing_of(name) for name in MODULES} - {""} == set(WINGS)


def test_no_wing_imports_one_above_it():
    assert upward(IMPORTS) == []
    low, high = "granular_fronts.numerics.band", "granular_fronts.chain.simulate"
    assert upward({low: [high], high: [low]}) == [(low, high)]


def test_no_modules_import_each_other_in_a_circle():
    assert circle(IMPORTS) == []
    assert circle({"a": ["b"], "b": ["c"], "c": ["b"]}) == ["b", "c", "b"]


@pytest.mark.parametrize(
    "name", [name for name, path in MODULES.items() if path.stem == "__init__"]
)
def test_packages_import_nothing_when_they_are_imported(name):
    """A rule then depends on the modules that its script uses, and on nothing else."""
    assert IMPORTS[name] == []
