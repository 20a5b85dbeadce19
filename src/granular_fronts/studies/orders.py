"""Orders of convergence, read off the errors at several steps."""

import numpy as np

ORDER_METHOD = "change from the last pair of steps but one to the last"


def observed_orders(errors, steps):
    """Return the orders between neighbouring steps, along the last axis of the errors."""
    return np.log(errors[..., :-1] / errors[..., 1:]) / np.log(np.divide(steps[:-1], steps[1:]))


def power_of(x, y):
    """Return the power of x in y: slope of the line through the logarithms."""
    return float(np.polyfit(np.log(x), np.log(y), 1)[0])
