"""What the figures and the table of printed numbers draw from scenes, and so these must record.

The table judges statements on the paper's parameters only, so that it asks for records, but for no
values of parameters: where one is missing, its statements are not measured.
"""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from granular_fronts.scenes.validation import section_label


class Need(NamedTuple):
    """A key that must be there and not be empty, and the values that a list must hold.

    Attributes
    ----------
    key : str
        Dotted key inside the section.
    user : str
        What draws or tabulates it.
    values : tuple of float
        Entries that the list must have.
    entries : int
        How many entries a list must have at the least.
    """

    key: str
    user: str
    values: tuple[float, ...] = ()
    entries: int = 1


TABLE = "the table of printed numbers"

NEEDS: dict[str, tuple[Need, ...]] = {
    "scenes.chain.initiation_underdamped": (
        Need("record.snapshots", "figure 1"),
        Need("record.probes.steady", "figure 1"),
        Need("record.probes.transient", "figure 1"),
        Need("record.grid", "figure 2"),
        Need("record.arrival_level", TABLE),
        Need("record.extremes", TABLE),
        Need("record.balances", "the check of its energy balance"),
    ),
    "scenes.chain.initiation_overdamped": (
        Need("record.probes.transient", "figure 3"),
        Need("record.grid", "figure 3"),
        Need("record.arrival_level", TABLE),
        Need("record.extremes", TABLE),
        Need("record.balances", "the check of its energy balance"),
    ),
    "scenes.heteroclinic.front_profiles": (
        Need("well", "figure 8"),
        Need("portrait", "figure 8"),
    ),
    "scenes.heteroclinic.damping_sweep": (Need("mu", TABLE),),
    "scenes.periodic.weak": (
        Need("record.snapshots", "figure 5", (0.0,)),
        Need("record.snapshots", "the speed in the table of printed numbers", entries=2),
    ),
    "scenes.periodic.hertz": (
        Need("record.snapshots", "figure 5", (0.0,)),
        Need("record.snapshots", "the speed in the table of printed numbers", entries=2),
    ),
    "scenes.front.underdamped": (Need("window", "figure 9"),),
    "scenes.front.overdamped": (Need("window", "figure 9"),),
    "laws.piston": (
        Need("cases.kuwabara_kono", TABLE),
        Need("cases.dashpot", TABLE),
        Need("cases.simon_hunt_crossley", TABLE),
    ),
    "laws.materials": (
        Need("beads.glass", TABLE),
        Need("beads.steel", TABLE),
        Need("beads.cork", TABLE),
    ),
}
"""Needs by the path of a section in the configuration."""


def need_errors(configuration: Mapping) -> Iterator[str]:
    """Find what figures need and the configuration lacks.

    Parameters
    ----------
    configuration : Mapping
        One that obeys the schema.

    Yields
    ------
    str
        A sentence for each, which names the figure.
    """
    for path, needs in NEEDS.items():
        section = _look_up(configuration, path)
        if section is None:
            yield (
                f"{path} is missing, but {needs[0].user} needs it: give it as config/default.yaml "
                "does."
            )
            continue
        for need in needs:
            found = _look_up(section, need.key)
            yield from _errors_of_need(need, section_label(path) + need.key, found)


def _errors_of_need(need: Need, place: str, found: Any) -> Iterator[str]:
    if not found:
        yield (
            f"{place} is {'missing' if found is None else 'empty or off'}, but {need.user} needs "
            "it: give it as config/default.yaml does."
        )
        return
    missing = [f"{value:g}" for value in need.values if value not in found]
    if missing:
        yield (
            f"{place} is {found}, but {need.user} needs {', '.join(missing)} too: add "
            f"{'it' if len(missing) == 1 else 'them'}."
        )
    if isinstance(found, list) and len(found) < need.entries:
        yield (
            f"{place} is {found}, but {need.user} needs {need.entries} entries or more: add one."
        )


def _look_up(section: Any, key: str) -> Any:
    """The value at a dotted key, or None."""
    for name in key.split("."):
        if not isinstance(section, Mapping) or name not in section:
            return None
        section = section[name]
    return section
