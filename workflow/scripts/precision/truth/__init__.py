"""What is true, by programs that are independent of the package that they judge.

Each module has ``cases(seed, count)``, which yields of random problems the name of a number, its
stated error, its true one and the largest value it was found among.  They stand beside the scripts
and not in the package, so that rules and tests run the same cases and the package cannot use them.
"""

from collections.abc import Iterable

import numpy as np

UNITS_OF_ROUNDING = 4


def ratio(stated: float, true: float, largest: float) -> float:
    """True over stated error, of what exceeds four units in the last place of the largest value."""
    beyond = true - UNITS_OF_ROUNDING * float(np.spacing(largest))
    if beyond <= 0.0:
        return 0.0
    return beyond / stated if stated > 0.0 else np.inf


def hold(found: Iterable[tuple[str, float, float, float]], share: float = 1.0) -> bool:
    """Whether stated errors are honest: a share within twice, all within ten times, few too wide.

    A problem that was refused has no numbers and is no honest answer.
    """
    numbers = [number for _, *number in found]
    ratios = np.array([ratio(*number) for number in numbers])
    wide = np.median([stated / max(true, 1e-300) for stated, true, _ in numbers])
    return bool(np.mean(ratios <= 2.0) >= share and (ratios <= 10.0).all() and wide <= 10.0)
