r"""Floquet multipliers of a front: whether it returns to itself after a small kick.

Monodromy.  Let the chain move for one bead-time and follow the front by one bead.  In the frame δ =
c = 1 the map :math:`T(u, d)_n = \Phi(u, d)_{n+1}` leaves an exact front unchanged
(`shooting.equations`).  The derivative of T is the monodromy matrix.  It multiplies a small
perturbation in each bead-time, and its eigenvalues z are the Floquet multipliers.

Translation.  A shifted front is a front: :math:`(U', D')` has the multiplier 1.  From the left the
multiplier belongs to a conservation law.  As long as nothing reaches the ends, T leaves the
momentum seen from the moving front, :math:`\sum_n (n\,\delta d_n + \delta u_n)`, unchanged.  It
measures how far a kick displaces the front in the end.  That holds at any state that joins 1 to 0,
so that a multiplier 1 proves no front.  Therefore `flow_residual` says how far T moves the state
itself.

Untouched chain.  Ahead u = 0 and no contact is stiff: :math:`\delta\dot u = \delta d`,
:math:`\delta\dot d = 0`, and T is the shift towards the front times a Jordan block at 1.  On an
infinite chain every :math:`z^n`, :math:`|z| < 1`, is then an eigenvector: a perturbation of the
chain ahead, which the front has not met.  It says nothing of the front, and nothing enters the
window from there: the block becomes nilpotent and its multipliers 0.  Rounding spreads a nilpotent
block of k contacts over :math:`|z| \lesssim \epsilon^{1/k}`, so that small multipliers have no
meaning.  The window ends where u is lost in rounding.

Compressed chain.  Behind, a wave :math:`e^{iqn + \sigma t}` obeys :math:`\sigma^2 +
\beta\gamma\kappa\,\sigma + \alpha\kappa = 0`, :math:`\kappa = 2 - 2\cos q`, and is multiplied by
:math:`z = e^{iq + \sigma}`.  These curves are the essential spectrum on the line; they lie inside
the unit circle and touch it at 1, where q = 0. There is no gap: long waves die out slowly.  Nor
does an exponential weight :math:`e^{\nu n}` open one.  The two sound waves have the velocities
:math:`\pm\sqrt\alpha - 1` in the frame of the front.  As in Lax's shocks, one runs into the front
and one away from it.  A weight that damps the one feeds the other.

Window.  With B beads behind, and u = 1 held at the last of them, a long wave travels to and fro in
:math:`B/(\sqrt\alpha - 1) + B/(\sqrt\alpha + 1)` bead-times.  The held end reflects u with the
factor −1; at the front the jump conditions :math:`v = cu`, :math:`cv = u^\alpha`, linearised with
the speed c free to change, give :math:`-(\sqrt\alpha - 1)^2/(\sqrt\alpha + 1)^2`.  Hence the
largest multiplier except for translation is real, and

.. math::

    1 - z \simeq \frac{\alpha - 1}{\sqrt\alpha\,B}\,
        \ln\frac{\sqrt\alpha + 1}{\sqrt\alpha - 1}

tends to 0 with the window as it must, whatever the damping.  A front is stable if all
multipliers except for translation lie inside the unit circle for every B.  An instability would be
a multiplier outside that stays in place as B grows.  Finitely many windows can only find none;
`granular_fronts.proofs.stability` proves for some fronts that there is none.

Section 6 of the paper is not in our copy: the definition above is ours.
"""

import math
from typing import Any

import numpy as np
import scipy.linalg
import xarray as xr

from granular_fronts.arguments import count
from granular_fronts.errors import InputError
from granular_fronts.fronts.shooting import bead_flow
from granular_fronts.fronts.shooting.bead_flow import PowerLaw
from granular_fronts.fronts.shooting.initial_guess import Guess, fit
from granular_fronts.fronts.shooting.solve import LARGEST_DECAY_PER_STEP
from granular_fronts.fronts.shooting.window import slow_roots, tail_length
from granular_fronts.fronts.validation import check_front_of_powers
from granular_fronts.numerics.threads import one_thread

STEPS = 32
FEWEST_BEHIND, MOST_BEHIND = 40, 300
UNTOUCHED = 1.0e-16
MOST_BEADS = 500  # on either side; the eigenvalues of so many take seconds, and Ctrl-C waits
LARGEST_DEFECT = 1.0e-6  # of the multiplier of translation and of the flow, with a verdict
INTEGER_XI = 1.0e-9  # distance from an integer
UNITS_OF_ROUNDING = 10  # of the matrix and its eigenvalues, relative to its norm


