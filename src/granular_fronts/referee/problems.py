r"""The problems: Hertz chains that a discrete-element code can compute, as scenes and in words.

Beads of mass 1 with the contact force :math:`u_+^{3/2} + \gamma\tfrac{d}{dt}u_+^\beta` just touch
at t = 0.  Either a constant force :math:`\delta^{3/2}` pushes bead 1 of a chain at rest, or bead 1
has the velocity :math:`\delta^{5/4}` of the beads behind such a front.  A damping γ̂ is given in
units of the front (29): :math:`\gamma = \hat\gamma\,\delta^{5/4-\beta}`.  Without damping all laws
are Hertz's.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

from granular_fronts.errors import InputError
from granular_fronts.referee.lammps_deck import damping_model
from granular_fronts.scenes.memory import Held, memory_problems
from granular_fronts.scenes.parts import name_entry
from granular_fronts.scenes.schema import violations
from granular_fronts.scenes.yaml_files import read_yaml

ALPHA = 1.5
APART = 5  # contacts on both sides between which a pulse is timed

PRESSED = "a constant force of {force!r} pushes bead 1 towards bead 2 from t = 0 on"
STRUCK = "bead 1 has the velocity {velocity!r} towards bead 2"
MOTIONS = {"front": PRESSED, "contact_loss": PRESSED, "striker": STRUCK, "collision": STRUCK}
MOTIONS |= {"solitary_wave": STRUCK}

SAME = 1.0e-9  # relative distance of a quotient from a whole number that counts as none
NUMBERS_OF_A_BEAD = 4  # of each state: u and ẋ, of the solution and of its refinement

WORDS = """\
{title}

{beads} equal beads of mass 1 lie in a row, just touch, and are at rest at t = 0; but
{moved}.
No other force acts, both ends are free, and nothing rotates.

Two neighbours that overlap by u > 0 repel each other with the force
    u^(3/2) + {gamma!r} * {beta:g} * u^({less:g}) * du/dt.
It is not cut off if it becomes attractive just before they part. It is zero without overlap.

Compute the motion up to t = {end_time:g}, with two steps or more. Write positions and
velocities at t = 0, {interval:g}, {twice:g}, ... as tables {name}_STEP.csv with the
columns t, bead, x, v, in all digits. Here x is the displacement from the start. Or let
LAMMPS do so by {name}.lmp. Then run
    python -m granular_fronts.referee {name}_*.csv --answers FOLDER_OF_THIS_FILE
