"""The section ``proofs``: which fronts are proved, and which of them is drawn."""

from collections.abc import Iterator, Mapping
from itertools import pairwise

from granular_fronts.scenes.sections import Check


def _shown_front_is_proved(section: Mapping) -> Iterator[str]:
    """The front that is drawn is one of those that are proved."""
    if section["shown"] not in section["fronts"]:
        yield (
            f"shown is {section['shown']}, which is not proved: choose one of "
            f"{', '.join(section['fronts'])}."
        )
    elif "beta" in section["fronts"][section["shown"]]:
        yield f"shown is {section['shown']}, with β = 1, but figure 24 needs β = α: choose another."


def _parts_increase(section: Mapping) -> Iterator[str]:
    """Intervals of γ, and their parts, go up."""
    numbers = {
        f"fronts.{name}.gamma": front["gamma"]
        for name, front in section["fronts"].items()
        if isinstance(front["gamma"], list)
    }
    for name, family in section["intervals"].items():
        numbers[f"intervals.{name}"] = [family["from"], *(part["to"] for part in family["parts"])]
    for key, ends in numbers.items():
        for low, high in pairwise(ends):
            if low >= high:
                yield (
                    f"{key} goes from {low} to {high}, but γ must grow: lower the first "
                    "or raise the second."
                )


PROOFS: tuple[Check, ...] = (_shown_front_is_proved, _parts_increase)
