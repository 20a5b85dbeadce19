"""Certificates for all γ of an interval, one after another, that form one continuous family."""

import time
from fractions import Fraction
from pathlib import Path

from granular_fronts.errors import InputError
from granular_fronts.fronts.solve import solve_front
from granular_fronts.proofs.arrays import ends
from granular_fronts.proofs.balls import NotProvedError
from granular_fronts.proofs.certificate import CELLS, DRIFT, FINE, describe, interval_of, rational
from granular_fronts.proofs.families import prove, record
from granular_fronts.proofs.stored import write

STEP = Fraction(1, 10**6)  # ends of intervals are multiples of this
NARROWEST = 4  # steps: what is not proved on such an interval is given up
NARROW = 500  # steps of an interval that need not conclude whether its fronts are monotone
FIRST_GROWTH = Fraction(3, 2)  # of the width after a proof, until one has failed
GROWTH = Fraction(21, 20)  # from then on
CAUTION = Fraction(7, 10)  # by which the width shrinks where nothing is proved
ROOM = 0.85  # Z1 above which the width does not grow
CONCLUSIONS = {"overshoot", "oscillates", "critical", "monotone"}


def prove_interval(alpha, low, high, folder, cells=CELLS, fine=FINE, drift=DRIFT, width="1/500"):
    """Write certificates of neighbouring intervals of γ from `low` to `high`, each one proved.

    Each is proved from its file.  Certificates that the folder holds are proved again and kept; one
    that is not proved is made anew.

    Parameters
    ----------
    alpha : int, str, Fraction or pair of them
    low, high : str or Fraction
        With at most six decimals.
    folder : str or path
    cells, fine, drift : optional
        See `prove_front`.
    width : str or Fraction, optional
        Of the first interval; it then follows what could be proved.

    Yields
    ------
    dict
        For each certificate, in the order of γ, its `families.record` and `seconds`, the processor
        time of all attempts to make and prove it.

    Raises
    ------
    NotProvedError
        Where even narrow intervals are not proved.
    """
    alpha, folder = interval_of(alpha, "alpha", above=1), Path(folder)
    at, high, width = rational(low, "low"), rational(high, "high"), rational(width, "width")
    if (at / STEP).denominator != 1 or (high / STEP).denominator != 1:
        raise InputError("the ends of an interval of gamma have at most six decimals.")
    folder.mkdir(parents=True, exist_ok=True)
    last, steps, growth = None, int(width / STEP), FIRST_GROWTH
    start = time.process_time()
    while at < high:
        path = folder / f"{float(at):.6f}.npz"
        if not path.exists():
            interval = at, min(at + steps * STEP, high)
            front = solve_front(float(sum(alpha) / 2), float(sum(interval) / 2))
            write(path, describe(front, alpha, interval, cells, fine, drift))
        try:
            found = prove(path, last)
            _require_place(found, alpha, at, high)
            _require_conclusion(found)
        except NotProvedError:
            path.unlink()
            if steps <= NARROWEST:
                raise
            steps, growth = max(NARROWEST, int(CAUTION * steps)), GROWTH
            continue
        now = time.process_time()
        yield record(path, found) | {"seconds": now - start}
        begin, at = ends(found.data, "gamma")
        steps = int((at - begin) / STEP * (growth if found.Z1 < ROOM else 1)) + 1
        start, last = now, found


def _require_place(front, alpha, at, high):
    low, end = ends(front.data, "gamma")
    if low != at or not low < end <= high or ends(front.data, "alpha") != alpha:
        raise NotProvedError("a certificate in the folder belongs to another interval")


def _require_conclusion(front):
    """Stop where a narrower interval may show whether its fronts are monotone or overshoot."""
    low, high = ends(front.data, "gamma")
    open_question = "roots" in front.data and not CONCLUSIONS & front.numbers.keys()
    if open_question and high - low > NARROW * STEP:
        raise NotProvedError("the interval is too wide to say whether its fronts are monotone")