def front_multipliers(
    front: xr.Dataset, *, beads_behind: int | None = None, beads_ahead: int | None = None
) -> xr.DataArray:
    """Compute Floquet multipliers of a front, eigenvalues of its monodromy matrix in a window.

    Parameters
    ----------
    front : xarray.Dataset
        `relative_displacement` and `velocity` on `xi`, which holds all integers of its range; u =
        1/2 at ξ = 0; attributes alpha, beta, gamma; in the frame δ = c = 1.
    beads_behind : int, optional
        Beads behind ξ = 0, at rest with u = 1 where the front does not reach. By default as many
        as the tail needs, but from 40 to 300.
    beads_ahead : int, optional
        Beads ahead of it; by default to the first with u < 1e-16.

    Returns
    -------
    xarray.DataArray
        Complex multipliers on `multiplier`, that of translation first, then by decreasing modulus.
        Coordinate `rounding`: how much ten units of rounding move each of them, to first order.
        Attributes: translation_defect, its distance from 1; spectral_radius_without_translation;
        reflection_radius, what the module's formula for long waves gives; flow_residual;
        beads_behind, beads_ahead; verdict.

    Raises
    ------
    InputError
        If it has not converged, or its damping is too strong for the steps of the flow. If ξ = 0 or
        another integer is not among the points.

    Examples
    --------
    >>> front = gf.solve_front(alpha=1.5, gamma=0.3)
    >>> multipliers = gf.front_multipliers(front, beads_behind=40)
    >>> multipliers.attrs["spectral_radius_without_translation"] < 1.0
    True
    """
    check_front_of_powers(front)
    alpha, beta, gamma = (float(front.attrs[name]) for name in ("alpha", "beta", "gamma"))
    if 4.0 * beta * gamma > STEPS * LARGEST_DECAY_PER_STEP:
        raise InputError(
            f"front has the damping rate 4 beta gamma = {4.0 * beta * gamma:.3g}, but {STEPS} "
            f"explicit steps per bead-time resolve {STEPS * LARGEST_DECAY_PER_STEP:g}: take a "
            "front of weaker damping."
        )
    sampled = _at_beads(front, beta, gamma)
    limits: dict[str, Any] = {
        "most": MOST_BEADS,
        "advice": "give a number of beads, or leave it out",
    }
    if beads_behind is None:
        needed = tail_length(slow_roots(alpha, gamma, beta))
        beads_behind = math.ceil(min(max(needed, FEWEST_BEHIND), MOST_BEHIND))
    if beads_ahead is None:
        ahead = sampled.relative_displacement[sampled.bead > 0]
        beads_ahead = 1 + int(np.argmin(np.append(ahead, 0.0) > UNTOUCHED))
    beads_behind = count("beads_behind", beads_behind, **limits)
    beads_ahead = count("beads_ahead", beads_ahead, **limits)
    u, d = fit(sampled, np.arange(-beads_behind, beads_ahead + 1)).T
    values, errors = multipliers(u, d, alpha, gamma, beta)
    residual = flow_residual(u, d, alpha, gamma, beta)
    return xr.DataArray(
        values,
        dims="multiplier",
        coords={
            "multiplier": np.arange(1, values.size + 1),
            "rounding": ("multiplier", errors),
        },
        attrs={
            "translation_defect": float(np.abs(values[0] - 1.0)),
            "spectral_radius_without_translation": float(np.abs(values[1])),
            "reflection_radius": reflection_radius(alpha, beads_behind),
            "flow_residual": residual,
            "beads_behind": beads_behind,
            "beads_ahead": beads_ahead,
            "verdict": _verdict(values, residual),
        },
    )


@one_thread()
def multipliers(u, d, alpha, gamma, beta):
    r"""Eigenvalues of `monodromy_matrix`, the one next to 1 first, then by decreasing modulus.

    With the changes that rounding makes, :math:`K\epsilon |T| |y| |x| / |y^* x|` of a left and a
    right eigenvector: those of K units of rounding in the matrix, to first order.
    """
    matrix = monodromy_matrix(u, d, alpha, gamma, beta)
    values, left, right = scipy.linalg.eig(matrix, left=True)
    overlap = np.abs(np.sum(left.conj() * right, axis=0))
    # Defective ones have no overlap: rounding moves them anywhere.
    overlap = np.maximum(overlap, np.finfo(float).tiny)
    errors = UNITS_OF_ROUNDING * np.finfo(float).eps * scipy.linalg.svdvals(matrix)[0] / overlap
    translation = np.argmin(np.abs(values - 1.0))
    others = np.lexsort((-values.imag, -np.abs(values)))
    order = np.concatenate([[translation], others[others != translation]])
    return values[order], errors[order]


