"""What is true, by programs that are independent of the package that they judge.

Each module has ``cases(seed, count)``.  Of random problems it yields a number's name, its stated
error, its true one, the largest value it was found among, and how many values there are.  They
belong to the scripts and not to the package.  So rules and tests run the same cases, and the
package cannot use them.
"""

from collections.abc import Iterable

import numpy as np

UNITS_OF_ROUNDING = 4
# Share of correct numbers about which nothing can be claimed.
MOST_SILENT = 0.01


def ratio(stated: float, true: float, largest: float) -> float:
    """Return true over stated error, if above four units in the last place of the largest."""
    if stated == np.inf:
        return 0.0  # Nothing is claimed.
    beyond = true - UNITS_OF_ROUNDING * float(np.spacing(largest))
    if beyond <= 0.0:
        return 0.0
    return beyond / stated if stated > 0.0 else np.inf


def hold(found: Iterable[tuple[str, float, float, float, int]], share: float = 1.0) -> bool:
    """Return whether stated errors are honest: a share within twice, all within ten times.

    A problem that was refused has no numbers and is no honest answer.
    """
    numbers = np.array([number for _, *number, _ in found])
    ratios = np.array([ratio(*number) for number in numbers])
    stated, true, _ = numbers[numbers[:, 1] < np.inf].T
    wide = np.median(stated / np.fmax(true, 1e-300))
    silent = np.mean(np.isinf(stated))
    few_wide = wide <= 10.0 and silent <= MOST_SILENT
    return bool(np.mean(ratios <= 2.0) >= share and (ratios <= 10.0).all() and few_wide)
