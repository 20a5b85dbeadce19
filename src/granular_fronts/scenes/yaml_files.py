"""YAML files as people write them: where one is wrong, a sentence says in which line.

YAML itself lets the last of two equal keys win without a word; here a key that stands twice in one
mapping is an error, since one of its two values would be ignored.
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
"""Tag of the key ``<<``, which may stand beside the keys that it merges."""


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
    """Read a YAML file.

    Parameters
    ----------
    file : Path or str
        A file in UTF-8.

    Returns
    -------
    object
        What it holds; None for an empty file.

    Raises
    ------
    InputError
        If the file is missing, is no YAML, or has a key twice in one mapping: file, line, column
        and what to do, one sentence for each key.
    """
    try:
        loader = _Loader(Path(file).read_text(encoding="utf-8"))
        value = loader.get_single_data()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{file} cannot be read ({error}): name a text file in UTF-8.") from None
    except yaml.YAMLError as error:
        raise InputError(_syntax_error(file, error)) from None
    if loader.repeated:
        raise InputError(
            "\n".join(
                f"{_position(file, key.start_mark)}: the key {key.value} stands twice in one "
                "mapping, and one of its values would be ignored: keep one."
                for key in loader.repeated
            )
        )
    return value


def yaml_errors(files: Sequence[Path | str]) -> Iterator[str]:
    """Read files for their errors only.

    Parameters
    ----------
    files : sequence of Path or str
        Configuration files.

    Yields
    ------
    str
        The sentences of `read_yaml`, and one for each file that does not hold a mapping.
    """
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
    """Read YAML files and lay each over the ones before it.

    Parameters
    ----------
    *files : Path or str
        The first holds the defaults, each later one overrides single keys.

    Returns
    -------
    dict
        The merged configuration, not yet checked.

    Raises
    ------
    InputError
        If a file cannot be read as a mapping.
    """
    errors = [*yaml_errors(files)]
    if errors:
        raise InputError("\n".join(errors))
    return functools.reduce(merge, [read_yaml(file) or {} for file in files], {})


def merge(below: Mapping, above: Mapping) -> dict:
    """Lay one mapping over another, key by key at any depth.

    Parameters
    ----------
    below, above : Mapping
        Where both hold a mapping under a key, the two are merged; otherwise `above` wins. A list
        is replaced as a whole. This is how Snakemake merges its configuration files.

    Returns
    -------
    dict
        The merged mapping; the arguments are left alone.
    """
    merged = dict(below)
    for key, value in above.items():
        both_mappings = isinstance(value, Mapping) and isinstance(below.get(key), Mapping)
        merged[key] = merge(below[key], value) if both_mappings else value
    return merged


def _repeated_keys(node: yaml.MappingNode) -> Iterator[yaml.ScalarNode]:
    written = set()
    for key, _ in node.value:
        if isinstance(key, yaml.ScalarNode) and key.tag != MERGE_TAG:
            if key.value in written:
                yield key
            written.add(key.value)


def _syntax_error(file: Path | str, error: yaml.YAMLError) -> str:
    mark = getattr(error, "problem_mark", None)
    if mark is None:
        reason = " ".join(str(error).split())
        return f"{file} is no YAML ({reason}): correct it."
    return f"{_position(file, mark)}: this is no YAML ({error.problem}): correct it there."


def _position(file: Path | str, mark: yaml.Mark) -> str:
    return f"{file}, line {mark.line + 1}, column {mark.column + 1}"
