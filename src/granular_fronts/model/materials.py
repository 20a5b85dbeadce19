r"""Materials of beads and walls, and the stiffness of a contact of two of them by Hertz's law.

Bodies of radii :math:`R_1, R_2`, Young's moduli :math:`E_i` and Poisson's ratios :math:`\nu_i`
press on each other with

.. math::

    F = k\,u^{3/2}, \qquad k = \tfrac43\,E_*\sqrt{R_*}, \qquad
    \frac1{E_*} = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}, \qquad
    \frac1{R_*} = \frac1{R_1} + \frac1{R_2} ,

where u is how far they approach (K. L. Johnson, *Contact Mechanics*, 1985, section 4.2).  A flat
wall has :math:`R = \infty`.  The law is static and elastic.  Elastic constants of metals and glass
vary by a few per cent between makers.  Those of polymers and cork vary by tens of per cent.  Data
sheets were read for the two steels alone; all other numbers are usual values, from no single
source.

A body is written as its material and its diameter, ``steel 9.5 mm``; a wall as its material alone.
"""

import difflib
import math
import re
from typing import NamedTuple

from granular_fronts.arguments import instance
from granular_fronts.errors import InputError


class Material(NamedTuple):
    """Density in kg/m³, Young's modulus in Pa, Poisson's ratio, and what they belong to."""

    density: float
    youngs_modulus: float
    poisson_ratio: float
    source: str


MATERIALS = {
    "steel": Material(7810.0, 210.0e9, 0.30, "AISI 52100, of bearing balls; data sheets"),
    "stainless_steel": Material(8000.0, 193.0e9, 0.30, "AISI 316; data sheets, but for ν"),
    "ptfe": Material(2178.0, 1.46e9, 0.46, "polytetrafluoroethylene, as usual in papers on chains"),
    "glass": Material(2500.0, 70.0e9, 0.22, "soda-lime glass"),
    "aluminium": Material(2700.0, 68.9e9, 0.33, "6061-T6"),
    "brass": Material(8530.0, 110.0e9, 0.375, "C26000"),
    "alumina": Material(3890.0, 375.0e9, 0.22, "99.5 per cent"),
    "tungsten_carbide": Material(14900.0, 630.0e9, 0.22, "with 6 per cent cobalt"),
    "acetal": Material(1420.0, 3.1e9, 0.35, "Delrin 500"),
    "nylon": Material(1140.0, 2.8e9, 0.40, "nylon 66, dry"),
    "cork": Material(180.0, 20.0e6, 0.0, "order of magnitude"),
}
"""Materials by name."""

UNITS = {"m": 1.0, "cm": 1.0e-2, "mm": 1.0e-3, "um": 1.0e-6, "in": 0.0254}
"""Units of a diameter, in metres."""

LEAST_DIAMETER, LARGEST_DIAMETER = 1.0e-12, 1.0e12
"""Limits of a diameter in metres: masses and stiffness stay within double precision."""

_WORDS = re.compile(r"\s*(\w+?)\s*(?:\s(\S*\d\S*?)\s*([^\W\d]*)\s*)?", re.ASCII)


class Body(NamedTuple):
    """A sphere, or a flat wall, whose radius is infinite; in SI units."""

    material: Material
    radius: float

    @property
    def mass(self) -> float:
        """Mass of the sphere in kg."""
        return 4.0 / 3.0 * math.pi * self.radius**3 * self.material.density


def material_of(name: str) -> Material:
    """Return a material by name; an InputError names the nearest one."""
    if name in MATERIALS:
        return MATERIALS[name]
    near = difflib.get_close_matches(str(name), MATERIALS, n=1)
    advice = f"did you mean {near[0]}?" if near else f"choose one of {', '.join(MATERIALS)}."
    raise InputError(f"{name!r} is no material: {advice}")


def body_of(words: str) -> Body:
    """Return the body that words such as ``steel 9.5 mm`` name, a wall without a diameter.

    An InputError says that the material or the unit is unknown, or the diameter no number above 0.
    """
    found = _WORDS.fullmatch(words)
    if not found:
        raise InputError(
            f"{words!r} is no body: give a material, a diameter and its unit, as in steel 9.5 mm."
        )
    name, size, unit = found.groups()
    if size is None:
        return Body(material_of(name), math.inf)
    try:
        diameter = float(size)
    except ValueError:
        diameter = math.nan
    if not 0.0 < diameter < math.inf:
        raise InputError(f"{words!r} has the diameter {size}: give a number above 0, as in 9.5 mm.")
    if unit not in UNITS:
        raise InputError(
            f"{words!r} has the unit {unit or 'none'}, which is no length: give the diameter in "
            f"{', '.join(UNITS)}."
        )
    if not LEAST_DIAMETER <= (metres := diameter * UNITS[unit]) <= LARGEST_DIAMETER:
        raise InputError(
            f"{words!r} is {metres:g} m wide: give {LEAST_DIAMETER:g} to {LARGEST_DIAMETER:g} m."
        )
    return Body(material_of(name), 0.5 * metres)


def named_body(name: str, words: object) -> Body:
    """Return the body that an argument of some name gives."""
    words = instance(name, words, str, "give a material and a diameter, as in 'steel 9.5 mm'")
    try:
        return body_of(words)
    except InputError as error:
        raise InputError(f"{name}: {error}") from None


def hertz_stiffness(first: Body, second: Body) -> float:
    """Return k of the contact of two bodies in N m^(−3/2)."""
    compliance = sum(
        (1.0 - one.poisson_ratio**2) / one.youngs_modulus
        for one in (first.material, second.material)
    )
    return 4.0 / 3.0 / compliance / math.sqrt(1.0 / first.radius + 1.0 / second.radius)


def contact_stiffness(first: str, second: str) -> float:
    """Stiffness k of the contact of two spheres, or of a sphere and a flat wall, for α = 3/2.

    Parameters
    ----------
    first, second : str
        A sphere as its material and diameter, a wall as its material; units m, cm, mm, um or in.
        The materials and their sources are in `granular_fronts.model.materials`.

    Returns
    -------
    float
        k in N m^(−3/2), Hertz's law.

    Raises
    ------
    InputError
        If a material or unit is unknown, a diameter is not above 0, or both are walls.

    Examples
    --------
    >>> print(f"{gf.contact_stiffness('steel 9.5 mm', 'ptfe 4.8 mm'):.3e}")
    9.781e+07
    >>> print(f"{gf.contact_stiffness('steel 9.5 mm', 'steel'):.3e}")
    1.060e+10
    """
    bodies = [named_body(name, words) for name, words in (("first", first), ("second", second))]
    if math.isinf(min(body.radius for body in bodies)):
        raise InputError(
            f"first, {first!r}, and second, {second!r}, are flat: give one of them a diameter."
        )
    return hertz_stiffness(*bodies)
