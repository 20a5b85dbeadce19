r"""Convert between a chain of real beads and the dimensionless chain; James (2021), section 3.1.

The chain (24) of beads of mass m, with the contact law
:math:`F = k\,(u_+^\alpha + \gamma_0\,\tfrac{d}{dt}u_+^\beta)`, becomes (28), with m = k = 1 and
:math:`\gamma` for :math:`\gamma_0`, when velocities are measured in a reference velocity
:math:`v_0` and

.. math::

    T_0 = \Bigl(\frac mk\Bigr)^{\frac1{\alpha+1}} v_0^{\frac{1-\alpha}{1+\alpha}}, \quad
    \delta_0 = v_0T_0, \quad F_0 = k\,\delta_0^\alpha = \frac{m v_0}{T_0}, \quad
    \gamma = \gamma_0\, v_0^{\frac{2\beta}{\alpha+1}-1}
             \Bigl(\frac km\Bigr)^{1-\frac{\beta}{\alpha+1}},

(27) and (29).  Quantities are plain numbers in SI units: metres, seconds, kilograms, newtons;
:math:`k` in N m⁻ᵅ and :math:`\gamma_0` in s m^(α−β), hence in seconds for β = α.

Which velocity.  For two beads that collide it is their relative velocity (see `model.collision`).
For a front it is the velocity :math:`v_p` of the compressed beads.  Then (22) makes
:math:`\delta_0` their compression, the front has δ = c = v_p = 1, and (30) says :math:`\gamma =
\gamma_0 c` for β = α.  A chain held at the compression δ, or by the force :math:`k\delta^\alpha`,
has :math:`\delta_0 = \delta` (Remark 5).

Weak damping.  :math:`v_c` is the velocity at which γ = 1.  For β above (α + 1)/2 the damping is
weak well below it, for smaller β well above, and at β = (α + 1)/2 no velocity changes γ.

Spheres.  Two equal spheres of radius R, Young's modulus E and Poisson's ratio ν press on each other
with :math:`k u^{3/2}`, :math:`k = E\sqrt{2R}/(3(1-\nu^2))` (Hertz); of unlike bodies see
`materials`.
"""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar

from granular_fronts.arguments import choice, double_precision, scalar
from granular_fronts.errors import InputError
from granular_fronts.model.collision import damping_for_restitution
from granular_fronts.model.materials import contact_stiffness, named_body

if TYPE_CHECKING:
    import numpy as np

Value = TypeVar("Value", float, "np.ndarray")