"""


class Problem(NamedTuple):
    """A motion to compute.

    `motion` is one of `MOTIONS`, `scene` is as `simulate_chain` takes it, `displacement` is δ, and
    `interval` is the time between two states that are compared.  `factors` are the dampings over γ
    at which `measurements` are computed.
    """

    name: str
    motion: str
    scene: dict[str, Any]
    displacement: float
    interval: float
    factors: list[float]

    @property
    def title(self) -> str:
        """Name and law in one line."""
        law = self.scene["law"]
        return f"{self.name}: alpha = 3/2, beta = {law['beta']:g}, gamma = {law['gamma']:.6g}"


def load_problems(settings: Mapping[str, Any]) -> dict[str, Problem]:
    """Return all problems of the section ``referee`` of config/referee.yaml, by their names.

    An InputError says in a sentence what is wrong, such as a law that LAMMPS does not have.
    """
    _check_settings(settings)
    found: dict[str, Problem] = {}
    for motion, chain in settings["motions"].items():
        for damping in chain["dampings"]:
            laws = settings["laws"] if settings["dampings"][damping] else {"hertz": ALPHA}
            for law, beta in laws.items():
                name = f"{motion}_{damping}_{law}"
                scene = _scene_of(motion, chain, beta, settings["dampings"][damping], settings)
                _check_problem(name, scene, found)
                found[name] = Problem(
                    name,
                    motion,
                    scene,
                    settings["displacement"],
                    settings["interval"],
                    settings["factors"],
                )
    return found


def _check_problem(name: str, scene: Mapping[str, Any], others: Collection[str]) -> None:
    try:
        damping_model(scene["law"])
    except InputError as error:
        raise InputError(f"config/referee.yaml: problem {name}: {error}") from None
    if name in others:
        raise InputError(
            f"config/referee.yaml: two problems are called {name}: rename a damping or a law."
        )


def _scene_of(
    motion: str,
    chain: Mapping[str, Any],
    beta: float,
    damping: float,
    settings: Mapping[str, Any],
) -> dict[str, Any]:
    """Return one problem as `simulate_chain` takes it."""
    delta, beads = settings["displacement"], chain["beads"]
    pressed = motion in ("front", "contact_loss")
    velocity = [0.0 if pressed else delta ** (0.5 * (ALPHA + 1.0)), *[0.0] * (beads - 1)]
    gamma = damping * delta ** (0.5 * (ALPHA + 1.0) - beta)
    return {
        "law": {"alpha": ALPHA, "beta": beta, "gamma": gamma},
        "beads": beads,
        "boundary": {"kind": "pressure", "left": delta if pressed else 0.0, "right": 0.0},
        "start": {
            "kind": "given",
            "relative_displacement": [0.0] * (beads - 1),
            "velocity": velocity,
        },
        "end_time": chain["end_time"],
        "tolerance": settings["tolerance"],
        "record": {"snapshots": [], "grid": {"step": settings["interval"]}, "extremes": True},
    }


def in_words(problem: Problem) -> str:
    """Return a problem in plain words and numbers, for any code."""
    scene, delta = problem.scene, problem.displacement
    law = scene["law"]
    velocity = scene["start"]["velocity"][0]
    moved = MOTIONS[problem.motion].format(force=delta**ALPHA, velocity=velocity)
    return WORDS.format(
        title=problem.title,
        name=problem.name,
        beads=scene["beads"],
        moved=moved,
        beta=law["beta"],
        gamma=law["gamma"],
        less=law["beta"] - 1.0,
        end_time=scene["end_time"],
        interval=problem.interval,
        twice=2.0 * problem.interval,
    )


# What config/referee.yaml asks for. Its schema says which keys there are; what ties two keys
# together is checked here.


def read_settings(file: Path | str) -> dict[str, Any]:
    """Return the section ``referee`` of a file, as `load_problems` takes it.

    An InputError has a sentence for each thing that is wrong in its YAML, keys and values.
    """
    given = read_yaml(file)
    _raise_if_any(violations(given, schema="referee"))
    return given["referee"]


def _check_settings(settings: Mapping[str, Any]) -> None:
    _raise_if_any(violations(settings, definition="settings", schema="referee"))
    _raise_if_any([*_factor_errors(settings["factors"]), *_motion_errors(settings)])


def _raise_if_any(sentences: Iterable[str]) -> None:
    errors = [f"config/referee.yaml: {sentence}" for sentence in sentences]
    if errors:
        raise InputError("\n".join(errors))


def _factor_errors(factors: list[float]) -> Iterator[str]:
    """A damping is read off a table that increases and holds the problem's own."""
    for place, (before, factor) in enumerate(pairwise(factors), 1):
        if factor <= before:
            yield (
                f"{name_entry('factors', place)} is {factor}, not above {before} before it: list "
                "them in increasing order."
            )
    if 1 not in factors:
        yield "factors does not hold 1, the damping of the problem itself: add 1."


def _motion_errors(settings: Mapping[str, Any]) -> Iterator[str]:
    """Motions have known dampings, end at a state, collide in pairs, and fit into memory."""
    for motion, chain in settings["motions"].items():
        for damping in chain["dampings"]:
            if damping not in settings["dampings"]:
                yield (
                    f"motions.{motion}.dampings names {damping!r}, which is unknown: choose from "
                    f"{', '.join(settings['dampings'])}."
                )
        intervals = chain["end_time"] / settings["interval"]
        if abs(intervals - round(intervals)) > SAME * intervals:
            yield (
                f"motions.{motion}.end_time is {chain['end_time']}, no multiple of interval "
                f"{settings['interval']}, so that no state is compared at the end: change one."
            )
        if motion == "collision" and chain["beads"] != 2:
            yield f"motions.collision.beads is {chain['beads']}, but two beads collide: write 2."
        if motion == "solitary_wave" and chain["beads"] < (least := 2 * APART + 2):
            yield (
                f"motions.solitary_wave.beads is {chain['beads']}, too few to time a pulse: write "
                f"{least} or more."
            )
        states = NUMBERS_OF_A_BEAD * chain["beads"] * intervals
        asked = {f"motions.{motion}.{key}": chain[key] for key in ("beads", "end_time")}
        yield from memory_problems([Held(asked | {"interval": settings["interval"]}, states)])
