"""What is true, by programs that are independent of the package that they judge.

Each module has ``cases(seed, count)``, which yields of random problems the name of a number, its
stated error, its true one and the largest value it was found among.  They stand beside the scripts
and not in the package, so that rules and tests run the same cases and the package cannot use them.
"""

UNITS_OF_ROUNDING = 4


def ratio(stated: float, true: float, largest: float) -> float:
    """True over stated error, of what exceeds four units in the last place of the largest value."""
    beyond = true - UNITS_OF_ROUNDING * abs(largest) * 2.0**-52
    if beyond <= 0.0:
        return 0.0
    return beyond / stated if stated > 0.0 else float("inf")
