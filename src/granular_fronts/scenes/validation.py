"""Scenes by their families, as the configuration names them."""

from collections.abc import Mapping, Sequence
from typing import Any

from granular_fronts.errors import InputError
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.front import Front
from granular_fronts.scenes.orbit import Orbits
from granular_fronts.scenes.ring import Ring
from granular_fronts.scenes.sentences import Scene

SCENES: dict[str, type[Scene]] = {
    "chain": Chain,
    "heteroclinic": Orbits,
    "periodic": Ring,
    "front": Front,
}
"""What a scene is, by its family."""


def check_scene(family: str, scene: Mapping[str, Any], name: str) -> Any:
    """Return the scene of a mapping, which may hold numpy values.

    `family` is a key under ``scenes`` of the configuration, and `name` what the sentences of an
    InputError call the scene.
    """
    return SCENES[family].read(scene, name)


def raise_if_any(sentences: Sequence[str]) -> None:
    """Raise an InputError of some sentences, one a line, if there are any."""
    if sentences:
        raise InputError("\n".join(sentences))
