r"""Shape and height of the pulse that an impact leaves in a chain, far away, for any damping.

One bead of mass m strikes a chain of equal beads at rest, with the velocity :math:`v_0`, and no
force acts on the ends.  Far from the struck end damping and dispersion act in the front alone,
which is a jump.  Behind it compression u and velocity v obey the long-wave limit of (2),

.. math:: m\,\partial_t v + \partial_n u^\alpha = 0, \qquad \partial_t u + \partial_n v = 0 .

The momentum :math:`P = m v_0` stays, since the struck end is free.  Let N be the place of the
front, :math:`z = n/N`, and by (12) and (14)

.. math:: u = \delta\,U(z), \quad v = c\,\delta\,V(z), \quad U(1) = V(1) = 1, \quad
          m c^2 = \delta^{\alpha - 1}, \quad \dot N = c .

With :math:`G = \int_0^1 V\,dz` and m = 1 the momentum :math:`c\,\delta\,N\,G = P` gives

.. math:: \delta = \Bigl(\frac{P}{G N}\Bigr)^{2/(\alpha + 1)}, \qquad
          t = \frac{\alpha + 1}{2\alpha}\,\frac Nc .

The first equation integrates to :math:`z V = U^\alpha`.  With :math:`w = U^{\alpha-1} z^{-2}`,
which grows from 1 at the front to infinity at the struck end, the second one becomes

.. math::

    \frac{d \ln z}{d \ln w} = -\frac{\alpha w - 1}{(\alpha + 1)(w - w_*)}, \qquad
    w_* = \frac{4\alpha}{(\alpha + 1)^2}, \qquad
    z = w^{-A} \Bigl(\frac{w - w_*}{1 - w_*}\Bigr)^{-B} ,

with :math:`A = (\alpha + 1)/(4\alpha)` and :math:`A + B = \alpha/(\alpha + 1)`.  There is no free
constant, and neither the damping nor its law enters, as long as the front stays narrow.
"""

import numpy as np
from scipy.integrate import quad


def shape_of_pulse(alpha, w):
    """Return z, U and V at values of w, from 1 at the front to infinity at the struck end.

    Examples
    --------
    >>> [round(float(one), 4) for one in shape_of_pulse(1.5, 2.0)]
    [0.4122, 0.1155, 0.0953]
    """
    w = np.asarray(w, dtype=float)
    critical = 4.0 * alpha / (alpha + 1.0) ** 2
    A = (alpha + 1.0) / (4.0 * alpha)
    B = alpha / (alpha + 1.0) - A
    z = w**-A * ((w - critical) / (1.0 - critical)) ** -B
    U = (w * z * z) ** (1.0 / (alpha - 1.0))
    return z, U, U**alpha / z


def share_of_momentum(alpha):
    """Return G = ∫ V dz, the momentum of the pulse over that of N beads at the front's velocity.

    Examples
    --------
    >>> round(share_of_momentum(1.5), 6)
    0.237881
    """
    critical = 4.0 * alpha / (alpha + 1.0) ** 2

    def integrand(logarithm):
        w = np.exp(logarithm)
        z, _, V = shape_of_pulse(alpha, w)
        return V * z * (alpha * w - 1.0) / ((alpha + 1.0) * (w - critical))

    # Where w is e⁸⁰ the rest is below round-off for α up to 3.
    return quad(integrand, 0.0, 80.0, epsabs=0.0, epsrel=1.0e-12, limit=400)[0]


def height_of_front(alpha, place, momentum):
    """Return the height δ of the front at some places N, m = 1."""
    return (momentum / (share_of_momentum(alpha) * place)) ** (2.0 / (alpha + 1.0))


def time_of_front(alpha, place, momentum):
    """Return when the front is at some places N, m = 1."""
    speed = height_of_front(alpha, place, momentum) ** (0.5 * (alpha - 1.0))
    return (alpha + 1.0) / (2.0 * alpha) * place / speed