@dataclass(frozen=True)
class Scaling:
    """Scales of a chain of equal beads, in SI units.

    Parameters
    ----------
    mass : float
        m of a bead, kg.
    stiffness : float
        k of the elastic force, N m^(−α); see `sphere_stiffness`.
    damping : float
        γ₀, s m^(α − β); 0 for a conservative chain; see `damping_from_restitution`.
    velocity : float
        Reference velocity v₀, m/s; see `velocity_of_compression` and `velocity_of_force`.
    alpha, beta : float, optional
        Exponents, α above 0 and β of 1 or more; 3/2, and β = α by default.

    Raises
    ------
    InputError
        If a value is impossible.

    Examples
    --------
    >>> k = gf.sphere_stiffness(radius=0.01, youngs_modulus=200e9, poisson_ratio=0.3)
    >>> scaling = gf.Scaling(mass=0.033, stiffness=k, damping=6e-6, velocity=0.1)
    >>> print(scaling)
    γ = 0.150279; units: v₀ = 0.1 m/s, δ₀ = 3.99257e-06 m, T₀ = 3.99257e-05 s, F₀ = 82.6535 N
    """

    mass: float
    stiffness: float
    damping: float
    velocity: float
    alpha: float = 1.5
    # None means α, which replaces it below.
    beta: float = None  # type: ignore[assignment]

    def __post_init__(self) -> None:
        beta = self.alpha if self.beta is None else self.beta
        checked = {
            **_positive(
                mass=self.mass,
                stiffness=self.stiffness,
                velocity=self.velocity,
                alpha=self.alpha,
            ),
            "damping": scalar("damping", self.damping, least=0.0, advice="give gamma_0"),
            "beta": scalar("beta", beta, least=1.0, advice="give an exponent"),
        }
        for name, value in checked.items():
            object.__setattr__(self, name, value)
        with double_precision("A scale of this chain", "give values in SI units"):
            scales = [*self._scales().values(), 1.0 + self.gamma]
            if not math.isfinite(sum(1.0 / scale for scale in scales) + sum(scales)):
                raise OverflowError

    @classmethod
    def of_spheres(cls, first: str, velocity: float, damping: float = 0.0) -> "Scaling":
        """Return the scales of a chain whose first bead has this material and diameter.

        A scene with `beads` of materials has masses and stiffness in these units.

        >>> chain = gf.Scaling.of_spheres("steel 9.5 mm", velocity=1.0)
        >>> print(f"{chain.to_physical(1.0, 'force'):.0f} N, {chain.time * 1e6:.1f} µs")
        300 N, 11.7 µs
        """
        body = named_body("first", first)
        return cls(body.mass, contact_stiffness(first, first), damping, velocity)

    def __str__(self) -> str:
        """Return the damping and the units, which `print` shows."""
        return (
            f"γ = {self.gamma:.6g}; units: v₀ = {self.velocity:.6g} m/s, δ₀ = {self.length:.6g} m, "
            f"T₀ = {self.time:.6g} s, F₀ = {self.force:.6g} N"
        )

    @property
    def time(self) -> float:
        """T₀ in seconds."""
        slow = (self.mass / self.stiffness) ** (1.0 / (self.alpha + 1.0))
        return slow * self.velocity ** ((1.0 - self.alpha) / (1.0 + self.alpha))

    @property
    def length(self) -> float:
        """δ₀ in metres."""
        return self.velocity * self.time

    @property
    def force(self) -> float:
        """F₀ = kδ₀^α in newtons."""
        return self.mass * self.velocity / self.time

    @property
    def gamma(self) -> float:
        """Dimensionless damping γ (29)."""
        share = self.beta / (self.alpha + 1.0)
        rate = (self.stiffness / self.mass) ** (1.0 - share)
        return self.damping * self.velocity ** (2.0 * share - 1.0) * rate

    @property
    def critical_velocity(self) -> float:
        """v_c in m/s, the velocity v₀ at which γ = 1.

        Raises
        ------
        InputError
            If β = (α + 1)/2 or γ₀ = 0, where γ does not depend on the velocity.
        """
        power = self.power_of_velocity
        if power == 0.0 or self.damping == 0.0:
            raise InputError(
                f"gamma is {self.gamma:.6g} at every velocity, since beta = (alpha + 1)/2 or the "
                "damping is 0 (James 2021, eq. 29): there is no velocity v_c."
            )
        with double_precision("v_c", "bring gamma closer to 1"):
            return self.velocity * self.gamma ** (-1.0 / power)

    @property
    def power_of_velocity(self) -> float:
        """Exponent 2β/(α + 1) − 1 of v₀ in γ; weak damping at small v₀ where it is positive."""
        return (2.0 * self.beta - (self.alpha + 1.0)) / (self.alpha + 1.0)

    @property
    def weak_damping(self) -> str:
        """Where γ → 0: at "small velocities", at "large velocities" or at "no velocity"."""
        if self.power_of_velocity == 0.0:
            return "no velocity"
        return "small velocities" if self.power_of_velocity > 0.0 else "large velocities"

    @property
    def front_speed(self) -> float:
        """Speed c in beads per second of a front behind which the beads move at v₀ (23)."""
        return math.copysign(1.0 / self.time, self.alpha - 1.0)

    def to_physical(self, value: Value, quantity: str) -> Value:
        """Return a dimensionless value in SI units.

        The quantity is displacement, velocity, acceleration, time, force or energy.
        """
        return value * self._scale(quantity)

    def to_dimensionless(self, value: Value, quantity: str) -> Value:
        """Return a value in SI units made dimensionless; the inverse of `to_physical`."""
        return value / self._scale(quantity)

    def _scale(self, quantity: str) -> float:
        scales = self._scales()
        return scales[choice("quantity", quantity, scales)]

    def _scales(self) -> dict[str, float]:
        return {
            "displacement": self.length,
            "velocity": self.velocity,
            "acceleration": self.velocity / self.time,
            "time": self.time,
            "force": self.force,
            "energy": self.mass * self.velocity**2,
        }


