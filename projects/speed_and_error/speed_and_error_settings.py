"""Problems, and what solves each how accurately."""

from typing import Annotated, Literal

from pydantic import Field

from granular_fronts.scenes.parts import Distinct, Name, NotNegative, Part, Positive

ChainMethod = Literal[
    "strain_form",
    "scilab_ode",
    "scipy_dop853",
    "numbalsoda_dop853",
    "diffrax_dopri8",
    "lammps_nve",
    "lammps_mvv",
]
FrontMethod = Literal["profile", "shooting", "scipy_least_squares"]
RingMethod = Literal["upwind", "finite_volumes", "uniform_cells", "fourier"]
Fineness = Annotated[Distinct[Annotated[float, Field(gt=0, le=1e6)]], Field(min_length=1)]


class ChainProblem(Part):
    """A front starts: α = β = 3/2, N = 420, δ = 0.1, section 3.3."""

    kind: Literal["chain"]
    gamma: NotNegative = Field(description="Strength γ of the viscous force, with a stored state.")
    end_time: Positive = Field(description="Time t of the stored state.")
    methods: dict[ChainMethod, Fineness] = Field(
        description="Relative tolerances of each method, the absolute ones being a hundredth of "
        "them; of LAMMPS time steps."
    )


class FrontProblem(Part):
    """An exact front: α = β = 3/2, δ = c = 1, section 6."""

    kind: Literal["front"]
    gamma: Positive = Field(description="Strength γ of the viscous force, with a stored front.")
    methods: dict[FrontMethod, Fineness] = Field(description="Tolerances of each method.")


class RingProblem(Part):
    """The ring of figures 5 and 6 by the logarithmic Burgers equation, section 4.3."""

    kind: Literal["ring"]
    methods: dict[RingMethod, Fineness] = Field(
        description="Numbers of points or cells of each method; of fourier longest steps Δτ."
    )


class SpeedAndError(Part):
    """What is solved, and how often."""

    repeats: Annotated[int, Field(ge=1, le=1000)] = Field(
        description="How often each run is timed; the least time counts, and a run of seconds is "
        "not repeated."
    )
    tasks: Annotated[
        dict[
            Name,
            Annotated[ChainProblem | FrontProblem | RingProblem, Field(discriminator="kind")],
        ],
        Field(min_length=1, description="By name; a method that is not installed is left out."),
    ]
