"""The section ``precision``: problems whose solvers are compared by speed and error."""

from typing import Annotated, Literal

from pydantic import Field

from granular_fronts.scenes.parts import Distinct, Listed, Named, NotNegative, Part, Positive

ChainMethod = Literal[
    "strain_form",
    "positions_and_w",
    "positions_and_velocities",
    "scilab_ode",
    "scipy_dop853",
    "numbalsoda_dop853",
    "diffrax_dopri8",
    "lammps_nve",
    "lammps_mvv",
]
FrontMethod = Literal[
    "profile",
    "profile_on_grid",
    "shooting",
    "scipy_least_squares",
    "scipy_root_hybr",
    "scipy_newton_krylov",
]

Tolerances = Annotated[
    Distinct[Annotated[float, Field(gt=0, le=1)]],
    Field(min_length=1, description="Tolerances in any order."),
]
Repeats = Annotated[int, Field(ge=1, le=1000)]
Points = Annotated[int, Field(ge=3, le=1_000_000)]
Cells = Annotated[int, Field(ge=7, le=1_000_000)]
EvenPoints = Annotated[int, Field(ge=8, multiple_of=2, le=1_000_000)]
Step = Annotated[float, Field(ge=1e-6)]

REPEATS = (
    "How often each run is timed; the least time counts, and a run of seconds is not repeated."
)


class ChainProblem(Part):
    """One front initiation with a stored long-double state at its end, and what solves it."""

    gamma: NotNegative = Field(
        description="Strength γ of the viscous force; one with a stored state."
    )
    end_time: Annotated[float, Field(gt=0, le=10_000)] = Field(
        description="Time t of the stored state."
    )
    tolerances: Tolerances = Field(
        description="Relative tolerances asked of each method; the absolute ones are "
        "a hundredth of them."
    )
    own_tolerances: dict[ChainMethod, Tolerances] = Field(
        {},
        description="Tolerances of methods by name, instead of those of the problem; for LAMMPS "
        "they are steps.",
    )
    repeats: Repeats = Field(description=REPEATS)
    methods: Listed[ChainMethod] = Field(
        description="Integrators to compare; one that is not installed is named and left out."
    )


class FrontProblem(Part):
    """One front with a stored long-double solution, and what solves it."""

    gamma: Positive = Field(description="Strength γ of the viscous force; one with a stored front.")
    tolerances: Tolerances = Field(description="Tolerances asked of each method.")
    own_tolerances: dict[FrontMethod, Tolerances] = Field(
        {},
        description="Tolerances of methods by name, instead of those of the problem; for "
        "profile_on_grid they are spacings.",
    )
    repeats: Repeats = Field(description=REPEATS)
    methods: Listed[FrontMethod] = Field(description="Methods to compare.")


class Reference(Part):
    """Finite volumes that errors are measured against, and the Fourier method that checks them."""

    cells: Cells = Field(description="Number of finite volumes.")
    tolerance: Annotated[float, Field(ge=1e-13, le=0.1)] = Field(
        description="Error of the finite volumes per step."
    )
    points: EvenPoints = Field(description="Number of points of the Fourier method, even.")
    longest_step: Step = Field(description="Longest step Δτ of the Fourier method.")


class LogBurgersProblem(Part):
    """The grids and steps on which one ring is solved, and the reference."""

    reference: Reference
    upwind_points: Listed[Points] = Field(
        description="Numbers of points of the paper's explicit scheme, increasing; the paper takes "
        "10⁴."
    )
    cells: Listed[Cells] = Field(description="Numbers of finite volumes, increasing.")
    longest_steps: Listed[Step] = Field(
        description="Longest steps Δτ of the Fourier method, decreasing; their fourth power is the "
        "error per step."
    )
    repeats: Repeats = Field(
        description="How often all runs take their turn; the least time counts."
    )
    milliseconds: Positive = Field(
        description="Time in milliseconds (SI) within which an error of 1e-5 is asked for."
    )


class Precision(Part):
    """Speed against error, measured by the target precision, for each family of problems."""

    log_burgers: Named[LogBurgersProblem] = Field(
        description="Rings of section 4.3 solved by the logarithmic Burgers equation; the key "
        "names a periodic scene."
    )
    chain: Named[ChainProblem] = Field(
        description="Front initiations with α = β = 3/2, N = 420, δ = 0.1, section 3.3; the key "
        "names the problem."
    )
    fronts: Named[FrontProblem] = Field(
        description="Exact fronts of the lattice with α = β = 3/2, δ = c = 1, section 6; the key "
        "names the problem."
    )
