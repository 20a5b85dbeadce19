r"""How wrong a number can be: a value with its error, and the refinement that estimates it.

An error estimate is the difference between a result and an independent refinement.  The refinement
solves the same problem on a finer grid, by another order, or at a smaller tolerance
(`with_refinement`).  The error of a variable is the largest difference over all points where both
solutions are finite.  It is never smaller than the *rounding floor*, one unit in the last place of
the largest value.  Two results may agree to the last bit by chance, but that bit stays uncertain.

Estimates propagate through sums, products and quotients to first order and in the worst case,

.. math::

    \Delta(a \pm b) = \Delta a + \Delta b, \quad
    \Delta(ab) = |b|\,\Delta a + |a|\,\Delta b, \quad
    \Delta(a/b) = (\Delta a + |a/b|\,\Delta b) / |b| ,

since the errors of two numbers from one solution are not independent.

The modules named `measures` read estimates of single numbers off the solutions.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from granular_fronts.errors import SolveError

if TYPE_CHECKING:
    import numpy.typing as npt
    import xarray as xr

EPSILON = float(np.finfo(float).eps)
"""Distance of 1 to the next double, 2⁻⁵²."""

Variable = tuple[str | tuple[str, ...], np.ndarray, dict[str, Any]]
"""A variable as xarray takes it: dimensions, values, attributes."""


class _Pair(NamedTuple):
    value: float
    error: float


class Estimate(_Pair):
    """A value and an estimate of its absolute error, with the arithmetic of such pairs.

    Examples
    --------
    >>> Estimate(6.0, 0.25) / Estimate(2.0, 0.5)
    Estimate(value=3.0, error=0.875)
    """

    __slots__ = ()

    # Numpy's numbers would otherwise take an estimate for an array of two.
    __array_ufunc__ = None

    def __neg__(self) -> Estimate:
        return Estimate(-self.value, self.error)

    # A sum of estimates is one of numbers, not the joined tuple; a product alike.
    def __add__(self, other: Estimate | float) -> Estimate:  # type: ignore[override]
        other = _as_estimate(other)
        return Estimate(self.value + other.value, self.error + other.error)

    def __sub__(self, other: Estimate | float) -> Estimate:
        return self + -_as_estimate(other)

    def __mul__(self, other: Estimate | float) -> Estimate:  # type: ignore[override]
        other = _as_estimate(other)
        error = abs(other.value) * self.error + abs(self.value) * other.error
        return Estimate(self.value * other.value, error)

    def __truediv__(self, other: Estimate | float) -> Estimate:
        other = _as_estimate(other)
        ratio = self.value / other.value
        return Estimate(ratio, (self.error + abs(ratio) * other.error) / abs(other.value))

    def __pow__(self, power: float) -> Estimate:
        value = self.value**power
        return Estimate(value, abs(power * value / self.value) * self.error)

    __radd__ = __add__
    __rmul__ = __mul__  # type: ignore[assignment]


def _as_estimate(number: Estimate | float) -> Estimate:
    return number if isinstance(number, Estimate) else Estimate(number, 0.0)


class Refined(NamedTuple):
    """A solution, and the same problem solved more accurately."""

    usual: Any
    finer: Any

    def map(self, function: Callable[[Any], Any]) -> Refined:
        """Return a function of both solutions."""
        return Refined(function(self.usual), function(self.finer))

    def estimate(self, measure: Callable[[Any], float] = float) -> Estimate:
        """Return a number measured on both solutions, with its error."""
        return estimate(*self.map(measure))


def with_refinement(solve: Callable[[Any], Any], usual: Any, finer: Any) -> Refined:
    """Solve a problem at two resolutions, so that the difference estimates the error.

    A resolution is a tolerance, a grid, an order, or several of these.  Where the refinement fails,
    the sentence of its SolveError says so.
    """
    return refined_by(lambda _found: solve(finer), solve(usual))


def refined_by(refine: Callable[[Any], Any], found: Any) -> Refined:
    """Return a solution and its refinement, which starts from the solution; otherwise the same."""
    try:
        return Refined(found, refine(found))
    except SolveError as error:
        raise type(error)(
            f"the refinement that should estimate the error failed: {error}"
        ) from error


def rounding_floor(values: npt.ArrayLike) -> float:
    """Return one unit in the last place of the largest finite value; NaN without one."""
    return float(np.spacing(_largest(values)))


def largest_difference(values: npt.ArrayLike, others: npt.ArrayLike) -> float:
    """Return the largest difference of values computed twice, at least the rounding floor.

    A missing value is NaN, for example an arrival that did not happen.  The result is NaN if no
    pair is finite, and 0 if there are no values.
    """
    if np.size(values) == 0:
        return 0.0
    difference, size = _largest(np.subtract(values, others)), _largest(values)
    return max(difference, float(np.spacing(size))) if size else difference


def estimate(value: float, other: float) -> Estimate:
    """Return a number that was computed twice, with its error."""
    return Estimate(float(value), largest_difference(value, other))


def rounded(value: float, units: float = 1.0) -> Estimate:
    """Return a number from a closed formula, whose error is some units in its last place."""
    return Estimate(float(value), units * rounding_floor(value))


def sampled_maximum(values: npt.ArrayLike) -> Estimate:
    """Return the vertex of the parabola through the largest of equidistant samples, or an end.

    A smooth function exceeds its samples by at most h²|f''|/8, which is the error.
    """
    samples = np.pad(np.asarray(values, dtype=float), 1, constant_values=np.nan)
    top = int(np.nanargmax(samples))
    left, largest, right = samples[top - 1 : top + 2].tolist()
    bend = 2.0 * largest - left - right
    if not bend > 0.0:
        return rounded(largest)
    return rounded(largest) + Estimate(0.125 * (left - right) ** 2 / bend, 0.125 * bend)


def recorded(variable: xr.DataArray) -> Estimate:
    """Return a number that a variable without dimensions holds, with its `error_estimate`."""
    return Estimate(float(variable), float(variable.attrs["error_estimate"]))


def certain_sign(variable: xr.DataArray) -> xr.DataArray:
    """Sign of each value, 0 for NaN and where its size is at most its `error_estimate`.

    A contact counts as open where the sign of its relative displacement is -1.
    """
    error = variable.attrs["error_estimate"]
    return (variable > error).astype(int) - (variable < -error).astype(int)


def tabulated(dataset: xr.Dataset, name: str, **place: Any) -> Estimate:
    """Return a number of a dataset at a place, with its error, the variable `<name>_error`."""
    there = dataset.sel(place)
    return Estimate(float(there[name]), float(there[f"{name}_error"]))


def estimated_variable(
    dims: str | tuple[str, ...], estimates: npt.ArrayLike, method: str, **attributes: Any
) -> Variable:
    """Return a variable from estimates of the shape of `dims`, with the largest of their errors.

    `method` says how the errors were found; `attributes` are further ones, `long_name` for example.
    """
    values, errors = np.moveaxis(np.array(estimates, dtype=float), -1, 0)
    return (
        dims,
        values,
        {
            **attributes,
            "error_estimate": float(errors.max()),
            "error_method": method,
        },
    )


def variable_and_errors(
    name: str, dims: str | tuple[str, ...], estimates: npt.ArrayLike, method: str, meaning: str
) -> dict[str, Variable]:
    """Return the variables `name` and `<name>_error`, from estimates; arguments as above."""
    errors = np.array(estimates, dtype=float)[..., 1]
    return {
        name: estimated_variable(dims, estimates, method, long_name=meaning),
        f"{name}_error": (dims, errors, {"long_name": f"error of the {meaning}"}),
    }


def error_attributes(values: npt.ArrayLike, others: npt.ArrayLike, method: str) -> dict[str, Any]:
    """Return `error_estimate` and `error_method` of a variable that was computed twice."""
    return {"error_estimate": largest_difference(values, others), "error_method": method}


def _largest(values: npt.ArrayLike) -> float:
    """Return the largest finite absolute value; NaN without one."""
    sizes = np.abs(np.asarray(values, dtype=float))
    largest = float(sizes.max(initial=0.0))
    if sizes.size and math.isfinite(largest):
        return largest
    finite = sizes[np.isfinite(sizes)]
    return float(finite.max()) if finite.size else math.nan
