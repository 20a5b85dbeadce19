"""Read the arrays of a certificate, and check their kinds and shapes."""

from decimal import Context, Decimal, Inexact
from fractions import Fraction
from pathlib import Path

import numpy as np
from flint import arb, fmpq

from granular_fronts.proofs.balls import NotProvedError

LONGEST = 1000  # of the sizes that a certificate names
LARGEST = 2**28  # bytes of all its arrays
LONGEST_CHECK = 60.0  # seconds that a check may take; of these, measured,
PAIR, ENTRY = 2e-6, 5e-6  # for two rows of the matrix, and for a cell of an inverse
FINE, PIECE = 3e-4, 5e-4  # for a cell of the kernel on one bead, and for a polynomial
DECIMALS = Context(prec=99, traps=[Inexact])  # more digits than 64 bits over 64 bits can have


def load(path):
    """Return the arrays of a file, about which nothing is assumed."""
    if not Path(path).exists():
        raise NotProvedError(f"there is no file {path}")
    if not Path(path).is_file():
        raise NotProvedError(f"{path} is no regular file")
    try:
        with open(path, "rb") as stream, np.load(stream, allow_pickle=False) as file:
            if sum(member.file_size for member in file.zip.infolist()) <= LARGEST:
                return {name: file[name] for name in file.files}
    except Exception as error:
        raise NotProvedError(f"{path} is no file of arrays as prove_front writes it") from error
    raise NotProvedError(f"{path} holds more than {LARGEST >> 20} MiB")


def require_arrays(data, fields, sizes):
    """Stop unless there are exactly some fields, of their kinds and axes, and so many sizes.

    α and γ are intervals: both ends as fractions.
    """
    if sorted(data) != sorted(fields):
        raise NotProvedError(f"the fields are {sorted(data)}, not {sorted(fields)}")
    for name, values in data.items():
        kind = values.dtype.str[1:], values.ndim
        if kind != fields[name] or not values.size or not np.isfinite(values).all():
            raise NotProvedError(f"{name} is {kind}, not finite numbers {fields[name]}")
    found = data["sizes"]
    if found.shape != (sizes,) or found.min() < 1 or found.max() > LONGEST:
        raise NotProvedError(f"sizes are {found}, not {sizes} numbers from 1 to {LONGEST}")
    for name in ("alpha", "gamma"):
        if data[name].shape != (4,) or data[name][1::2].min() < 1:
            raise NotProvedError(f"{name} is not two fractions")
        low, below, high, under = data[name].tolist()
        if low * under > high * below:
            raise NotProvedError(f"{name} falls")


def require_lengths(have, want):
    """Stop unless arrays have the lengths that follow from the sizes."""
    if have != want:
        raise NotProvedError(f"the arrays have the lengths {have}, not {want}")


def require_short(rows, entries, fine, pieces):
    """Stop before a check that would take more than a minute: of a matrix, inverses and cells."""
    seconds = PAIR * rows**2 + ENTRY * entries + FINE * fine + PIECE * pieces
    if seconds > LONGEST_CHECK:
        raise NotProvedError(
            f"its check would take about {seconds:.0f} s, and above {LONGEST_CHECK:.0f} s none is"
            " begun"
        )


def ends(data, name):
    """Return both ends of the interval of α or γ, for all of which a certificate speaks."""
    low, below, high, under = data[name].tolist()
    return Fraction(low, below), Fraction(high, under)


def written(number):
    """Return a fraction as a decimal where it is one, so that no digit is lost."""
    try:
        return f"{DECIMALS.divide(Decimal(number.numerator), Decimal(number.denominator)):f}"
    except Inexact:
        return str(number)


def in_words(interval, symbol):
    """Return the interval of α or γ as a part of a statement."""
    low, high = map(written, interval)
    return f"{symbol} = {low}" if low == high else f"each {symbol} in [{low}, {high}]"


def both_ends(data, name):
    """Return both ends of the interval of α or γ, as balls."""
    return [arb(fmpq(end.numerator, end.denominator)) for end in ends(data, name)]
