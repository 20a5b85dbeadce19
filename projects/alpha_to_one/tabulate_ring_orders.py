"""The orders in ε of errors on rings, of u and of ẋ."""

import math
from collections.abc import Iterator
from typing import Any

import pandas as pd
import xarray as xr

from granular_fronts.accuracy import Estimate
from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import write_table
from job import job
from limit_measures import fitted_order

EQUATIONS = {
    "logarithmic": "logarithmic Burgers",
    "unlimited": "finite-α Burgers",
    "dispersive": "logarithmic KdV–Burgers",
}
SYMBOLS = {"damping": "γc", "gamma": "γ", "mu": "μ"}
FORMULAS = {"leading": "(51)", "printed": "(43) as printed", "first_order": "whole first order"}


def tabulate_ring_orders(damping: str, gamma: str, mu: str, csv: str, markdown: str) -> None:
    """Write a row for each line.

    Parameters
    ----------
    damping, gamma, mu : str
        Campaigns of rings at fixed γc, γ and μ.
    csv, markdown : str
        Tables to write: all digits, and the digits that the errors leave for reading.
    """
    campaigns = {"damping": damping, "gamma": gamma, "mu": mu}
    lines = [line for fixed in campaigns for line in _lines(read_dataset(campaigns[fixed]), fixed)]
    full = pd.DataFrame(
        line | {"order": order.value, "error": order.error} for line, order in lines
    )
    brief = pd.DataFrame(line | {"order in ε": with_error(order)} for line, order in lines)
    write_table(full, brief, csv, markdown)


def _lines(rings: xr.Dataset, fixed: str) -> Iterator[tuple[dict[str, str], Estimate]]:
    """What each line of a campaign shows, and its order."""
    errors = {f"displacement_sup_{name}": f"u, {words}" for name, words in EQUATIONS.items()}
    errors |= {f"residual_{formula}": f"ẋ, {words}" for formula, words in FORMULAS.items()}
    places: list[dict[str, Any]] = [
        {fixed: value} for value in (rings[fixed].values if fixed in rings.dims else [])
    ]
    for place in places or [{}]:
        value = place.get(fixed, rings.attrs.get(fixed))
        for error in filter(rings.data_vars.__contains__, errors):
            line = {"fixed": f"{SYMBOLS[fixed]} = {value:g}", "error of": errors[error]}
            yield line, fitted_order(rings, error, **place)


def with_error(order: Estimate) -> str:
    """A fitted order and its error, with the digits that the error leaves, two at least."""
    # A line through two points says nothing of its error, one through a ring that failed neither.
    if not order.error > 0.0:
        return f"{order.value:z.2f}".replace("-", "−")
    digits = max(2, math.ceil(-math.log10(order.error)))
    above = math.ceil(order.error * 10**digits) / 10**digits
    return f"{order.value:z.{digits}f} ± {above:.{digits}f}".replace("-", "−")


if __name__ == "__main__":
    with job(snakemake):
        tabulate_ring_orders(
            snakemake.input.damping,
            snakemake.input.gamma,
            snakemake.input.mu,
            snakemake.output.csv,
            snakemake.output.markdown,
        )
