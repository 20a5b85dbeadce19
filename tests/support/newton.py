"""Newton's law of any chain by SciPy, which knows neither w nor the strain form."""

from itertools import pairwise

import numpy as np
from scipy.integrate import solve_ivp

from granular_fronts.chain import run
from granular_fronts.chain.patterns import values_along
from granular_fronts.scenes.chain import Chain


def newton(scene, rtol=1.0e-12, atol=1.0e-14):
    """u and velocity of all beads at the end of a scene, as `chains.last_state` has them."""
    scene = Chain.read(scene)
    u, velocity = np.split(
        solutions(scene, rtol=rtol, atol=atol)[-1].y[:, -1], [scene.contact_count]
    )
    boundary = run.make_boundary(scene)
    if boundary.holds_right:
        u = np.append(u, boundary.right)
    if boundary.piston:
        velocity[0] = boundary.drive.value(scene.end_time)
    return np.concatenate([u, velocity])


def solutions(scene, **options):
    """What `solve_ivp` returns from one break of the drive to the next, of the state (u, ẋ).

    Contact n transmits T_n = κ_n F(u_n) + χ_n G'(u_n) u̇_n, and m_n ẍ_n = T_(n−1) − T_n + m_n g.
    """
    scene = Chain.read(scene)
    law, boundary, gravity = scene.law, run.make_boundary(scene), scene.gravity
    count, contacts, drive = scene.beads.count, scene.contact_count, boundary.drive
    mass = values_along(scene.beads.masses(), count)
    stiffness = values_along(scene.elastic, contacts)
    viscosity = values_along(scene.contacts.viscous or scene.elastic, contacts)
    held_left, held_right = (-law.elastic.first(-end) for end in (boundary.left, boundary.right))

    def slopes(t, state):
        strain, velocity = -state[:contacts], state[contacts:]
        forces = np.full(count + 1, held_right)  # Behind bead 1, and ahead of all.
        forces[0] = held_left
        if boundary.piston:
            velocity[0] = drive.value(t)
        elif drive:
            forces[0] = drive.value(t)
        rate = velocity.copy()
        rate[:-1] -= velocity[1:]
        if boundary.ring:
            rate[-1] -= velocity[0]
        rate = rate[:contacts]
        viscous = viscosity * law.viscous.second(strain) * rate
        forces[1 : contacts + 1] = viscous - stiffness * law.elastic.first(strain)
        if boundary.ring:
            forces[0] = forces[-1]
        return np.concatenate([rate, gravity - np.diff(forces) / mass])

    u, velocity = run.initial_state(scene, law, boundary, run.make_beads(scene))
    state, found = np.concatenate([u[:contacts], velocity]), []
    breaks = [] if drive is None else drive.breaks[drive.breaks < scene.end_time]
    for start, end in pairwise([0.0, *breaks, scene.end_time]):
        inside = (start, np.nextafter(end, start))
        found.append(solve_ivp(slopes, inside, state, "DOP853", **options))
        state = found[-1].y[:, -1]
    return found
