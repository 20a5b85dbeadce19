r"""The three continuum fronts of the paper, in the frame of the exact front.

With δ = c = 1 a front of the chain with :math:`\beta = \alpha` depends only on α and γ, and falls
from 1 to 0 as a function of :math:`\xi = n - t`.  The amplitude equations approximate it by

- (45), (47): :math:`u = 2^{-e^{\varepsilon\xi}}`, the logarithmic Burgers equation, with
  :math:`\varepsilon = (\alpha-1)/(\alpha\gamma)`;
- (46): :math:`u = \bigl[1 - (1 - 2^{1-\alpha})\,e^{\varepsilon\xi}\bigr]_+^{1/(\alpha-1)}`, the
  same limit before :math:`\alpha \to 1^+`;
- section 5: :math:`u = y_h(s)^{1/\alpha}`, the heteroclinic orbit of the logarithmic KdV–Burgers
  equation, with :math:`s = 2\sqrt3\,\kappa\,\xi`, :math:`\kappa = (1 - 1/\alpha)^{1/2}` and
  :math:`\mu = 2\sqrt3\,\gamma/\kappa`.

All have the phase u(0) = 1/2.  Velocities follow the paper: (44) and (48) for the first two, and
for the third :math:`\dot x \approx y - (\gamma + \tfrac12)\,\partial_\xi y`, which is (43).
"""

import math

import numpy as np

from granular_fronts.continuum.log_burgers.equation import log_burgers_front
from granular_fronts.continuum.log_kdv_burgers.equation import amplitude_of_chain
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import UNDERFLOW_P, compute_orbit
from granular_fronts.model.amplitude_scaling import make_slow_scales

LOGARITHMIC, UNLIMITED, HETEROCLINIC = "logarithmic", "unlimited", "heteroclinic"


def continuum_fronts(alpha, gamma, xi):
    """Return relative displacement and velocity of each continuum front, ξ = n − t, δ = c = 1.

    A pair for each of `LOGARITHMIC`, `UNLIMITED` and `HETEROCLINIC`; an InputError unless α > 1
    and γ > 0.
    """
    scales = make_slow_scales(alpha, gamma, 1.0)
    logarithmic = log_burgers_front(scales.epsilon * xi)
    unlimited = log_burgers_front(scales.epsilon * xi, alpha) ** (1.0 / alpha)
    return {
        LOGARITHMIC: (logarithmic, scales.front_velocity(logarithmic)),
        UNLIMITED: (unlimited, scales.front_velocity(unlimited)),
        HETEROCLINIC: _heteroclinic_front(alpha, gamma, xi),
    }


def _heteroclinic_front(alpha, gamma, xi):
    """Return the relative displacement and velocity of the heteroclinic front, with u(0) = 1/2."""
    amplitude = amplitude_of_chain(alpha, gamma)
    mu, stretch = amplitude.mu, amplitude.s_per_bead
    # The phase lies ahead of s = 0, so that only the orbit's tail fixes it.
    start = compute_orbit(mu, 0.0).s_at(alpha * math.log(2.0))
    s = start + stretch * xi
    orbit = compute_orbit(mu, min(float(s.min()), 0.0))
    last = orbit.s_at(UNDERFLOW_P)
    p, v = orbit.evaluate(np.minimum(s, last))
    y = np.where(s < last, np.exp(-p), 0.0)
    return y ** (1.0 / alpha), y + (gamma + 0.5) * stretch * v * y
