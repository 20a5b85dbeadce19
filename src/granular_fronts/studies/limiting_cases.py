r"""Limits of the theory of fronts and of its continuum limit; James (2021), sections 2 to 4.

No front.  A chain at rest is pressed from t = 0 on.  Without damping (W = 0, remark 4) the
oscillations behind the wave fill a region that grows with it.  The range of u over 0.5 to 0.8 of
its way does not fall, while any damping makes it vanish.  With a quadratic V (α = 1, remark 3) the
wave spreads: its width grows like :math:`t^{1/2}`, while that of a front of α > 1 settles.

Softening.  For α < 1 the speed (14) between the strains −1 and :math:`R_+ \to 0^-` tends to the −1
of (21): the front runs towards the compressed beads.

Collision.  Two beads meet elastically with the velocity :math:`v_0`; by (27) they stay in contact
for a time :math:`\propto v_0^{(1-\alpha)/(1+\alpha)}` and reach a compression :math:`\propto
v_0^{2/(\alpha+1)}`.

Continuum.  Rings that start from the same rescaled force :math:`y^0(\xi)`, with the same γc, have
exponents that tend to 1.  They are followed to the same slow time τ. Their distance to the
logarithmic Burgers equation (41) falls (see `granular_fronts.studies.ring_against_equations`).
"""

import numpy as np
import xarray as xr

from granular_fronts.accuracy import (
    Estimate,
    estimate,
    recorded,
    variable_and_errors,
)
from granular_fronts.chain.measures import last_fall
from granular_fronts.chain.simulate import simulate_chain, simulate_once
from granular_fronts.model.amplitude_scaling import make_slow_scales
from granular_fronts.model.jump_conditions import jump_conditions
from granular_fronts.model.potentials import make_potential
from granular_fronts.studies.chain_scenes import kuwabara_kono, pressed_chain
from granular_fronts.studies.ring_against_equations import compare_with_chain

TOLERANCE = 1.0e-13, 1.0e-15
BEHIND = slice(0.5, 0.8)
"""Part of the way of the wave over which the range of u is taken."""

ERROR_METHOD = "of the chain, or the change that leaving out every other bead makes"


def measure_limiting_cases(**section):
    """Return the waves without fronts, fronts for α < 1, elastic collisions, and rings for α → 1.

    `section` is `laws: limiting_cases:` of the configuration.  Its pressed chains must be longer
    than the waves run, and are also measured at a quarter of the time.  `oscillation` on (gamma, t)
    and `width` on (alpha, t) are in units of the compression and in beads; `softening_speed` is on
    (strain_ahead,), `contact_time` and `indentation` are on (impact_velocity,).  `ring_distance` on
    (exponent,) is the root mean square distance of u/δ to the equation.
    """
    alpha, rings = section["alpha"], section["rings"]
    gammas, exponents = [0.0, section["weak_gamma"]], [1.0, alpha]
    times = [0.25 * section["end_time"], section["end_time"]]

    def press(measure, exponent, gamma):
        return [measure(u) for u in press_chain(exponent, gamma, section["beads"], times)]

    oscillations = [press(oscillation_behind, alpha, gamma) for gamma in gammas]
    widths = [press(wave_width, exponent, section["strong_gamma"]) for exponent in exponents]
    elastic = make_potential("hertz", alpha=section["softening"])
    fronts = [jump_conditions(elastic, -1.0, -strain) for strain in section["strains_ahead"]]
    speeds = [(theory.speed, theory.speed_error) for theory in fronts]
    collisions = [collide(alpha, velocity) for velocity in section["impact_velocities"]]
    times_of_contact, indentations = zip(*collisions, strict=True)
    distances = [ring_distance(exponent, rings) for exponent in rings["exponents"]]
    measured = [
        ("ring_distance", "exponent", distances, "distance of a ring to its equation"),
        ("oscillation", ("gamma", "t"), oscillations, "range of u behind the wave"),
        ("width", ("alpha", "t"), widths, "width of the wave"),
        ("softening_speed", "strain_ahead", speeds, "speed of the front"),
        ("contact_time", "impact_velocity", times_of_contact, "time of contact of two beads"),
        ("indentation", "impact_velocity", indentations, "largest compression of two beads"),
    ]
    axes = [
        ("exponent", rings["exponents"], "exponent of both forces"),
        ("strain_ahead", section["strains_ahead"], "compression ahead of the front"),
        ("impact_velocity", section["impact_velocities"], "relative velocity of an impact"),
    ]
    variables = {}
    for name, dims, estimates, meaning in measured:
        variables |= variable_and_errors(name, dims, estimates, ERROR_METHOD, meaning)
    coordinates = {
        name: (name, list(values), {"long_name": meaning}) for name, values, meaning in axes
    }
    return xr.Dataset(variables, {"gamma": gammas, "alpha": exponents, "t": times, **coordinates})


