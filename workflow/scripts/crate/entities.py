"""What the record of a run says of files, software, people and the paper.

The names of types and properties are those of schema.org and of RO-Crate 1.1.
"""

import hashlib
import io
import platform
import re
import tomllib
from collections.abc import Iterable
from importlib import metadata
from pathlib import Path
from typing import Any

import yaml
from rocrate.model import ContextEntity
from rocrate.model.entity import Entity
from rocrate.rocrate import ROCrate

FORMATS = {
    ".cff": "application/yaml",
    ".csv": "text/csv",
    ".gif": "image/gif",
    ".html": "text/html",
    ".js": "text/javascript",
    ".json": "application/json",
    ".md": "text/markdown",
    ".nc": "application/netcdf",
    ".npz": "application/zip",
    ".pdf": "application/pdf",
    ".png": "image/png",
    ".py": "text/x-python",
    ".rst": "text/x-rst",
    ".svg": "image/svg+xml",
    ".toml": "application/toml",
    ".tsv": "text/tab-separated-values",
    ".yaml": "application/yaml",
    ".yml": "application/yaml",
}
"""Media types by the ending of a name; all other files are plain text."""


def add_file(crate: ROCrate, source: Path | str, name: str, **properties: Any) -> Entity:
    """Add a file with its size and digest.

    Parameters
    ----------
    crate : ROCrate
    source : Path or str
        The file, or the text of one that is written into the crate alone.
    name : str
        Its path in the crate.
    **properties
        What else is known of it.

    Returns
    -------
    Entity
    """
    return crate.add_file(
        source if isinstance(source, Path) else io.StringIO(source),
        name,
        properties={"name": name, **describe_file(source, name), **properties},
    )


def describe_file(source: Path | str, name: str = "") -> dict[str, str]:
    """Media type, size and digest of a file, or of the text of one, whose name is then needed."""
    content = source.read_bytes() if isinstance(source, Path) else source.encode()
    return {
        "encodingFormat": FORMATS.get(Path(name or source).suffix, "text/plain"),
        "sha256": hashlib.sha256(content).hexdigest(),
        "contentSize": str(len(content)),
    }


def add_thing(crate: ROCrate, identifier: str, kind: str, **properties: Any) -> Entity:
    """Add what is no file: software, an organisation, an article.

    Parameters
    ----------
    crate : ROCrate
    identifier : str
        An address, or a name that begins with ``#``.
    kind : str
        Its type.
    **properties
        What is known of it.

    Returns
    -------
    Entity
    """
    return crate.add(ContextEntity(crate, identifier, properties={"@type": kind, **properties}))


def add_citation(crate: ROCrate, project: Path) -> dict[str, Any]:
    """Add authors, licence and the paper, as CITATION.cff names them.

    Parameters
    ----------
    crate : ROCrate
    project : Path
        The project's folder.

    Returns
    -------
    dict
        Properties of the workflow: its title, version, authors, licence, and what it cites.
    """
    cited = yaml.safe_load((project / "CITATION.cff").read_text(encoding="utf-8"))
    licence = add_thing(
        crate,
        f"https://spdx.org/licenses/{cited['license']}",
        "CreativeWork",
        name=cited["license"],
    )
    papers = [
        add_thing(
            crate,
            f"https://doi.org/{paper['doi']}",
            "ScholarlyArticle",
            name=paper["title"],
            author=add_authors(crate, paper["authors"]),
            datePublished=str(paper["year"]),
        )
        for paper in cited["references"]
    ]
    return {
        "name": cited["title"],
        "version": cited["version"],
        "author": add_authors(crate, cited["authors"]),
        "license": licence,
        "citation": papers,
    }


def add_authors(crate: ROCrate, authors: Iterable[dict[str, str]]) -> list[Entity]:
    """Add the authors of a work: a person has a family name, a group has one name."""
    return [
        add_thing(
            crate,
            f"#{re.sub(r'[^a-z]+', '-', name.lower())}",
            "Person" if "family-names" in author else "Organization",
            name=name,
        )
        for author in authors
        for name in [author.get("name") or f"{author['given-names']} {author['family-names']}"]
    ]


def add_software(crate: ROCrate, project: Path) -> list[Entity]:
    """Add Python and the packages that a run depends on, with the versions installed here.

    Parameters
    ----------
    crate : ROCrate
    project : Path
        The project's folder.

    Returns
    -------
    list of Entity
    """
    python = add_thing(
        crate,
        "https://www.python.org",
        "SoftwareApplication",
        name="Python",
        url="https://www.python.org",
        softwareVersion=platform.python_version(),
        operatingSystem=f"{platform.system()} {platform.machine()}",
    )
    described = tomllib.loads((project / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    needed = [*described["dependencies"], *described["optional-dependencies"]["workflow"]]
    names = sorted(re.split(r"[^\w.-]", line)[0] for line in needed)
    return [python, *(add_package(crate, name) for name in names)]


def add_package(crate: ROCrate, name: str) -> Entity:
    """Add an installed Python package under its package URL (`package_identifier`)."""
    described = metadata.metadata(name)
    pages = [line.split(", ", 1)[1] for line in described.get_all("Project-URL") or []]
    if "Home-page" in described:
        pages.insert(0, described["Home-page"])
    return add_thing(
        crate,
        package_identifier(name),
        "SoftwareApplication",
        name=described["Name"],
        softwareVersion=described["Version"],
        **({"url": pages[0]} if pages else {}),
    )


def package_identifier(name: str) -> str:
    """The package URL of an installed Python package."""
    return f"pkg:pypi/{name}@{metadata.version(name)}"


def installed_packages() -> str:
    """Every installed Python package with its version, as lines that pip can read."""
    found = {one.metadata["Name"]: one.version for one in metadata.distributions()}
    return "".join(f"{name}=={found[name]}\n" for name in sorted(found, key=str.lower))
