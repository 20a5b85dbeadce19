"""Numbers measured on contact laws, for comparison with the paper.

A measure takes the dataset that a module of this folder makes and returns an `Estimate`.
"""

import math

import numpy as np
from scipy.stats import linregress

from granular_fronts.accuracy import EPSILON, Estimate, recorded, rounded, tabulated
from granular_fronts.model.collision import damping_for_restitution, weak_damping_slope
from granular_fronts.model.jump_conditions import jump_conditions
from granular_fronts.model.potentials import make_potential
from granular_fronts.output.datasets import configuration_of
from granular_fronts.studies.materials import ALPHA


def weak_damping_constant(_dataset):
    """Return γ/(1 − e) in the limit e → 1, a closed formula."""
    return rounded(weak_damping_slope(ALPHA), units=4.0)


def gamma(dataset, material):
    """Return γ of the exact collision with the coefficient of restitution of a material."""
    return recorded(dataset["gamma"].sel(material=material))


def gamma_of_restitution(dataset, restitution):
    """Return γ of the exact collision of spheres, β = α = 3/2, with a published restitution e."""
    return rounded(damping_for_restitution(restitution), units=8.0)


def velocity_power(dataset, beta):
    """Return the power of the velocity in γ by (29), from the smallest to the largest velocity."""
    law = dataset["gamma"].sel(beta=beta)
    first, last = (law.isel(velocity_ratio=place) for place in (0, -1))
    span = math.log(float(last["velocity_ratio"] / first["velocity_ratio"]))
    return Estimate(math.log(float(last / first)) / span, 8.0 * EPSILON)


def restitution_gain(dataset, beta):
    """Return the restitution e at the smallest velocity less that at the largest.

    Above 0 if damping is weak at small velocities, below 0 if it is weak at large ones.
    """
    restitution = dataset["restitution"].sel(beta=beta)
    return recorded(restitution[0]) - recorded(restitution[-1])


def order_of_agreement(dataset):
    """Return smallest observed order of the distance between the θ-method and the damped chain."""
    return recorded(dataset["order"].min(keep_attrs=True))


def order_of_two_stages(dataset):
    """Return the same for the explicit scheme of two stages."""
    return recorded(dataset["order_two_stages"].min(keep_attrs=True))


def quotient_power(dataset, form, beta):
    """Return the power of h in the difference quotient of the rates where a contact closes."""
    return tabulated(dataset.sel(form=form, beta=beta), "quotient_power")


def observed_order(dataset, form, scheme):
    """Return the order with which a scheme with fixed steps passes a collision."""
    return tabulated(dataset.sel(form=form, scheme=scheme), "observed_order")


def order_gain(dataset, scheme):
    """Return the order of a scheme in (x, w) less that in (x, ẋ)."""
    good = observed_order(dataset, "positions_and_w", scheme)
    return good - observed_order(dataset, "positions_and_velocities", scheme)


def conserved_velocity_drift(dataset):
    """Return the largest distance of w_n to v_p far behind a front, at all times."""
    return recorded(dataset["conserved_velocity_drift"])


def persistence(dataset, gamma):
    """Return the range of u behind a wave at the end over that at a quarter of the time."""
    return _late_over_early(dataset.sel(gamma=gamma), "oscillation")


def spreading(dataset, alpha):
    """Return the width of a wave at the end over that at a quarter of the time."""
    return _late_over_early(dataset.sel(alpha=alpha), "width")


def _late_over_early(dataset, name):
    early, late = (tabulated(dataset.isel(t=row), name) for row in (0, -1))
    return late / early


def approach_power(dataset):
    """Return the power of α − 1 in the distance of rings to the logarithmic Burgers equation.

    The error is twice the standard error of the slope.
    """
    distance = dataset["ring_distance"]
    line = linregress(np.log(distance["exponent"].values - 1.0), np.log(distance.values))
    return Estimate(float(line.slope), 2.0 * float(line.stderr))


def softening_speed(dataset):
    """Return speed (14) of the front of a softening force into the smallest compression ahead."""
    return recorded(dataset["softening_speed"].sortby("strain_ahead")[0])


def contact_time_power(dataset):
    """Return the power of the velocity in the time of contact of two beads."""
    return _power_of(dataset["contact_time"])


def indentation_power(dataset):
    """Return the power of the velocity in the largest compression of two beads."""
    return _power_of(dataset["indentation"])


def _power_of(values):
    """Return the slope of ln value over ln velocity, from the smallest to the largest velocity."""
    velocity, value = values["impact_velocity"].values[[0, -1]], values.values[[0, -1]]
    span = math.log(velocity[1] / velocity[0])
    errors = float(values.attrs["error_estimate"]) / value
    return Estimate(math.log(value[1] / value[0]) / span, float(errors.sum()) / span)


def signed_speed(dataset, law):
    """Return the speed of a law's exact front over |c| of (14), negative towards smaller n."""
    case = dataset.sel(law=law)
    expected = abs(float(case["speed_expected"]))
    errors = (case[name].attrs["error_estimate"] for name in ("speed_exact", "speed_expected"))
    return Estimate(float(case["speed_exact"]) / expected, sum(errors) / expected)


def worst_agreement(dataset, quantity):
    """Return the largest distance to theory over the sum of errors, of all laws and ways.

    At most 1 where every measurement agrees with the jump conditions.
    """
    expected, error = (dataset[f"{quantity}_{what}"] for what in ("expected", "expected_error"))
    ways = (f"{quantity}_{way}" for way in ("exact", "travelling", "driven"))
    ratios = [
        abs(dataset[name] - expected) / (dataset[f"{name}_error"] + error)
        for name in ways
        if name in dataset
    ]
    return rounded(max(float(ratio.max()) for ratio in ratios), units=4.0)


def largest_relative_distance(dataset, quantity, way):
    """Return the largest relative distance of a quantity to theory, of all laws in one `way`."""
    expected = dataset[f"{quantity}_expected"]
    distance = abs(dataset[f"{quantity}_{way}"] / expected - 1.0)
    errors = dataset[f"{quantity}_{way}_error"] / abs(expected)
    return Estimate(float(distance.max()), float(errors.max()))


def sonic_margin(dataset):
    """Return smallest distance of driven fronts to both sound velocities, over their difference.

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
    return Estimate(min(behind - speed, speed - ahead) / difference, error / difference)


def speed_spread(dataset, laws):
    """Return the largest less smallest speed of travelling fronts of several laws."""
    fronts = dataset.sel(law=laws)
    speeds = fronts["speed_travelling"]
    error = 2.0 * float(fronts["speed_travelling_error"].max())
    return Estimate(float(speeds.max() - speeds.min()), error)