def press_chain(alpha, gamma, beads, times):
    """Return relative displacements, (times, beads − 1), of a chain pressed by 1 from t = 0 on."""
    law = kuwabara_kono(alpha, gamma)
    scene = pressed_chain(law, beads, times[-1], TOLERANCE, {"snapshots": times})
    motion = simulate_once(scene, f"pressed chain with alpha {alpha:g} and gamma {gamma:g}")
    return motion["relative_displacement"].values[:, :-1]


def oscillation_behind(profile):
    """Return the range of u over a part of the way of a wave behind its front, and its error."""
    way = last_fall(profile, np.arange(1.0, profile.size + 1.0), 0.5)
    part = profile[int(BEHIND.start * way) : int(BEHIND.stop * way)]
    found = estimate(np.ptp(part), np.ptp(part[::2]))
    # A range of u is no better known than u itself, which is about the tolerance of the chain.
    return Estimate(found.value, found.error + TOLERANCE[0] * float(np.abs(part).max()))


def wave_width(profile):
    """Return the distance from 90 to 10 per cent, in beads, and its error."""
    places = np.arange(1.0, profile.size + 1.0)
    return estimate(
        *(
            last_fall(profile[::stride], places[::stride], 0.1)
            - last_fall(profile[::stride], places[::stride], 0.9)
            for stride in (1, 2)
        )
    )


def collide(alpha, velocity):
    """Return time of contact and largest compression of an elastic collision, with errors."""
    scene = pressed_chain(
        kuwabara_kono(alpha, 0.0),
        2,
        10.0 * velocity ** ((1.0 - alpha) / (1.0 + alpha)),
        TOLERANCE,
        {"snapshots": [], "extremes": True},
        left=0.0,
        start=([0.0], [velocity, 0.0]),
    )
    motion = simulate_chain(scene, f"collision with velocity {velocity:g}")
    return tuple(
        recorded(motion[name]) for name in ("first_gap_time", "largest_relative_displacement")
    )


def ring_distance(alpha, rings):
    """Return the root mean square distance of u/δ to (41) at the slow time, and its error."""
    scales = make_slow_scales(alpha, rings["gamma"], 1.0)
    end = rings["slow_time"] / scales.slow_rate
    compared = compare_with_chain(
        {
            "law": {"alpha": alpha, "gamma": rings["gamma"]},
            "displacement": 1.0,
            "half_beads": round(rings["half_length"] / scales.epsilon + 0.5),
            "start": {"kind": "plateau", "half_width": rings["half_width"], "floor": 1.0e-7},
            "end_time": end,
            "tolerance": {"relative": 1.0e-10, "absolute": 1.0e-12},
            "equations": {"logarithmic": {"cells": 512, "tolerance": 1.0e-6}},
            "record": {"snapshots": [0.0, end], "grid": {"step": end / 4.0}},
        },
        f"ring with alpha {alpha:g}",
    )
    names = (f"relative_displacement_{kind}_logarithmic" for kind in ("rms", "floor"))
    return tuple(float(compared[name][-1]) for name in names)
