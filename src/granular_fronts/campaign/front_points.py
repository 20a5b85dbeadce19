"""Points of exact fronts of the lattice, in their own units δ = c = 1: James (2021), section 6.

See `granular_fronts.fronts` for the solver and its error estimates.  The slowest tail is a root of
the dispersion relation and knows nothing of the solution; a front is monotone where it is real.
"""

import numpy as np
from tqdm import tqdm

from granular_fronts.campaign.kinds import Solved
from granular_fronts.fronts.solve import ERROR_METHOD, evaluate_front, solve_front
from granular_fronts.fronts.tails import tail_roots

MEASURED = ("overshoot", "width_10_90", "slope", "dissipated_power")


def solve_chunk(points, settings):
    """Solve fronts.

    Parameters
    ----------
    points : dict of str to ndarray, shape (lines, fast)
        Parameters of kind ``front``.
    settings : dict
        `scalars`, and `profile` in ξ; a front is always solved to round-off.

    Returns
    -------
    Solved
    """
    profile = settings["profile"]
    xi = None
    if profile is not None:
        xi = np.linspace(profile["start"], profile["stop"], profile["count"])
    shape = points["gamma"].shape
    values = {name: np.full(shape, np.nan) for name in settings["scalars"]}
    if xi is not None:
        values["relative_displacement"] = np.full((*shape, xi.size), np.nan)
    reasons, errors = np.full(shape, "", dtype=object), dict.fromkeys(values, np.nan)
    for index in tqdm(list(np.ndindex(shape)), desc="solving", unit="point", delay=2.0):
        law = [float(points[name][index]) for name in ("alpha", "gamma", "beta")]
        try:
            measured = _measure(solve_front(*law), tail_roots(*law, count=1)[0], xi)
        except (ValueError, ArithmeticError) as error:
            reasons[index] = str(error)
            continue
        for name, value in values.items():
            value[index], error = measured[name]
            errors[name] = np.fmax(errors[name], error)
    return Solved(values, reasons, errors, ERROR_METHOD)


def _measure(front, tail, xi):
    """Each scalar of a front, and its profile, with an error.

    Raises
    ------
    ValueError
        With the reason, if the front has not converged.
    """
    found = front.attrs
    if not found["converged"]:
        raise ValueError(found["reason"])
    measured = {name: (found[name], found[f"{name}_error"]) for name in MEASURED}
    measured |= {
        "tail_rate": (tail.real, np.spacing(tail.real)),
        "tail_wavenumber": (tail.imag, np.spacing(tail.imag)),
        "speed_defect": (found["speed_defect"], np.nan),
        "profile_error": (found["error_estimate"], np.nan),
    }
    if xi is not None:
        measured["relative_displacement"] = (evaluate_front(front, xi), found["error_estimate"])
    return measured
