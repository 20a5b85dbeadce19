r"""Scales between the chain and its amplitude equations (James 2021, section 4).

The relative displacements and velocities of a chain with :math:`\beta = \alpha` follow from the
rescaled force :math:`y(\xi, \tau)` by (37),

.. math::

    u_n(t) = \delta\, y^{1/\alpha}, \quad \xi = \varepsilon(n - ct), \quad
    \tau = \tfrac12\gamma\varepsilon^2c^2 t, \quad c = \delta^{(\alpha-1)/2}, \quad
    \varepsilon = \frac{\alpha - 1}{\alpha\gamma c}.

In the frame :math:`\tilde\xi = \xi - \tau = \varepsilon(n - \tilde ct)` of (51) the speed is
:math:`\tilde c = \delta^{(\alpha-1)/2} + \tfrac12\varepsilon\gamma\,\delta^{\alpha-1}`.

Velocities.  To leading order :math:`\delta^{(\alpha+1)/2} y` (51).  To first order, from
:math:`\dot u_n = \dot x_n - \dot x_{n+1}` with (41) in :math:`\partial_\tau u`, up to a constant,

.. math:: \dot x = \delta^{(\alpha+1)/2}\Bigl(y - \tfrac12\varepsilon\bigl[\partial_\xi y
    + \gamma c\,(\partial_\xi y + y\ln y)\bigr]\Bigr) + O(\varepsilon^2).

The paper prints :math:`y - \varepsilon(\gamma c + \tfrac12)\,\partial_\xi y` (43), for which
:math:`d/dt` in (42) is :math:`-c\varepsilon\,\partial_\xi`, without
:math:`\tfrac12\gamma\varepsilon^2c^2\,\partial_\tau`.  That part is of the same order, so that (43)
holds only where :math:`y\ln y = \partial_\xi y`, for stationary waves.  For a front it becomes
:math:`\delta^{(\alpha+1)/2}\bigl(u - (u^\alpha - u)/(2\gamma c)\bigr)`, (44) and (48), with
:math:`u = y^{1/\alpha}`.
"""

from typing import NamedTuple

from granular_fronts.arguments import scalar

# Smallest μ > 0: below it the energy of the orbit, which is of order μ, loses digits.
SMALLEST_DAMPING = 1.0e-280


class SlowScales(NamedTuple):
    """Scales for α above 1, γ above 0 and the reference relative displacement δ above 0."""

    alpha: float
    gamma: float
    delta: float

    @property
    def speed(self):
        """Speed c = δ^((α − 1)/2)."""
        return self.delta ** ((self.alpha - 1.0) / 2.0)

    @property
    def epsilon(self):
        """Small parameter ε = (α − 1)/(αγc), the chain's step in ξ."""
        return (self.alpha - 1.0) / (self.alpha * self.gamma * self.speed)

    @property
    def ratio(self):
        """ε/γc, which section 4.1 requires to be small."""
        return self.epsilon / (self.gamma * self.speed)

    @property
    def frame_speed(self):
        """Speed c̃ of (51), the speed at which ξ̃ = ξ − τ runs along the chain."""
        return self.speed + 0.5 * self.epsilon * self.gamma * self.speed**2

    @property
    def slow_rate(self):
        """Ratio τ/t of (51)."""
        return 0.5 * self.gamma * (self.epsilon * self.speed) ** 2

    @property
    def dispersion(self):
        """Dispersion μ⁻² in ξ and τ, μ = 2√3 γc (1 − 1/α)^(−1/2) of (54); see section 5."""
        return (self.alpha - 1.0) / self.alpha / (12.0 * (self.gamma * self.speed) ** 2)

    @property
    def velocity_scale(self):
        """Velocity δ^((α + 1)/2) at which y is 1."""
        return self.delta * self.speed

    def half_length(self, half_beads):
        """Return half of the ring, ℓ = (p − 1/2) ε of a ring of 2p − 1 beads."""
        return (half_beads - 0.5) * self.epsilon

    def displacement(self, y):
        """Return the relative displacement u_n of (51)."""
        return self.delta * y ** (1.0 / self.alpha)

    def velocity(self, y):
        """Return the velocity ẋ_n of (51), to leading order."""
        return self.velocity_scale * y

    def corrected_velocity(self, y, slope, flux):
        """Return ẋ_n to first order, up to a constant, from y, ∂y/∂ξ and the flux y ln y of (41).

        With `flux` equal to `slope`, as in a stationary wave, this is (43).
        """
        damped = self.gamma * self.speed * (slope + flux)
        return self.velocity_scale * (y - 0.5 * self.epsilon * (slope + damped))

    def front_velocity(self, u):
        """Return the velocity ẋ_n of a stationary front, (44) and (48), from u = y^(1/α)."""
        correction = (u**self.alpha - u) / (2.0 * self.gamma * self.speed)
        return self.velocity_scale * (u - correction)


def make_slow_scales(alpha, gamma, delta):
    """Return the scales of section 4; an InputError unless α > 1, γ > 0 and δ > 0."""
    reason = "a front runs into an uncompressed chain for such an alpha only"
    alpha = scalar("alpha", alpha, above=1.0, advice=reason)
    reason = "without damping the scale epsilon of section 4 is infinite"
    gamma = scalar("gamma", gamma, above=0.0, advice=reason)
    return SlowScales(alpha, gamma, scalar("delta", delta, above=0.0, advice="give a compression"))


def gamma_for(alpha, delta, *, damping=None, epsilon=None, ratio=None, mu=None):
    r"""Return the strength γ of the viscous force that gives one of γc, ε, ε/γc and μ, for α and δ.

    Since :math:`\varepsilon\gamma c = \kappa = 1 - 1/\alpha` and
    :math:`\mu = 2\sqrt3\,\gamma c\,\kappa^{-1/2}` (55), each of them fixes γc:

    .. math:: \gamma c = \frac{\kappa}{\varepsilon}
        = \Bigl(\frac{\kappa}{\varepsilon/\gamma c}\Bigr)^{1/2}
        = \frac{\mu\,\kappa^{1/2}}{2\sqrt3} .

    The last two are one: :math:`\varepsilon/\gamma c = 12/\mu^2`.
    """
    kappa = (alpha - 1.0) / alpha
    if epsilon is not None:
        damping = kappa / epsilon
    elif ratio is not None:
        damping = (kappa / ratio) ** 0.5
    elif mu is not None:
        damping = mu * (kappa / 12.0) ** 0.5
    return damping / delta ** ((alpha - 1.0) / 2.0)
