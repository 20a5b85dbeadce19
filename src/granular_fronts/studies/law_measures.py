"""Numbers measured on contact laws, for comparison with the paper.

A measure takes the dataset that a module of this folder makes and returns a `Measured`.
"""

import math

import numpy as np
from scipy.stats import linregress

from granular_fronts.accuracy import Measured
from granular_fronts.model.collision import weak_damping_slope
from granular_fronts.model.jump_conditions import jump_conditions
from granular_fronts.model.potentials import make_potential
from granular_fronts.output.datasets import configuration_of
from granular_fronts.studies.materials import ALPHA


def weak_damping_constant(_dataset):
    """γ/(1 − e) in the limit e → 1, a closed formula."""
    value = weak_damping_slope(ALPHA)
    return Measured(value, 4.0 * float(np.spacing(value)))


def gamma(dataset, material):
    """γ of the exact collision with the coefficient of restitution of a material."""
    found = dataset["gamma"]
    return Measured(float(found.sel(material=material)), float(found.attrs["error_estimate"]))


def velocity_power(dataset, beta):
    """Power of the velocity in γ by (29), from the smallest to the largest velocity."""
    law = dataset["gamma"].sel(beta=beta)
    ends = law.isel(velocity_ratio=[0, -1])
    span = math.log(float(ends["velocity_ratio"][1] / ends["velocity_ratio"][0]))
    power = math.log(float(ends[1] / ends[0])) / span
    return Measured(power, 8.0 * float(np.finfo(float).eps))


def restitution_gain(dataset, beta):
    """Restitution e at the smallest velocity less that at the largest.

    Above 0 if damping is weak at small velocities, below 0 if it is weak at large ones.
    """
    slowest, fastest = dataset["restitution"].sel(beta=beta).isel(velocity_ratio=[0, -1]).values
    error = 2.0 * dataset["restitution"].attrs["error_estimate"]
    return Measured(float(slowest - fastest), error)


def order_of_agreement(dataset):
    """Smallest observed order of the distance between the θ-method and the damped chain."""
    order = dataset["order"]
    return Measured(float(order.min()), float(order.attrs["error_estimate"]))


def order_of_two_stages(dataset):
    """The same for the explicit scheme of two stages."""
    order = dataset["order_two_stages"]
    return Measured(float(order.min()), float(order.attrs["error_estimate"]))


def quotient_power(dataset, variables, beta):
    """Power of h in the difference quotient of the right-hand side where a contact closes."""
    return _with_its_error(dataset.sel(variables=variables, beta=beta), "quotient_power")


def observed_order(dataset, variables, scheme):
    """Order with which a scheme with fixed steps passes a collision."""
    return _with_its_error(dataset.sel(variables=variables, scheme=scheme), "observed_order")


def order_gain(dataset, scheme):
    """Order of a scheme in (x, w) less that in (x, ẋ)."""
    good, bad = (
        observed_order(dataset, variables, scheme)
        for variables in ("positions_and_w", "positions_and_velocities")
    )
    return Measured(good.value - bad.value, good.error + bad.error)


def _with_its_error(dataset, name):
    return Measured(float(dataset[name]), float(dataset[f"{name}_error"]))


def conserved_velocity_drift(dataset):
    """Largest distance of w_n to v_p far behind a front, at all times."""
    drift = dataset["conserved_velocity_drift"]
    return Measured(float(drift), float(drift.attrs["error_estimate"]))


def persistence(dataset, gamma):
    """Range of u behind a wave at the end over that at a quarter of the time."""
    return _late_over_early(dataset.sel(gamma=gamma), "oscillation")


def spreading(dataset, alpha):
    """Width of a wave at the end over that at a quarter of the time."""
    return _late_over_early(dataset.sel(alpha=alpha), "width")


def _late_over_early(dataset, name):
    early, late = (_with_its_error(dataset.isel(t=row), name) for row in (0, -1))
    ratio = late.value / early.value
    return Measured(ratio, (late.error + ratio * early.error) / early.value)


