"""YAML files as people write them: where one is wrong, a sentence says in which line.

In YAML the last of two equal keys wins silently.  Here a key given twice in one mapping is an
error, since one of its values would be ignored.
"""

import functools
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

from granular_fronts.errors import InputError

try:
    from yaml import CSafeLoader as SafeLoader
except ImportError:
    from yaml import SafeLoader

MERGE_TAG = "tag:yaml.org,2002:merge"
"""Tag of the key ``<<``, which may accompany the keys that it merges."""

_DRIVES = ({"constant"}, {"pulse"}, {"half_sine"}, {"harmonic"}, {"table"})

FORMS = {
    "law": ({"alpha"}, {"elastic", "viscous"}),
    "force": _DRIVES,
    "velocity": _DRIVES,
}
"""Keys by which forms of a law, or of a drive, are told apart: a mapping has those of one form."""

LONGEST_FILE = 64 * 2**20
"""Bytes of a file."""


class _Loader(SafeLoader):
    """Safe loader, with libyaml's parser where it is installed, that notes repeated keys."""

    def __init__(self, stream: str) -> None:
        super().__init__(stream)
        self.repeated: list[yaml.ScalarNode] = []
        self.examined: set[int] = set()

    def flatten_mapping(self, node: yaml.MappingNode) -> None:
        """Note the keys written twice, before merged keys join them."""
        if id(node) not in self.examined:
            self.examined.add(id(node))
            self.repeated += _repeated_keys(node)
        super().flatten_mapping(node)


def read_yaml(file: Path | str) -> Any:
    """Read a YAML file, or raise an InputError that names file, line, column and remedy."""
    try:
        with Path(file).open("rb") as stream:
            content = stream.read(LONGEST_FILE + 1)
        text = content.decode("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{file} cannot be read ({error}): name a text file in UTF-8.") from None
    if len(content) > LONGEST_FILE:
        raise InputError(f"{file} is longer than {LONGEST_FILE >> 20} MiB: write fewer values.")
    return parse_yaml(text, file)


def parse_yaml(text: str, file: Path | str) -> Any:
    """Return the contents of a YAML text; sentences of errors begin with `file`."""
    try:
        loader = _Loader(text)
        value = loader.get_single_data()
    except (yaml.YAMLError, ValueError) as error:
        raise InputError(_syntax_error(file, error)) from None
    errors = [
        f"{_position(file, key.start_mark)}: the key {key.value} is given twice in one "
        "mapping, and one of its values would be ignored: keep one."
        for key in loader.repeated
    ]
    if errors:
        raise InputError("\n".join(errors))
    return value


def yaml_errors(files: Sequence[Path | str]) -> Iterator[str]:
    """Read configuration files for their errors only; each must hold a mapping."""
    for file in files:
        try:
            value = read_yaml(file)
        except InputError as error:
            yield str(error)
        else:
            if not isinstance(value, Mapping | None):
                yield (
                    f"{file} holds no mapping of keys to values, as config/default.yaml does: "
                    "write key: value."
                )
            elif value and "__use_yte__" in value:
                yield (
                    f"{file} is a template (__use_yte__), which Snakemake runs as Python: write "
                    "its values themselves."
                )


def load_configuration(*files: Path | str) -> dict:
    """Read YAML files and lay each over the ones before it; the result is not yet checked."""
    errors = [*yaml_errors(files)]
    if errors:
        raise InputError("\n".join(errors))
    return functools.reduce(merge, [read_yaml(file) or {} for file in files], {})


def merge(below: Mapping, above: Mapping) -> dict:
    """Lay one mapping over another, key by key at any depth; a list is replaced as a whole.

    A mapping of another `kind`, or form of `FORMS`, replaces the one below, since their keys do not
    mix.  None takes away a key that is below.
    """
    merged = dict(below)
    for key, value in above.items():
        under: Any = below.get(key)
        both_mappings = isinstance(value, Mapping) and isinstance(under, Mapping)
        if both_mappings and not _are_alternatives(key, under, value):
            merged[key] = merge(under, value)
        elif value is None and key in below:
            del merged[key]
        else:
            merged[key] = value
    return merged


def _are_alternatives(key: str, below: Mapping, above: Mapping) -> bool:
    """Whether two mappings under a key are of different kinds or forms."""
    kinds = below.get("kind"), above.get("kind")
    if all(isinstance(kind, str) for kind in kinds):  # A probe may be called kind.
        return kinds[0] != kinds[1]
    forms = [[form for form in FORMS.get(key, ()) if form & side.keys()] for side in (below, above)]
    return all(forms) and forms[0] != forms[1]


def _repeated_keys(node: yaml.MappingNode) -> Iterator[yaml.ScalarNode]:
    written = set()
    for key, _ in node.value:
        if isinstance(key, yaml.ScalarNode) and key.tag != MERGE_TAG:
            if key.value in written:
                yield key
            written.add(key.value)


def _syntax_error(file: Path | str, error: Any) -> str:
    mark = getattr(error, "problem_mark", None)
    if mark is None:
        reason = " ".join(str(error).split())
        return f"{file} is no YAML ({reason}): correct it."
    return f"{_position(file, mark)}: this is no YAML ({error.problem}): correct it there."


def _position(file: Path | str, mark: yaml.Mark) -> str:
    return f"{file}, line {mark.line + 1}, column {mark.column + 1}"
