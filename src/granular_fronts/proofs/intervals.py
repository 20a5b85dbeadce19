"""Certificates for all γ of an interval, one after another, that form one continuous family."""

from fractions import Fraction
from pathlib import Path

import numpy as np
from flint import ctx

from granular_fronts.errors import InputError
from granular_fronts.fronts.solve import solve_front
from granular_fronts.proofs.balls import NotProvedError
from granular_fronts.proofs.certificate import describe, rational
from granular_fronts.proofs.checker import PRECISION, Front, read
from granular_fronts.proofs.consequences import shape
from granular_fronts.proofs.families import join

STEP, NARROWEST = Fraction(1, 10**6), 4
GROWTH, CAUTION = Fraction(5, 4), Fraction(7, 10)


def prove_interval(alpha, low, high, folder, cells=20, fine=40, drift=6e-4, width="1/2000"):
    """Write certificates of neighbouring intervals of γ from `low` to `high`, each one proved.

    What a folder holds already is kept, and continued.

    Parameters
    ----------
    alpha : int, str or Fraction
    low, high : str or Fraction
        With at most six decimals.
    folder : str or path
    cells, fine, drift : optional
        See `prove_front`.
    width : str or Fraction, optional
        Of the first interval; it then follows what could be proved.

    Yields
    ------
    path
        Each new certificate, proved and joined to the one before.

    Raises
    ------
    NotProvedError
        Where even narrow intervals are not proved.
    """
    alpha, high, folder = rational(alpha, "alpha", above=1), rational(high, "high"), Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    at, last, steps = rational(low, "low"), None, int(rational(width, "width") / STEP)
    if (at / STEP).denominator != 1 or (high / STEP).denominator != 1:
        raise InputError("the ends of an interval of gamma have at most six decimals.")
    done = sorted(folder.glob("*.npz"))
    if done:
        last = _proved(read(done[-1]))
        at = Fraction(*last.data["gamma"].tolist()[2:])
    while at < high:
        end = min(at + steps * STEP, high)
        front = solve_front(float(alpha), float((at + end) / 2))
        data = describe(front, alpha, (at, end), cells, fine, drift)
        try:
            found = _proved(data, last)
        except NotProvedError:
            if steps <= NARROWEST:
                raise
            steps = max(NARROWEST, int(CAUTION * steps))
            continue
        path = folder / f"{float(at):.6f}.npz"
        with path.with_suffix(".part").open("wb") as file:
            np.savez_compressed(file, **data)
        path.with_suffix(".part").replace(path)
        yield path
        at, last, steps = end, found, max(steps + 1, int(GROWTH * steps))


def _proved(data, last=None):
    """The front of a certificate, proved, and joined to the one before."""
    before, ctx.prec = ctx.prec, PRECISION
    try:
        front = Front(data)
        list(front.exists()), list(shape(front)), list(front.rear())
        if last is not None:
            join(last, front)
        return front
    finally:
        ctx.prec = before
