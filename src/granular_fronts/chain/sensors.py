r"""What sensors at chosen contacts and inside chosen beads show, as an experiment records it.

Contact n transmits the force of James (2021), eq. (5), with the factors of `equations`,

.. math::

    T_n = \kappa_n F(u_n) + \chi_n \frac{d}{dt} G(u_n)
        = \kappa_n F(u_n) + \chi_n G'(u_n)\,(\dot x_n - \dot x_{n+1}) .

A sensor inside bead n shows the mean of the forces on both sides, :math:`(T_{n-1} + T_n)/2`; their
difference accelerates the bead, :math:`m_n \ddot x_n = T_{n-1} - T_n + m_n g`.  Beyond the ends
the forces are those that the boundary exerts: :math:`T_0 = F(\delta)` and
:math:`T_N = F(\tilde\delta)`; a drive exerts :math:`T_0 = f`, and behind a piston
:math:`T_0 = T_1 + m_1 \dot V`.

Momentum and energy that contact n has transmitted are what the beads beyond it have gained,

.. math::

    P_n = \Bigl[\sum_{k>n} m_k \dot x_k\Bigr]_0^t, \qquad
    E_n = \Bigl[\sum_{k>n} \bigl(\tfrac12 m_k \dot x_k^2 + \kappa_k V(-u_k)\bigr)\Bigr]_0^t .

Where the right end is free, no body force acts and nothing is dissipated beyond contact n, they are
:math:`\int T_n\,dt` and :math:`\int T_n \dot x_{n+1}\,dt`.  On a ring the beads beyond contact n
are n + 1 … N, and contact N counts for neither side.

All of it is taken from whole states, read from the continuous extension of the steps, of order 7.
"""

import numpy as np

from granular_fronts.chain import equations
from granular_fronts.numerics.grids import regular_points


def _times(scene):
    """Return the times of each sensor by its name."""
    return {
        name: regular_points(sensor.start, sensor.stop, sensor.step)
        for name, sensor in scene.record.sensors.items()
    }


def times_of_states(scene):
    """Return arrays of the times at which sensors need the whole chain, the start among them."""
    moments = _times(scene)
    return [np.zeros(1), *moments.values()] if moments else []


def read_sensors(scene, run, states_at):
    """Return variables and coordinates of each sensor; `states_at(run, times)` gives u and ẋ."""
    for name, times in _times(scene).items():
        sensor, at_start = scene.record.sensors[name], states_at(run, np.zeros(1))
        u, velocity = states_at(run, times)
        force = equations.transmitted_forces(u, velocity, run.boundary, run.law, run.beads)
        behind = equations.forces_behind(force, run.boundary, run.law, run.beads, times)
        momentum, energy = (
            now - before
            for now, before in zip(_beyond(run, u, velocity), _beyond(run, *at_start), strict=True)
        )
        series = {
            "contact": {
                "contact_force": force,
                "transmitted_momentum": momentum,
                "transmitted_energy": energy,
            },
            "bead": {
                "bead_force": 0.5 * (behind + force),
                "velocity": velocity,
            },
        }
        for place, fields in series.items():
            numbers = np.array(getattr(sensor, f"{place}s") or (), dtype=int)
            if numbers.size:
                dims = (f"t_{name}", f"{place}_{name}")
                values = {
                    f"{field}_{name}": (dims, of[:, numbers - 1]) for field, of in fields.items()
                }
                yield values, dict(zip(dims, (times, numbers), strict=True))


def _beyond(run, u, velocity):
    """Return momentum and energy of what is beyond each contact."""
    beads = run.beads
    elastic = beads.stiffness * run.law.elastic.value(-u)
    if not run.boundary.wall:
        elastic[:, -1] = 0.0
    each = beads.mass * velocity, 0.5 * beads.mass * velocity**2 + elastic
    # From the far end, so that what a fast bead adds leaves no rounding in the sums beyond it.
    return (np.pad(np.cumsum(of[:, :0:-1], axis=1)[:, ::-1], ((0, 0), (0, 1))) for of in each)