def sphere_mass(radius: float, density: float) -> float:
    """Mass in kg of a sphere with a radius in metres and a density in kg/m³."""
    radius, density = _positive(radius=radius, density=density).values()
    return 4.0 / 3.0 * math.pi * radius**3 * density


def sphere_stiffness(radius: float, youngs_modulus: float, poisson_ratio: float) -> float:
    """Stiffness k of the contact of two equal spheres, for α = 3/2.

    Parameters
    ----------
    radius : float
        In metres, above 0.
    youngs_modulus : float
        In pascals, above 0.
    poisson_ratio : float
        Between −1 and 1/2.

    Returns
    -------
    float
        k in N m^(−3/2), Remark 6 of James (2021).

    Raises
    ------
    InputError
        If a value is impossible.

    Examples
    --------
    >>> round(gf.sphere_stiffness(radius=0.01, youngs_modulus=200e9, poisson_ratio=0.3))
    10360538918
    """
    radius, modulus = _positive(radius=radius, youngs_modulus=youngs_modulus).values()
    poisson_ratio = scalar(
        "poisson_ratio",
        poisson_ratio,
        above=-1.0,
        below=0.5,
        advice="every stable isotropic solid has one between",
    )
    return modulus * math.sqrt(2.0 * radius) / (3.0 * (1.0 - poisson_ratio**2))


def velocity_of_compression(
    delta: float, mass: float, stiffness: float, alpha: float = 1.5
) -> float:
    """Return v₀ in m/s that makes the length scale the compression δ in metres, |v_p| of (22)."""
    given = _positive(delta=delta, mass=mass, stiffness=stiffness, alpha=alpha)
    delta, mass, stiffness, alpha = given.values()
    return math.sqrt(stiffness / mass) * delta ** ((alpha + 1.0) / 2.0)


def velocity_of_force(force: float, mass: float, stiffness: float, alpha: float = 1.5) -> float:
    """Return v₀ in m/s of a chain pressed by a force in newtons, by its compression (F/k)^(1/α)."""
    force, k, alpha = _positive(force=force, stiffness=stiffness, alpha=alpha).values()
    return velocity_of_compression((force / k) ** (1.0 / alpha), mass, stiffness, alpha)


def damping_from_restitution(
    e: float,
    impact_velocity: float,
    mass: float,
    stiffness: float,
    alpha: float = 1.5,
    beta: float | None = None,
) -> float:
    """Coefficient γ₀ of the viscous force, from a measured restitution of two equal beads.

    Parameters
    ----------
    e : float
        Coefficient of restitution, above 0 and at most 1.
    impact_velocity : float
        Relative velocity at which it was measured, in m/s, above 0.
    mass : float
        m of a bead in kg, above 0.
    stiffness : float
        k in N m^(−α), above 0; see `sphere_stiffness`.
    alpha : float, optional
        Exponent of the elastic force, above 0.
    beta : float, optional
        Exponent of the viscous force, 1 to 20 (α + 1); α by default.

    Returns
    -------
    float
        γ₀ in s m^(α − β).

    Raises
    ------
    InputError
        If a value is impossible.

    Examples
    --------
    >>> k = gf.sphere_stiffness(radius=0.01, youngs_modulus=200e9, poisson_ratio=0.3)
    >>> damping = gf.damping_from_restitution(
    ...     0.9, impact_velocity=1.0, mass=0.033, stiffness=k
    ... )
    >>> print(f"{damping:.3e} s")
    1.174e-06 s
    """
    beta = alpha if beta is None else beta
    velocity = _positive(impact_velocity=impact_velocity)["impact_velocity"]
    gamma = damping_for_restitution(e, alpha, beta)
    return gamma / Scaling(mass, stiffness, 1.0, velocity, alpha, beta).gamma


def _positive(**values: float) -> dict[str, float]:
    """Return the values as floats above 0, by name, in the order given."""
    return {
        name: scalar(name, value, above=0.0, advice="give one in SI units")
        for name, value in values.items()
    }
