r"""Measure a front: velocity, peaks, width, slope, dissipated power.

Velocity.  In the notation of `profile.equation`

.. math::

    \dot x(\xi) = -cR_a - c\,(R_b - R_a)
        \Bigl[\int_{\xi-1}^{\xi} p(s)\,d\xi' - q(s(\xi)) + q(s(\xi - 1))\Bigr] ,

without a derivative of s.  Without the terms of q it is the generalised velocity w of James (2021),
eq. (31).

Dissipated power.  All contacts together dissipate :math:`\int W''(R)\,(cR')^2 d\xi`, in normalised
variables :math:`c^3 (R_b - R_a)^2 \int q'(s)\, s'^2 d\xi`.  The balance (6) across the front fixes
it, eq. (16), whatever W; for a Hertz chain at rest ahead it is (α − 1)/(2(α + 1)).  The integral is
a sum over the grid.  For a smooth function that is constant at both ends its error is smaller than
any power of h.

Errors.  A number is as wrong as what it is read from.  Let s err by up to η.  Then its largest
value errs by η, and the place of a level by η/|s'|.  A slope errs by η/4h, since a part of η is
rounding, which differs from point to point.  The dissipated power errs, by parts, by about
:math:`c^3 (R_b - R_a)^2 \eta` times the total variation of :math:`q's'`.  No error is below this,
and none below the change of the number in the refined front.
"""

import numpy as np

from granular_fronts.accuracy import EPSILON
from granular_fronts.fronts.profile.equation import evaluate_slopes
from granular_fronts.fronts.profile.newton import fill_forces, make_forces
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.interpolation import (
    derivative,
    find_level,
    interpolate_all,
    largest,
    last_crests,
)
from granular_fronts.numerics.quadrature import kernel_weights


def velocity(profile, order):
    """Return the velocity ẋ at the points of a profile, shape (points,)."""
    problem, site = profile.problem, kernel_weights(profile.spacing, order).site
    width = site.size // 2
    forces = make_forces(profile.s.size, width)
    fill_forces(problem, profile.s, forces)
    q = forces.q[width:-width]
    back = (profile.xi - 1.0) / float(profile.spacing)
    before = interpolate_all(q, back, problem.damping_number, 0.0, profile.middle)
    share = np.correlate(forces.p, site, "valid") - q + before
    return problem.speed * (problem.start + problem.jump * share)


def measure(profile):
    """Return `MEASURES` of a profile and their sensitivity to an error of s; shape (5,) each."""
    return np.split(measures(profile.problem, float(profile.spacing), profile.s), 2)


def with_overshoot(measured):
    """Return numbers by name with the overshoot, which is the largest peak, and its error."""
    names = {"overshoot": "largest_peak", "overshoot_error": "largest_peak_error"}
    return measured | {name: measured[of] for name, of in names.items() if of in measured}


def errors_of_measures(values, others, sensitivities, error):
    """Return the errors of measures, of which a refined front has others, from the error of s."""
    return np.max(
        [np.abs(values - others), sensitivities * error, EPSILON * np.abs(values)], axis=0
    )


MEASURES = ("first_peak", "largest_peak", "width_10_90", "slope", "dissipated_power")
"""The first maximum of the strain behind the front, and the largest, less the state behind; both
are 0 for a monotone front.  Near critical damping the first may be below that state, and a later
one above it.  The sites between 90 % and 10 % of the way to the state behind, where the strain
passes them last.  The steepest slope on the way from behind.  The dissipated power.
"""


@kernel
def measures(problem, spacing, s):
    """Return the numbers named in `MEASURES`, and after them their sensitivities."""
    jump = abs(problem.jump)
    (rise, before), (fall, after) = find_level(s, 0.9, 1.0, 0.0), find_level(s, 0.1, 1.0, 0.0)
    slopes = derivative(s, 1.0, 0.0) / spacing
    stiffness, viscosity = np.empty(s.size), np.empty(s.size)
    evaluate_slopes(problem, s, stiffness, viscosity)
    flux = viscosity * slopes
    rate = problem.speed**3 * jump**2
    return np.array(
        [
            jump * (last_crests(s, rise, 1, 1.0, 0.0)[0] - 1.0),
            jump * max(largest(s, 1.0, 0.0) - 1.0, 0.0),
            spacing * (fall - rise + (after - before)),
            jump * largest(-slopes, 0.0, 0.0),
            rate * spacing * np.sum(viscosity * slopes**2),
            jump,
            jump,
            1.0 / min(abs(slopes[rise]), abs(slopes[fall])),
            0.25 * jump / spacing,
            rate * np.sum(np.abs(flux[1:] - flux[:-1])),
        ]
    )