def monodromy_matrix(u, d, alpha, gamma, beta):
    """Return the derivative of flow-then-shift, u = 1 held behind and nothing entering from ahead.

    It acts on (u_1, d_1, u_2, d_2, …) of consecutive beads.
    """
    law, beads = PowerLaw(alpha, beta, gamma), u.size
    _, stiffness = _flow(law, u, d)
    spread = min(bead_flow.spread_of(law, STEPS, max(1.0, float(u.max()))), beads)
    weights = bead_flow.make_weights(law, 1.0 / STEPS)
    band = bead_flow.derivative(law, weights, stiffness, spread)
    matrix = np.zeros((beads, 2, beads + 2 * spread, 2))
    for n in range(beads):
        matrix[n, :, n : n + 2 * spread + 1] = band[n + 2].transpose(1, 0, 2)
    # Row n is contact n + 2 of the band, whose first column is contact n + 2 − spread.
    first = spread - 1
    return matrix[:, :, first : first + beads].reshape(2 * beads, 2 * beads)


def flow_residual(u, d, alpha, gamma, beta):
    """Return the largest change of a state by flow-then-shift: how far it is from a front."""
    change, _ = _flow(PowerLaw(alpha, beta, gamma), u, d)
    state = np.pad([u, d], [(0, 0), (0, 1)])
    return float(np.abs(np.diff(state, axis=1) + change[:, 2:-1]).max())


def _flow(law, u, d):
    """Return the change in a bead-time, and stiffnesses; a contact at rest is added at the end."""
    start = np.zeros((2, u.size + 3))
    start[:, 1:-2] = u, d
    stiffness = bead_flow.make_stiffness(law, STEPS, u.size + 3)
    weights = bead_flow.make_weights(law, 1.0 / STEPS)
    driver = np.ones((STEPS, bead_flow.STAGES))
    return bead_flow.flow(law, weights, driver, *start, stiffness), stiffness


def compressed_chain_multipliers(alpha, gamma, beta, q):
    """Return the essential spectrum behind a front, two multipliers per wavenumber, (2, …)."""
    q = np.asarray(q, dtype=float)
    kappa = 2.0 - 2.0 * np.cos(q)
    half = 0.5 * beta * gamma * kappa
    root = np.sqrt(half**2 - alpha * kappa + 0j)
    return np.exp(1j * q + np.array([-half + root, -half - root]))


def reflection_radius(alpha, beads_behind):
    """Return the largest multiplier except for translation, by the reflections of long waves."""
    speed = math.sqrt(alpha)
    rate = (alpha - 1.0) / speed * math.log((speed + 1.0) / (speed - 1.0))
    return math.exp(-rate / beads_behind)


def _at_beads(front, beta, gamma):
    """Return the front at integer ξ, as u and d."""
    xi = front["xi"].values
    bead = np.round(xi).astype(int)
    whole = np.abs(xi - bead) < INTEGER_XI
    bead = bead[whole]
    if 0 not in bead or np.any(np.diff(bead) != 1):
        raise InputError(
            f"xi runs from {xi[0]:.6g} to {xi[-1]:.6g} and holds {bead.size} integers, but every "
            "integer around 0 is needed: give a whole number of points per site."
        )
    u, velocity = (front[name].values[whole] for name in ("relative_displacement", "velocity"))
    w = velocity[1:] + gamma * np.diff(np.maximum(u, 0.0) ** beta)
    return Guess(bead[1:-1], u[1:-1], -np.diff(w))


def _verdict(values, residual):
    defect, radius = abs(values[0] - 1.0), abs(values[1])
    if residual > LARGEST_DEFECT:
        return (
            f"undecided: flow and shift change the state by {residual:.1e}, so it is no front, "
            "or one wider than the window"
        )
    if defect > LARGEST_DEFECT:
        return (
            f"undecided: the multiplier of translation is {defect:.1e} away from 1: give more "
            "beads behind"
        )
    outside = int(np.sum(np.abs(values[1:]) > 1.0))
    if outside:
        return f"unstable: {outside} multipliers outside the unit circle, the largest {radius:.6f}"
    return f"no unstable multiplier found: except for translation, the largest is {radius:.6f}"