def approach_power(dataset):
    """Power of α − 1 in the distance of rings to the logarithmic Burgers equation.

    The error is twice the standard error of the slope.
    """
    distance = dataset["ring_distance"]
    line = linregress(np.log(distance["exponent"].values - 1.0), np.log(distance.values))
    return Measured(float(line.slope), 2.0 * float(line.stderr))


def softening_speed(dataset):
    """Speed (14) of the front of a softening force into the smallest compression ahead."""
    speeds = dataset["softening_speed"]
    smallest = speeds.sortby("strain_ahead")[0]
    return Measured(float(smallest), float(speeds.attrs["error_estimate"]))


def contact_time_power(dataset):
    """Power of the velocity in the time of contact of two beads."""
    return _power_of(dataset["contact_time"])


def indentation_power(dataset):
    """Power of the velocity in the largest compression of two beads."""
    return _power_of(dataset["indentation"])


def _power_of(values):
    """Slope of ln value over ln velocity, from the smallest to the largest velocity."""
    velocity, value = values["impact_velocity"].values[[0, -1]], values.values[[0, -1]]
    span = math.log(velocity[1] / velocity[0])
    errors = float(values.attrs["error_estimate"]) / value
    return Measured(math.log(value[1] / value[0]) / span, float(errors.sum()) / span)


def front_speed(dataset, law, ramp):
    """Front speed ahead of a piston over that of (23)."""
    return _over_expected(dataset, "front_speed", law, ramp)


def compression_behind(dataset, law, ramp):
    """Compression behind the front of a piston over that of (22)."""
    return _over_expected(dataset, "compression_behind", law, ramp)


def velocity_behind(dataset, law, ramp):
    """v_p far from a piston over the velocity of the piston."""
    return _over_expected(dataset, "velocity_behind", law, ramp)


def _over_expected(dataset, name, law, ramp):
    case = dataset.sel(law=law, ramp=ramp)
    expected = float(case[f"{name}_expected"])
    return Measured(float(case[name]) / expected, float(case[f"{name}_error"]) / expected)


def signed_speed(dataset, law):
    """Speed of the exact front of a law over |c| of (14), negative if it runs to smaller n."""
    case = dataset.sel(law=law)
    expected = abs(float(case["speed_expected"]))
    errors = (case[name].attrs["error_estimate"] for name in ("speed_exact", "speed_expected"))
    return Measured(float(case["speed_exact"]) / expected, sum(errors) / expected)


def worst_agreement(dataset, quantity):
    """Largest distance to theory of all laws and ways of measuring, over the sum of their errors.

    At most 1 where every measurement agrees with the jump conditions.
    """
    expected, expected_error = (
        dataset[f"{quantity}_expected"],
        dataset[f"{quantity}_expected_error"],
    )
    ratios = [
        abs(dataset[name] - expected) / (dataset[f"{name}_error"] + expected_error)
        for name in (f"{quantity}_{way}" for way in ("exact", "travelling", "driven"))
        if name in dataset
    ]
    largest = max(float(ratio.max()) for ratio in ratios)
    return Measured(largest, 4.0 * float(np.spacing(largest)))


def sonic_margin(dataset):
    """Smallest distance of driven fronts to both sound velocities, over their difference.

    Of all laws; above 0 if every front is slower than sound behind it and faster than sound ahead.
    """
    cases = configuration_of(dataset)["cases"]
    margins = [_sonic_margin(dataset.sel(law=law), case) for law, case in cases.items()]
    return min(margins)


def _sonic_margin(front, case):
    theory = jump_conditions(make_potential(**case["elastic"]), *map(float, case["states"]))
    speed, error = abs(float(front["speed_driven"])), float(front["speed_driven_error"])
    sounds = (theory.sound_minus, theory.sound_plus)
    behind, ahead = sounds if float(front["direction"]) > 0.0 else reversed(sounds)
    difference = abs(behind - ahead)
    return Measured(min(behind - speed, speed - ahead) / difference, error / difference)


def speed_spread(dataset, laws):
    """Largest less smallest speed of travelling fronts of several laws."""
    fronts = dataset.sel(law=laws)
    speeds = fronts["speed_travelling"]
    error = 2.0 * float(fronts["speed_travelling_error"].max())
    return Measured(float(speeds.max() - speeds.min()), error)
