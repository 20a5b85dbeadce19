r"""Fronts over the plane of exponent and damping as curves: profiles, tails, multipliers.

In the frame δ = c = 1 a front with :math:`\beta = \alpha` depends only on α and γ.  At each point
of a grid the exact front is kept with all that `granular_fronts.studies.front_survey` says of it,
and

- u of the three continuum fronts (`granular_fronts.studies.continuum_fronts`) at the same ξ,
- the roots λ that describe its tail, those that decay slowest first,
- its Floquet multipliers of largest modulus.

The places ξ = n − ct of a front are at equal distances over a window of its own.  It begins where
the tail is within `SHOWN` of 1, or after `OSCILLATIONS` oscillations, and ends where u has fallen
to `SHOWN`.

Errors.  Profiles carry the error of the exact fronts, the largest difference to a finer solution.
The multiplier of translation is 1 exactly; its distance from 1 measures each spectrum
(`translation_defect`).  Multipliers near 0 belong to beads that the front has not reached, and have
no meaning (`granular_fronts.fronts.linear.floquet`).  Where the longest window does not hold a
front, there are none, and `verdict` says so.
"""

import numpy as np

from granular_fronts.accuracy import EPSILON
from granular_fronts.fronts.linear.floquet import LARGEST_DEFECT, front_multipliers
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.solve import ERROR_METHODS, evaluate_front
from granular_fronts.studies.continuum_fronts import (
    HETEROCLINIC,
    LOGARITHMIC,
    UNLIMITED,
    continuum_fronts,
)
from granular_fronts.studies.front_survey import (
    over_plane,
    properties_of,
    solve_converged,
    without_dimensions,
)
from granular_fronts.studies.fronts_compared import CONTINUUM_METHOD

PLACES = 401
ROOTS = 6
MULTIPLIERS = 120
SCALARS = (
    "beads_behind",
    "translation_defect",
    "spectral_radius_without_translation",
    "verdict",
)
"""What is kept of a spectrum in addition to its multipliers."""

SHOWN = 1e-3
"""Distance from 1, or from 0, at which a front counts as there."""

OSCILLATIONS = 8.0
MARGIN = 0.1
"""Margin of the window on either side."""

TRANSLATION_METHOD = "largest distance of the multiplier of translation from 1"

DIGITS = 4.0
"""Units of the last digit to which tail roots are good."""


def collect_fronts(exponents, dampings):
    """Solve a front with δ = c = 1 at each exponent α > 1 and damping γ > 0 and keep its curves.

    On (alpha, gamma, place): `xi`, and `relative_displacement` of the exact front and, with a
    suffix, of each continuum front.  On (alpha, gamma, root): `tail_root_real` and `_imaginary`. On
    (alpha, gamma, multiplier): `multiplier_real` and `_imaginary`, translation first, then by
    decreasing modulus, NaN beyond the last.  On (alpha, gamma): `beads_behind`,
    `translation_defect`, `spectral_radius_without_translation`, `verdict` in words, and what
    `survey_fronts` keeps.
    """
    return _with_errors(over_plane(exponents, dampings, _collect_front, "collection of fronts"))


def collect_plane(alpha, gamma):
    """Collect fronts over exponents, a list, and dampings, as of `numpy.geomspace`."""
    return collect_fronts(alpha, np.geomspace(**gamma))


def _collect_front(alpha, gamma):
    """Return one front, as a mapping of names to dimensions and values."""
    front = solve_converged(alpha, gamma)
    roots = tail_roots(alpha, gamma, count=ROOTS)
    multipliers, of_spectrum = largest_multipliers(front)
    xi = window(front, roots[0])
    profiles = {"": evaluate_front(front, xi)}
    profiles |= {f"_{name}": u for name, (u, _) in continuum_fronts(alpha, gamma, xi).items()}
    return {
        "xi": (("place",), xi),
        **{f"relative_displacement{name}": (("place",), u) for name, u in profiles.items()},
        **parts("tail_root", "root", roots),
        **parts("multiplier", "multiplier", multipliers),
        **without_dimensions(properties_of(front) | of_spectrum),
    }


def largest_multipliers(front):
    """Return the multipliers of a front, NaN where no window holds it, and what is said of them."""
    spectrum = front_multipliers(front)
    found = {name: spectrum.attrs[name] for name in SCALARS}
    multipliers = np.full(MULTIPLIERS, complex(np.nan, np.nan))
    if spectrum.attrs["flow_residual"] <= LARGEST_DEFECT:
        multipliers[: spectrum.size] = spectrum.values[:MULTIPLIERS]
        return multipliers, found
    undecided = f"undecided: {found['beads_behind']} beads behind do not hold so wide a front"
    unknown = dict.fromkeys(("translation_defect", "spectral_radius_without_translation"), np.nan)
    return multipliers, found | unknown | {"verdict": undecided}


def window(front, root):
    """Return the places ξ, shape (PLACES,), that show a front whose tail is governed by a root."""
    xi, u = front["xi"].values, front["relative_displacement"].values
    first, last = xi[np.abs(u - 1.0) > SHOWN][0], xi[u > SHOWN][-1]
    if root.imag > 0.0:
        first = max(first, -OSCILLATIONS * 2.0 * np.pi / root.imag)
    margin = MARGIN * (last - first)
    return np.linspace(first - margin, last + margin, PLACES)


def parts(name, dimension, values):
    """Return the real and imaginary parts, which netCDF can hold."""
    return {
        f"{name}_real": ((dimension,), values.real),
        f"{name}_imaginary": ((dimension,), values.imag),
    }


def _with_errors(collection):
    """Return the collection with error estimates at its curves."""
    continuum = [f"relative_displacement_{name}" for name in (LOGARITHMIC, UNLIMITED, HETEROCLINIC)]
    fronts, defects = (float(collection[name].max()) for name in ("error", "translation_defect"))
    for names, error, method in (
        (["relative_displacement"], fronts, ERROR_METHODS["profile"]),
        (continuum, EPSILON, CONTINUUM_METHOD),
        (["tail_root_real", "tail_root_imaginary"], DIGITS * EPSILON, "rounding, relative"),
        (["multiplier_real", "multiplier_imaginary"], defects, TRANSLATION_METHOD),
    ):
        for name in names:
            collection[name].attrs |= {"error_estimate": error, "error_method": method}
    return collection
