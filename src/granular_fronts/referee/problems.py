r"""The problems: Hertz chains that a discrete-element code can compute, as scenes and in words.

Beads of mass 1 with the contact force :math:`u_+^{3/2} + \gamma\tfrac{d}{dt}u_+^\beta` just touch
at t = 0.  Either a constant force :math:`\delta^{3/2}` pushes bead 1 of a chain at rest, or bead 1
has the velocity :math:`\delta^{5/4}` of the beads behind such a front.  A damping γ̂ is given in
units of the front (29): :math:`\gamma = \hat\gamma\,\delta^{5/4-\beta}`.  Without damping all laws
are Hertz's.
"""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from pydantic import Field

from granular_fronts.model.scaling import Scaling
from granular_fronts.referee.lammps_deck import damping_model, force_on_first
from granular_fronts.referee.settings import Kind, Settings, read_settings
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.parts import Part, Several
from granular_fronts.scenes.sentences import read_part

ALPHA = 1.5

PRESSED = "a constant force of {force!r} pushes bead 1 towards bead 2 from t = 0 on"
STRUCK = "bead 1 has the velocity {velocity!r} towards its neighbour"
FALLING = "a constant force of {force!r}, its weight, pulls the bead towards the plate"
MOTIONS = {"front": PRESSED, "contact_loss": PRESSED, "striker": STRUCK, "collision": STRUCK}
MOTIONS |= {"solitary_wave": STRUCK, "plate": STRUCK, "drop": FALLING}
FALL = 10.0
"""Time after which a drop reaches the plate, with the velocity of a striker."""

CHAIN = "{beads} equal beads of mass 1 lie in a row, just touch, and are", "both ends are free"
PLATE = "A bead of mass 1 is {gap!r} away from a rigid plate and", "the plate does not move"

WORDS = """\
{title}

{place} at rest at t = 0; but
{moved}.
No other force acts, {ends}, and nothing rotates.

Two neighbours, a plate among them, that overlap by u > 0 repel each other with the force
    u^(3/2) + {gamma!r} * {beta:g} * u^({less:g}) * du/dt.
It is not cut off if it becomes attractive just before they part. It is zero without overlap.

Compute the motion up to t = {end_time:g}, with two steps or more. Write positions and
velocities at t = 0, {interval:g}, {twice:g}, ... as tables {name}_STEP.csv with the
columns t, bead, x, v, in all digits. Here x is the displacement from where beads just touch.
Or let a code do so by its deck. Then run
    granular-fronts-referee judge {name}_*.csv
or compare with states.csv: u over {displacement!r} and v over {velocity!r} are off by no more
than tolerances.csv says under "states", in the row of the scheme and the step.
"""

SI_BEADS, SI_VELOCITY = "steel 20 mm", 0.5
"""Beads in whose units a case is given too, and the velocity δ^(5/4) of the beads in m/s."""


class Problem(Part):
    """A motion to compute."""

    name: str = Field(description="Its motion, damping and law.")
    motion: str = Field(description="One of `MOTIONS`.")
    scene: Chain = Field(description="The chain.")
    displacement: float = Field(description="Relative displacement δ.")
    interval: float = Field(description="Time between two states that are compared.")
    factors: Several[float] = Field(
        description="Dampings over γ at which `measurements` are computed."
    )

    @property
    def title(self) -> str:
        """Name and law in one line."""
        law = self.scene.law
        return f"{self.name}: alpha = 3/2, beta = {law.beta:g}, gamma = {law.gamma:.6g}"

    @property
    def moved(self) -> str:
        """What moves the beads, in words and numbers."""
        return MOTIONS[self.motion].format(force=self.force, velocity=self.front_velocity)

    @property
    def front_velocity(self) -> float:
        """Velocity δ^((α + 1)/2) of the beads behind a front, and of a bead that strikes."""
        return self.displacement ** (0.5 * (ALPHA + 1.0))

    @property
    def wall(self) -> bool:
        """Whether the last bead hits a plate."""
        return self.scene.boundary.kind == "wall"

    @property
    def force(self) -> float:
        """Constant force on bead 1: the pressure, or the weight of a single bead."""
        return force_on_first(self.scene)

    @property
    def start(self) -> tuple[np.ndarray, np.ndarray]:
        """Displacements at t = 0 from where the beads just touch, and velocities."""
        start = self.scene.start
        u = np.array([*start.relative_displacement, 0.0][: self.scene.beads.count])
        return np.cumsum(u[::-1])[::-1], np.array(start.velocity)

    def relative_displacements(self, x: np.ndarray) -> np.ndarray:
        """Return u of all contacts, that with a plate the last, on the last axis as x."""
        return -np.diff(x, append=0.0) if self.wall else -np.diff(x)

    @property
    def collision_time(self) -> float:
        """Time of a collision without damping at this velocity, of two beads or with the plate."""
        # The reduced mass is that of a bead in front of a plate, and half of it between two.
        mass = 2.0 if self.wall else 1.0
        time = collision_time(ALPHA) * mass ** (1.0 / (ALPHA + 1.0))
        return time * self.displacement ** (0.5 * (1.0 - ALPHA))


