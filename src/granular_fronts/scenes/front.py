"""Scenes of the family ``front``: an exact front and what approximates it, section 6."""

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from granular_fronts.model.amplitude_scaling import SlowScales
from granular_fronts.model.laws import make_law
from granular_fronts.scenes.laws import LawOfOneExponent, decades, energy_problems
from granular_fronts.scenes.memory import COLUMNS_PER_ROW, NUMBERS_PER_BEAD, Held, memory_problems
from granular_fronts.scenes.parts import Positive, Range, Whole
from granular_fronts.scenes.sentences import Scene


class Window(Range):
    """Range of ξ = n − ct that is kept, with u(0) = δ/2."""

    start: Annotated[float, Field(lt=0)] = Field(description="First ξ, behind the front.")
    stop: Positive = Field(description="Last ξ, ahead of the front.")
    step: Positive = Field(description="Distance of two ξ.")


class Front(Scene):
    """One exact front, by shooting and by its profile equation, with a driven chain beside it.

    Its arguments are the keys of a scene in the configuration; the page of the manual on these has
    the range of each.  An InputError says all that is wrong.

    Examples
    --------
    >>> front = gf.Front(
    ...     law={"alpha": 1.5, "gamma": 0.06},
    ...     displacement=0.1,
    ...     window={"start": -40.0, "stop": 5.0, "step": 0.02},
    ...     driven_bead=400,
    ... )
    >>> round(front.normalised_damping, 6)
    0.03374
    """

    law: LawOfOneExponent
    displacement: Positive = Field(
        description="Relative displacement δ behind the front, which with γ gives the γc of the "
        "frame δ = c = 1, equation (30)."
    )
    window: Window
    driven_bead: Annotated[Whole, Field(ge=10)] = Field(
        description="Bead at which a front driven by pressure is looked at; the farther, the less "
        "of its start is left."
    )

    @property
    def normalised_damping(self) -> float:
        """Damping γc in the frame δ = c = 1, James (2021), eq. (30)."""
        return self.law.gamma * SlowScales(self.law.alpha, self.law.gamma, self.displacement).speed

    def held(self) -> Iterator[Held]:
        """Numbers that the fronts and the chain hold at once, at least."""
        window = self.window
        asked = {"window.stop": window.stop, "window.step": window.step}
        yield Held(asked, 6.0 * COLUMNS_PER_ROW * window.points)
        yield Held({"driven_bead": self.driven_bead}, NUMBERS_PER_BEAD * float(self.driven_bead))

    def problems(self) -> Iterator[str]:
        """Energies are numbers that a computer can hold, and so is the whole."""
        law = make_law(alpha=self.law.alpha, gamma=self.law.gamma)
        yield from (
            [*energy_problems(law, decades(self.displacement))] or memory_problems(self.held())
        )
