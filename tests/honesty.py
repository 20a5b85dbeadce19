"""Stated against true errors of random scenes: ``python tests/honesty.py --seed 1 --count 200``.

It prints every number whose error is more than twice the stated one beyond four units of rounding,
what share that is, and quantiles of the ratio.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

sys.path[:0] = [str(Path(__file__).parents[1] / part) for part in ("src", "workflow/scripts")]

from truth import ratio  # noqa: E402
from truth.chains import cases  # noqa: E402

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--count", type=int, default=200)
arguments = parser.parse_args()
ratios, gains = [], []
for name, stated, true, largest in cases(arguments.seed, arguments.count):
    times = ratio(stated, true, largest)
    if not times <= 2:
        print(
            f"seed {arguments.seed}, {name}: stated {stated:.2e}, true {true:.2e}, "
            f"ratio {times:.3g}",
            flush=True,
        )
    if not np.isnan(largest):
        ratios.append(times)
        if true > np.spacing(largest):
            gains.append(stated / true)
shares, parts = np.array(ratios), (0.5, 0.9, 0.99, 0.995, 1)
above = [f"{np.mean(shares > limit):.2%} above {limit}" for limit in (2, 10)]
print(f"{shares.size} numbers: {', '.join(above)}")
found = ", ".join(f"{value:.3g}" for value in np.quantile(shares, parts, method="higher"))
print(f"true over stated, quantiles {', '.join(map(str, parts))}: {found}")
print(f"stated over true, median where the error is above rounding: {np.nanmedian(gains):.3g}")
