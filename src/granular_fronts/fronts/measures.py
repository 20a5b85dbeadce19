"""What the paper says of fronts in numbers, measured on exact fronts.

A measure takes the dataset of a front scene (see `comparison`), or that of the curves of critical
damping (see `damping_map`), and returns a `Measured`.
"""

import numpy as np

from granular_fronts.measured import Measured

FEW_DIGITS = 1.0e-14
"""Relative error of critical damping, a few units of the last digit."""


def force_overshoot(front):
    """Largest elastic force over the force behind the front, (max u/δ)^α."""
    alpha, overshoot = front.attrs["alpha"], front.attrs["overshoot"]
    force = (1.0 + overshoot) ** alpha
    return Measured(force, alpha * force * front.attrs["error_estimate"])


def displacement_overshoot(front):
    """Largest u/δ − 1, 0 for a monotone front."""
    return Measured(front.attrs["overshoot"], front.attrs["error_estimate"])


def dissipated_power(front):
    """Power that all contacts dissipate, in units of the front."""
    return Measured(front.attrs["dissipated_power"], front.attrs["dissipated_power_error"])


def velocity_overshoot(front):
    """Largest ẋ/v_p − 1 on the window of the scene; the vertex of a parabola through the top."""
    velocity = front["velocity"].values
    top = int(np.argmax(velocity))
    left, middle, right = velocity[top - 1 : top + 2]
    rise = 0.125 * (left - right) ** 2 / (2.0 * middle - left - right)
    return Measured(float(middle + rise - 1.0), float(rise) + front["velocity"].error_estimate)


def distance(front, field, limit):
    """Largest difference of a continuum front to the exact one, over the jump of the field.

    Parameters
    ----------
    front : xarray.Dataset
    field : {"relative_displacement", "velocity"}
    limit : {"logarithmic", "unlimited", "heteroclinic"}
        (45) with (48), (46) with (44), or the front of section 5.
    """
    value = front[f"{field}_{limit}"]
    errors = value.attrs["error_estimate"] + front[field].attrs["error_estimate"]
    return Measured(float(value.attrs["distance"]), float(errors))


def tail_over_long_wave(curves, alpha):
    """Critical damping of the lattice, by its tail, over that of section 5, μ = 2."""
    one = curves.sel(alpha=alpha)
    ratio = float(one["critical_damping_tail"] / one["critical_damping_long_wave"])
    return Measured(ratio, FEW_DIGITS * ratio)


def critical_damping(curves, alpha):
    """Critical damping of the lattice by its tail, γc."""
    value = float(curves["critical_damping_tail"].sel(alpha=alpha))
    return Measured(value, FEW_DIGITS * value)