def collision_time(alpha: float) -> float:
    r"""Return the time that two beads without damping, meeting at the velocity 1, stay together.

    .. math::

        t_c = 2\Bigl(\frac{\alpha+1}4\Bigr)^{1/(\alpha+1)}
        \int_0^1 \frac{ds}{\sqrt{1-s^{\alpha+1}}}.
    """
    power = 1.0 / (alpha + 1.0)
    integral = math.sqrt(math.pi) * math.gamma(1.0 + power) / math.gamma(0.5 + power)
    return 2.0 * (0.25 * (alpha + 1.0)) ** power * integral


def load_problems(settings: Mapping[str, Any] | Settings | None = None) -> dict[str, Problem]:
    """Return all problems by their names, those of problems.yaml or of other settings.

    An InputError says in a sentence what is wrong, such as a law that LAMMPS does not have.
    """
    settings = read_settings() if settings is None else read_part(Settings, settings)
    return {
        name: Problem(
            name=name,
            motion=motion,
            scene=_scene_of(name, motion, settings.laws.get(law, ALPHA), damping, settings),
            displacement=settings.displacement,
            interval=settings.interval,
            factors=settings.factors,
        )
        for name, (motion, damping, law) in settings.combinations().items()
    }


def _scene_of(name: str, motion: Kind, beta: float, damping: str, settings: Settings) -> Chain:
    """Return the chain of one problem, whose law LAMMPS has."""
    delta, beads = settings.displacement, settings.motions[motion].beads
    pressed, at_plate = MOTIONS[motion] == PRESSED, motion in ("plate", "drop")
    gamma = settings.dampings[damping] * delta ** (0.5 * (ALPHA + 1.0) - beta)
    velocity = delta ** (0.5 * (ALPHA + 1.0))
    struck = velocity if MOTIONS[motion] == STRUCK else 0.0
    gap = 0.5 * FALL * velocity if motion == "drop" else 0.0
    chain = {"kind": "pressure", "left": delta if pressed else 0.0, "right": 0.0}
    scene = {
        "law": {"alpha": ALPHA, "beta": beta, "gamma": gamma},
        "beads": beads,
        "boundary": {"kind": "wall"} if at_plate else chain,
        "gravity": velocity / FALL if motion == "drop" else 0.0,
        "start": {
            "kind": "given",
            "relative_displacement": [-gap] if at_plate else [0.0] * (beads - 1),
            "velocity": [struck, *[0.0] * (beads - 1)],
        },
        "end_time": settings.motions[motion].end_time,
        "tolerance": settings.tolerance,
        "record": {"snapshots": [], "grid": {"step": settings.interval}, "extremes": True},
    }
    made = read_part(Chain, scene, f"Problem {name}: ")
    damping_model(made)
    return made


def in_words(problem: Problem) -> str:
    """Return a problem in plain words and numbers, for any code."""
    scene, law = problem.scene, problem.scene.law
    place, ends = PLATE if problem.wall else CHAIN
    return WORDS.format(
        title=problem.title,
        name=problem.name,
        place=place.format(beads=scene.beads.count, gap=-float(problem.start[0][-1])),
        ends=ends,
        moved=problem.moved,
        beta=law.beta,
        gamma=law.gamma,
        less=law.beta - 1.0,
        end_time=scene.end_time,
        interval=problem.interval,
        twice=2.0 * problem.interval,
        displacement=problem.displacement,
        velocity=problem.front_velocity,
    )


def described(problem: Problem) -> dict[str, Any]:
    """Return a problem in numbers, those of a chain with m = k = 1 and those in SI units."""
    scene, law = problem.scene, problem.scene.law
    unit = Scaling.of_spheres(SI_BEADS, SI_VELOCITY / problem.front_velocity, damping=1.0)
    unit = replace(unit, beta=law.beta)
    kinds = {
        "displacement": ("displacement", problem.displacement),
        "velocity": ("velocity", problem.front_velocity),
        "collision_time": ("time", problem.collision_time),
        "end_time": ("time", scene.end_time),
        "interval": ("time", problem.interval),
        "force_on_bead_1": ("force", problem.force),
        "gap": ("displacement", -float(problem.start[0][-1])),
        "velocity_of_bead_1": ("velocity", scene.start.velocity[0]),
    }
    plain = {"mass": 1.0, "stiffness": 1.0, "damping": law.gamma}
    si = {"mass": unit.mass, "stiffness": unit.stiffness, "damping": law.gamma / unit.gamma}
    return {
        "case": problem.name,
        "beads": scene.beads.count,
        "alpha": ALPHA,
        "beta": law.beta,
        "force_of_contact": "stiffness * (u^alpha + damping * d/dt u^beta)",
        "dimensionless": plain | {name: value for name, (_, value) in kinds.items()},
        f"si_of_{SI_BEADS.replace(' ', '_')}": si
        | {name: unit.to_physical(value, kind) for name, (kind, value) in kinds.items()},
    }
