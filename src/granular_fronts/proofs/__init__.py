"""Fronts that are proved: existence, enclosure, uniqueness, stability and shape by ball arithmetic.

A *certificate* is a file of an approximate front P̄ and of an approximate inverse A of the
linearisation there. `certificate` makes it with floating-point arithmetic, by any method. `checker`
then proves, in balls and with only python-flint and NumPy, that a front exists near P̄, and what it
looks like.  `families` joins certificates to a continuous family.  `dashpots` does the same for
linear dashpots (β = 1).

The mathematics is in the docstrings, lemma by lemma.
"""

from importlib.util import find_spec

if find_spec("flint") is None:
    raise ModuleNotFoundError(
        "Proofs of fronts need python-flint: install it by pip install 'granular-fronts[proofs]'.",
        name="flint",
    )
