"""How an interval of γ that is to be proved is cut into chunks, each a job of its own."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

STEP = Fraction(1, 10**6)
"""Ends of chunks are multiples of this."""


def proof_chunks(family: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Cut a family of fronts into chunks that meet at their ends.

    Parameters
    ----------
    family : mapping
        `alpha`, `from` (a γ) and `parts`, as under ``proofs.intervals`` of the configuration.

    Yields
    ------
    dict
        `alpha`, `low` and `high` as decimals in text, and what else the part says of the proof.
    """
    low = _on_grid(Fraction(str(family["from"])))
    for part in family["parts"]:
        high, count = Fraction(str(part["to"])), part["chunks"]
        start = low
        for k in range(1, count + 1):
            end = _on_grid(start + (high - start) * k / count)
            options = {name: part[name] for name in ("cells", "fine", "drift") if name in part}
            yield {"alpha": family["alpha"], "low": _decimal(low), "high": _decimal(end)} | options
            low = end


def chunk_name(chunk: Mapping[str, Any]) -> str:
    """Both ends of a chunk, as its files are named."""
    return f"{chunk['low']}-{chunk['high']}"


def _on_grid(value: Fraction) -> Fraction:
    return round(value / STEP) * STEP


def _decimal(value: Fraction) -> str:
    return f"{float(value):.6f}"
