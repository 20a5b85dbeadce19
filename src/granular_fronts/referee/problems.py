r"""The problems: Hertz chains that a discrete-element code can compute, as scenes and in words.

Beads of mass 1 with the contact force :math:`u_+^{3/2} + \gamma\tfrac{d}{dt}u_+^\beta` just touch
at t = 0.  Either a constant force :math:`\delta^{3/2}` pushes bead 1 of a chain at rest, or bead 1
has the velocity :math:`\delta^{5/4}` of the beads behind such a front.  A damping γ̂ is given in
units of the front (29): :math:`\gamma = \hat\gamma\,\delta^{5/4-\beta}`.
"""

from collections.abc import Collection, Mapping
from typing import Any, NamedTuple

from granular_fronts.errors import InputError
from granular_fronts.referee.lammps_deck import damping_model
from granular_fronts.referee.settings import check_settings

ALPHA = 1.5

PRESSED = "a constant force of {force!r} pushes bead 1 towards bead 2 from t = 0 on"
STRUCK = "bead 1 has the velocity {velocity!r} towards bead 2"
MOTIONS = {"front": PRESSED, "contact_loss": PRESSED, "striker": STRUCK, "collision": STRUCK}
"""What moves the beads, in words."""

WORDS = """\
{title}

{beads} equal beads of mass 1 lie in a row, just touch, and are at rest at t = 0; but
{moved}.
No other force acts, both ends are free, and nothing rotates.

Two neighbours that overlap by u > 0 repel each other with the force
    u^(3/2) + {gamma!r} * {beta:g} * u^({less:g}) * du/dt,
which becomes attractive just before they part and is not cut off there; without overlap it is zero.

Compute the motion up to t = {end_time:g}, with two steps or more, and write positions and
velocities at t = 0, {interval:g}, {twice:g}, ... as tables {name}_STEP.csv with the
columns t, bead, x, v, where x is the displacement from the start. Or let LAMMPS do so by
{name}.lmp. Then run
    python -m granular_fronts.referee {name}_*.csv --answers FOLDER_OF_THIS_FILE
"""


class Problem(NamedTuple):
    """A motion to compute.

    Attributes
    ----------
    name, motion : str
        `motion` is one of `MOTIONS`.
    scene : dict
        As `simulate_chain` takes it.
    displacement, interval : float
        δ, and the time between two states that are compared.
    factors : list of float
        Dampings over γ at which a reading of the damping is made.
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
    """State all problems of the section ``referee`` of config/referee.yaml.

    Parameters
    ----------
    settings : mapping
        The section.

    Returns
    -------
    dict of str to Problem
        By their names.

    Raises
    ------
    InputError
        With a sentence for what is wrong, a law that LAMMPS does not have included.
    """
    check_settings(settings)
    found: dict[str, Problem] = {}
    for motion, chain in settings["motions"].items():
        for damping in chain["dampings"]:
            for law, beta in settings["laws"].items():
                name = f"{motion}_{damping}_{law}"
                scene = scene_of(motion, chain, beta, settings["dampings"][damping], settings)
                check_problem(name, scene, found)
                found[name] = Problem(
                    name,
                    motion,
                    scene,
                    settings["displacement"],
                    settings["interval"],
                    settings["factors"],
                )
    return found


def check_problem(name: str, scene: Mapping[str, Any], others: Collection[str]) -> None:
    """Check that LAMMPS has the law of a problem, and that its name is its own."""
    try:
        damping_model(scene["law"])
    except InputError as error:
        raise InputError(f"config/referee.yaml: problem {name}: {error}") from None
    if name in others:
        raise InputError(
            f"config/referee.yaml: two problems are called {name}: rename a damping or a law."
        )


def scene_of(
    motion: str,
    chain: Mapping[str, Any],
    beta: float,
    damping: float,
    settings: Mapping[str, Any],
) -> dict[str, Any]:
    """One problem as `simulate_chain` takes it."""
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
    """A problem in plain words and numbers, for any code."""
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
