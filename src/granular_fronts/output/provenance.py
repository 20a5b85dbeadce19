"""What each file of results was made from, and whether this is still the same.

A dataset names in its attributes its scene and two digests, each the first 16 hexadecimals of a
SHA-256,

    config_digest   of its parameters, a part of the configuration, as JSON with sorted keys,
    data_digest     of the values of all variables, with their names, types and shapes.

These three are its *source* for whatever is made from it.  Each figure and table has its provenance
in the same folder, a JSON file of the same stem.  It holds the digest of each of its files
(`files`), the sources of all datasets behind it (`made_from`) and the version of the code
(`code_version`).  Whoever shows the figure, or starts from a folder of results, compares these with
the present files.
"""

import hashlib
import json
import math
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import granular_fronts
from granular_fronts.numerics.source_code import code_digest
from granular_fronts.output.files import complete_file, read_json

SOURCES = Path(granular_fronts.__file__).parent

DIGEST_LENGTH = 16


def digest(content: bytes) -> str:
    """Return the first 16 hexadecimals of the SHA-256 of some bytes."""
    return hashlib.sha256(content).hexdigest()[:DIGEST_LENGTH]


def config_digest(parameters: Any) -> str:
    """Return the digest of a part of the configuration; the order of keys does not count."""
    return digest(json.dumps(parameters, sort_keys=True).encode())


@cache
def code_version() -> str:
    """Return the version of the package and digest of its code, the same on every machine."""
    return f"{granular_fronts.__version__}+{code_digest(SOURCES.rglob('*.py'), SOURCES)}"


def data_digest(dataset: Any) -> str:
    """Return the digest of all values of an xarray.Dataset with their names, not attributes."""
    found = hashlib.sha256()
    for name in sorted(dataset.variables):
        values = dataset.variables[name].values
        # A file keeps neither the width of text nor its type, nor the sign of what is not a number.
        kind = values.dtype.kind if values.dtype.kind in "biuf" else "U"
        found.update(f"{name} {kind} {values.shape} ".encode())
        if kind == "U":
            found.update(json.dumps(values.astype(str).tolist()).encode())
            continue
        if kind == "f":
            values = values.copy()
            values[values != values] = math.nan
        found.update(values.tobytes())
    return found.hexdigest()[:DIGEST_LENGTH]


def source_of(dataset: Any) -> dict[str, str]:
    """Return the identity of an xarray.Dataset: its scene and both digests."""
    return {key: str(dataset.attrs[key]) for key in ("scene", "config_digest", "data_digest")}


def write_provenance(
    path: Path, files: Iterable[Path], datasets: Iterable[Any], **facts: Any
) -> None:
    """Write the provenance of files, after them.

    Parameters
    ----------
    path : Path
        The JSON file, in the folder of the files.
    files : iterable of Path
    datasets : iterable of xarray.Dataset
        All that the files were made from, as `read_dataset` returns them.
    **facts
        What else is worth keeping, for example a title.
    """
    provenance = {
        "files": {file.name: digest(file.read_bytes()) for file in files},
        "made_from": sorted(map(source_of, datasets), key=lambda source: source["scene"]),
        "code_version": code_version(),
        **facts,
    }
    with complete_file(path) as unfinished:
        unfinished.write_text(
            json.dumps(provenance, indent=1, ensure_ascii=False) + "\n", encoding="utf-8"
        )


def disagreements(
    path: Path,
    parameters: Mapping[str, Any],
    sources: Collection[Mapping[str, str]] | None = None,
) -> Iterator[str]:
    """Compare the provenance of a figure or a table with the present files.

    Parameters
    ----------
    path : Path
        The JSON file that `write_provenance` wrote.
    parameters : mapping
        The present parameters of datasets by name, ``folder/scene``. Others are not compared.
    sources : collection of mapping, optional
        Sources of the present datasets; not compared if left out.

    Yields
    ------
    str
        What does not agree, without a full stop.

    Raises
    ------
    InputError
        If the JSON file is damaged.
    """
    provenance = read_json(path)
    for name, expected in provenance["files"].items():
        file = path.with_name(name)
        if not file.exists() or digest(file.read_bytes()) != expected:
            yield f"{file} is not the file that its provenance describes"
    present = defaultdict(set)  # A scene may share its name with a dataset of another folder.
    for name, described in parameters.items():
        present[name.rpartition("/")[2]].add(config_digest(described))
    for source in provenance["made_from"]:
        scene, answered = source["scene"], source.get("config_digest")
        if answered not in present.get(scene, {answered}):
            yield f"{path} answers another configuration of scene {scene}"
        elif sources is not None and source not in sources:
            yield f"{path} was made from other data of scene {scene} than lie there now"
