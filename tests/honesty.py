"""Stated against true errors of random scenes: ``python tests/honesty.py --seed 1 --count 200``.

It prints every number whose error is more than twice the stated one beyond four units of rounding,
what share that is, and quantiles of the ratio.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

sys.path[:0] = [str(Path(__file__).parents[1] / part) for part in ("src", "workflow/scripts")]

from truth import chains  # noqa: E402


def ratio_of(beyond, stated):
    """True over stated error; infinite where nothing is stated of an error."""
    if beyond <= 0:
        return 0.0
    return beyond / stated if stated > 0 else np.inf


parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--count", type=int, default=200)
arguments = parser.parse_args()
ratios, gains = [], []
for name, stated, true, largest in chains.cases(arguments.seed, arguments.count):
    if np.isnan(stated) and np.isnan(true):
        print(f"scene {arguments.seed} {name}")
        continue
    beyond = true - 4 * np.spacing(largest)
    ratios.append(ratio_of(beyond, stated))
    if np.spacing(largest) < true < np.inf:
        gains.append(stated / true)
    if not ratios[-1] <= 2:
        print(
            f"scene {arguments.seed} {name}: stated {stated:.2e}, true {true:.2e}, "
            f"ratio {ratios[-1]:.3g}",
            flush=True,
        )
shares, parts = np.array(ratios), (0.5, 0.9, 0.99, 0.995, 1)
print(
    f"{shares.size} numbers: {np.mean(shares > 2):.2%} above 2, {np.mean(shares > 10):.2%} above 10"
)
found = ", ".join(f"{value:.3g}" for value in np.quantile(shares, parts, method="higher"))
print(f"true over stated, quantiles {', '.join(map(str, parts))}: {found}")
print(f"stated over true, median where the error is above rounding: {np.median(gains):.3g}")
