"""How an interval of γ that is to be proved is cut into chunks, each a job of its own."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

STEP = Fraction(1, 10**6)  # ends of chunks are multiples of this


def proof_chunks(family: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Cut a family under ``proofs.intervals`` of the configuration into chunks that meet.

    Yields the arguments of `prove_interval` but the folder; ends are decimals in text.
    """
    low = _on_grid(Fraction(str(family["from"])))
    for part in family["parts"]:
        start, high, count = low, Fraction(str(part["to"])), part["chunks"]
        options = {name: part[name] for name in ("cells", "fine", "drift") if name in part}
        for k in range(1, count + 1):
            end = _on_grid(start + (high - start) * k / count)
            yield {"alpha": family["alpha"], "low": _decimal(low), "high": _decimal(end)} | options
            low = end


def chunk_name(chunk: Mapping[str, Any]) -> str:
    """Return both ends of a chunk, as its files are named."""
    return f"{chunk['low']}-{chunk['high']}"


def _on_grid(value: Fraction) -> Fraction:
    return round(value / STEP) * STEP


def _decimal(value: Fraction) -> str:
    return f"{float(value):.6f}"
