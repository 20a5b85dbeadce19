"""What the paper says of fronts in numbers, measured on the exact front of a scene."""

from granular_fronts.measured import Measured


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
