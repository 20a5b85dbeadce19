"""Find the files that a script or a kernel needs, from imports and without running any.

Let D(m) be the modules named in the import statements of module m, those inside functions too. Each
comes with the packages above it, whose ``__init__`` runs first.  A module s needs the smallest set
S that holds s and, with each m, all of D(m).  Modules outside the given folders belong to no S: an
environment pins them.

A module that is named in a string, not in an import statement, must be given with the script.
"""

import re
from collections.abc import Iterable, Mapping
from functools import cache
from itertools import accumulate
from pathlib import Path

# Parsing each file with `ast` would make every call of the workflow wait a third of a second.
IMPORT = re.compile(r"^ *(?:from ([\w.]+) )?import (\([^)]*\)|.*)", re.MULTILINE)


def module_files(*folders: Path) -> dict[str, Path]:
    """Return the file of each module below some folders by its dotted name."""
    return {
        ".".join(file.relative_to(folder).with_suffix("").parts).removesuffix(".__init__"): file
        for folder in folders
        for file in folder.rglob("*.py")
    }


def import_closure(names: Iterable[str], files: Mapping[str, Path]) -> set[str]:
    """Return the modules that some modules need, these and the packages above them included.

    `names` are the script and what it imports by a string.  Only `files`, as `module_files` gives
    them, are followed; a given module without a file is a ValueError.
    """
    if missing := sorted(set(names) - set(files)):
        raise ValueError(f"There is no module {missing[0]}: correct the rule that names it.")
    found, waiting = set(), {above for name in names for above in _packages_and(name)}
    while waiting:
        found |= waiting
        named = set().union(*(named_in(files[name]) for name in waiting))
        waiting = named & set(files) - found
    return found


@cache
def named_in(file: Path) -> set[str]:
    """Return the dotted names that a file may import, each with the packages above it.

    A name taken from a module may be a module itself, so both are among them.
    """
    named: set[str] = set()
    for module, names in IMPORT.findall(file.read_text(encoding="utf-8")):
        for name in re.findall(r"[\w.]+", names):
            dotted = f"{module}.{name}" if module else name
            named.update(_packages_and(dotted))
    return named


def _packages_and(name: str) -> Iterable[str]:
    """Return a dotted name after the packages above it, which Python imports before."""
    return accumulate(name.split("."), "{}.{}".format)
