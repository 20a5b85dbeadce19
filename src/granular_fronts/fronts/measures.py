"""What the paper says of fronts in numbers, measured on exact fronts.

A measure takes a dataset and returns an `Estimate`.  The dataset is a front scene (see
`comparison`), the curves of critical damping (see `damping_map`) or families of fronts (see
`trends`).
"""

import numpy as np

from granular_fronts.accuracy import Estimate, estimate, recorded, sampled_maximum

FEW_DIGITS = 1.0e-14  # relative error of critical damping, a few units of the last digit


def force_overshoot(front):
    """Return the largest elastic force over the force behind the front, (max u/δ)^α."""
    alpha, overshoot = front.attrs["alpha"], front.attrs["overshoot"]
    force = (1.0 + overshoot) ** alpha
    return Estimate(force, alpha * force * front.attrs["error_estimate"])


def displacement_overshoot(front):
    """Return the largest u/δ − 1, 0 for a monotone front."""
    return Estimate(front.attrs["overshoot"], front.attrs["error_estimate"])


def dissipated_power(front):
    """Return the power that all contacts dissipate, in units of the front."""
    return Estimate(front.attrs["dissipated_power"], front.attrs["dissipated_power_error"])


def velocity_overshoot(front):
    """Return the largest ẋ/v_p − 1 on the window of the scene, the vertex of a parabola."""
    velocity = front["velocity"]
    return sampled_maximum(velocity.values) + Estimate(-1.0, velocity.error_estimate)


def smallest_velocity_behind(front):
    """Return the smallest ẋ/v_p behind the middle of the front, the vertex of a parabola."""
    velocity = front["velocity"].where(front["xi"] < 0.0, drop=True)
    return -sampled_maximum(-velocity.values) + Estimate(0.0, velocity.error_estimate)


def distance(front, field, limit):
    """Return largest difference of a continuum front to the exact one, over the jump of the field.

    The limit is logarithmic, (45) with (48), unlimited, (46) with (44), or heteroclinic, section 5.
    """
    value = front[f"{field}_{limit}"]
    errors = value.attrs["error_estimate"] + front[field].attrs["error_estimate"]
    return Estimate(value.attrs["distance"], value.attrs["distance_error"] + errors)


def tail_over_long_wave(curves, alpha):
    """Return the critical damping of the lattice, by its tail, over the one of section 5, μ = 2."""
    one = curves.sel(alpha=alpha)
    ratio = float(one["critical_damping_tail"] / one["critical_damping_long_wave"])
    return Estimate(ratio, FEW_DIGITS * ratio)


def critical_damping(curves, alpha):
    """Return the critical damping of the lattice by its tail, γc."""
    value = float(curves["critical_damping_tail"].sel(alpha=alpha))
    return Estimate(value, FEW_DIGITS * value)


def tail_contrast(trends, beta):
    """Return Im λ of the slowest tail at the smallest velocity v_p less that at the largest.

    Above 0 if a front oscillates at small velocities, below 0 if it does at large ones.
    """
    frequency = trends["tail_frequency"].sel(beta=beta).sortby("piston_velocity")
    return recorded(frequency[0]) - recorded(frequency[-1])


def critical_power_of_pressure(trends):
    """Return the power of δ in the γ at which the tail ceases to oscillate."""
    gamma = trends["critical_gamma"]
    span = np.log(gamma["displacement"].values[-1] / gamma["displacement"].values[0])
    power = float(np.log(gamma.values[-1] / gamma.values[0]) / span)
    return Estimate(power, 2.0 * gamma.attrs["error_estimate"] / float(gamma.min() * span))


def width_power(trends):
    """Return the power of 1 − 1/α in the width of fronts at fixed μ, from the two α closest to 1.

    The error is the change from the next pair.
    """
    closest = trends["width_of_exponent"].sortby("exponent")[:3]
    return estimate(*_powers(1.0 - 1.0 / closest["exponent"].values, closest.values))


def narrowing(trends):
    """Return the width of the front at the smallest δ over that at the largest, γ and α fixed."""
    width = trends["width_of_displacement"].sortby("displacement")
    return recorded(width[0]) / recorded(width[-1])


def gaussian_distance(trends, exponent):
    """Return largest distance of u of a solitary wave to the Gaussian, both over their peaks."""
    return recorded(trends["gaussian_distance"].sel(exponent=exponent))


def solitary_force(trends, exponent):
    """Return the largest force u^α of a solitary wave over e^(1/2), the value of the Gaussian."""
    peak = trends["solitary_peak"].sel(exponent=exponent)
    force = float(peak) ** exponent / np.exp(0.5)
    return Estimate(float(force), exponent * float(force) * peak.attrs["error_estimate"])


def second_peak_seen_from(plane):
    """Return the exponent at which both maxima are equal and just high enough to be seen."""
    peaks = plane["equal_peaks"].where(plane["equal_peaks"] > 0.0).dropna("alpha")

    def crossing(stride):
        steps = peaks[::stride]
        return np.interp(plane.attrs["overshoot_cut"], steps, steps["alpha"])

    return estimate(crossing(1), crossing(2))


def exchange_exponent(curves):
    """Return α*, up to which critical damping is a double root of the tail."""
    value = curves.attrs["exchange_exponent"]
    return Estimate(value, FEW_DIGITS * value)


def methods_apart(*fronts):
    """Return the largest distance in u/δ of the fronts by the profile equation and by shooting."""
    apart = [front["relative_displacement_shooting"].attrs["distance"] for front in fronts]
    errors = [front["relative_displacement"].attrs["error_estimate"] for front in fronts]
    return Estimate(float(max(apart)), float(max(errors)))


def strong_damping_power(survey, alpha):
    """Return the power of γ in the largest error of (46), between the two largest γ.

    The error is the change from the pair before.
    """
    distance = survey["distance_unlimited"].sel(alpha=alpha)[-3:]
    before, last = _powers(distance["gamma"].values, distance.values)
    return estimate(last, before)


def _powers(x, y):
    return np.diff(np.log(y)) / np.diff(np.log(x))
