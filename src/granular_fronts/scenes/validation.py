"""Validate one scene before anything is computed.

There are five levels of checks, and each relies on those before.  The schema in
``workflow/schemas`` says which keys exist, what each means and in which range it lies.  The law
must be possible.  Energies must be numbers that a computer can hold.  Checks tie keys together.
The whole must fit into memory.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from granular_fronts.errors import InputError
from granular_fronts.model.laws import Law
from granular_fronts.scenes.chain import CHAIN
from granular_fronts.scenes.laws import is_of_potentials, law_errors, made_law
from granular_fronts.scenes.orbit import ORBIT
from granular_fronts.scenes.ring import RING
from granular_fronts.scenes.schema import violations
from granular_fronts.scenes.sections import Check, section_errors

SCENES: dict[str, tuple[Check, ...]] = {
    "chain": CHAIN,
    "heteroclinic": ORBIT,
    "periodic": RING,
    "front": (),
}
"""Checks of a scene, by its family."""

ANY_LAW = {"alpha": 1, "beta": 1, "gamma": 0}


def check_scene(family: str, scene: Mapping[str, Any], name: str) -> dict[str, Any]:
    """Validate a scene.

    Parameters
    ----------
    family : str
        Key under ``scenes`` of the configuration, for example ``chain``.
    scene : Mapping
        One entry of that family.  It may hold numpy arrays and numbers, and as `law` a `Law` or a
        mapping for `make_law`.
    name : str
        What the sentences call the scene.

    Returns
    -------
    dict
        The scene in plain Python values, as a configuration file would hold it, but for a `Law`.

    Raises
    ------
    InputError
        With one sentence for each thing that is wrong.
    """
    plain = _plain(scene)
    place = ("scenes", family, name)
    if isinstance(plain, dict) and is_of_potentials(plain.get("law")):
        raise_if_any([f"Scene {name}: {error}" for error in law_errors(plain)])
        plain["law"] = made_law(plain["law"])
    # A law that is made already obeys the schema.
    has_law = isinstance(plain, dict) and isinstance(plain.get("law"), Law)
    as_written = plain | {"law": ANY_LAW} if has_law else plain
    raise_if_any(
        [*violations(as_written, definition=f"{family}_scene", place=place)]
        or [f"Scene {name}: {error}" for error in section_errors(plain, SCENES[family])]
    )
    return plain


def raise_if_any(sentences: Sequence[str]) -> None:
    """Raise an InputError of some sentences, one a line, if there are any."""
    if sentences:
        raise InputError("\n".join(sentences))


def _plain(value: Any) -> Any:
    """Turn numpy values and mappings into what YAML would have given."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return value
