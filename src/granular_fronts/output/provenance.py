"""What a figure, a table or the report was made from, and whether that is what is asked now.

A dataset answers a question: the part of the configuration that its rule was given.  Both are known
by digests, the first 16 hexadecimals of a SHA-256,

    question = digest of the configuration, as JSON with sorted keys,
    data     = digest of the values of all variables, with their names, types and shapes,

and the triple of scene, question and data is the *origin* of whatever is made from the dataset.
Each figure and each table has a *record* beside it, a JSON file that names the digest of each of
its files, the origins of all datasets that it was made from, and the version of the code.  With the
records a finished folder can be checked without running anything: every file must be the one of its
record, every origin must be that of the dataset that lies there now, and every dataset must answer
what is asked now.
"""

import hashlib
import json
import math
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import granular_fronts
from granular_fronts.numerics.source_code import code_digest
from granular_fronts.output.files import complete_file, read_json

SOURCES = Path(granular_fronts.__file__).parent

DIGEST_LENGTH = 16


def digest(content: bytes) -> str:
    """The first 16 hexadecimals of the SHA-256 of some bytes."""
    return hashlib.sha256(content).hexdigest()[:DIGEST_LENGTH]


def question_digest(configuration: Any) -> str:
    """Digest of a part of the configuration; the order of keys does not count."""
    return digest(json.dumps(configuration, sort_keys=True).encode())


@cache
def code_version() -> str:
    """Version of the package and digest of its code, the same on every machine."""
    return f"{granular_fronts.__version__}+{code_digest(SOURCES.rglob('*.py'), SOURCES)}"


def data_digest(dataset: Any) -> str:
    """Digest of all values of an xarray.Dataset with their names; attributes do not count."""
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


def origin(attributes: Mapping[str, Any]) -> dict[str, str]:
    """What identifies a dataset, by its attributes, among all that ever had its name."""
    return {
        "scene": str(attributes["scene"]),
        "question": str(attributes["config_digest"]),
        "data": str(attributes["data_digest"]),
    }


def write_record(
    path: Path, files: Iterable[Path], origins: Iterable[Mapping[str, str]], **facts: Any
) -> None:
    """Write the record of a figure or a table, after its files.

    `origins` are those of every dataset that it was made from; `facts` is what else is worth
    keeping, for example a title.
    """
    record = {
        "files": {file.name: digest(file.read_bytes()) for file in files},
        "made_from": sorted(map(dict, origins), key=lambda made_from: made_from["scene"]),
        "code_version": code_version(),
        **facts,
    }
    with complete_file(path) as unfinished:
        unfinished.write_text(
            json.dumps(record, indent=1, ensure_ascii=False) + "\n", encoding="utf-8"
        )


def read_record(path: Path) -> dict[str, Any]:
    """Read what `write_record` wrote."""
    return read_json(path)


def disagreements(
    records: Iterable[Path], origins: Mapping[str, Mapping[str, str]], asked: Mapping[str, Any]
) -> Iterator[str]:
    """Compare what lies in a results folder with itself and with what is asked now.

    `origins` are those of the datasets that lie there now, and `asked` the parts of the
    configuration that they must answer, by the same names.  A sentence for each disagreement.
    """
    for name, configuration in asked.items():
        if name not in origins:
            yield f"The data {name} are missing: run the workflow again."
        elif origins[name]["question"] != question_digest(configuration):
            yield f"The data {name} answer another configuration: run the workflow again."
    present = list(origins.values())
    for path in records:
        record = read_record(path)
        for name, expected in record["files"].items():
            file = path.with_name(name)
            if not file.exists() or digest(file.read_bytes()) != expected:
                yield f"{file} is not the file that its record describes: delete it and run again."
        for made_from in record["made_from"]:
            if made_from not in present:
                yield (
                    f"{path.stem} was made from other data of scene {made_from['scene']} than lie "
                    "there now: run the workflow again."
                )
