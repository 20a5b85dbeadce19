r"""What a compiled chain works on: one table of rows, and a record of all else.

Table.  Every row holds one number for each contact; entry n = 0 … N + 1 is the bead number.

========== ===========================================================================
row        entry n
========== ===========================================================================
`U`, `D`   state at the start of the step
`NEW_U` …  state at its end
`PARTIAL`  part of a stage's u_n, where elastic and viscous slopes are summed apart
`VALUE`    u_n of a stage
`FORCE`    elastic force F(u_n) of the last stage; held forces at the ends stay in place
`DAMPING`  viscous function G(u_n) of the last stage, if it has slopes of its own
`STIFFNESS`, `VISCOSITY` factors κ_n and χ_n of the forces of a contact, read if the chain is varied
`MOBILITY` inverse mass 1/m_n, read if the chain is varied
`SLOPES`   sixteen rows, Δ_d F of every stage in its slot (`numerics.runge_kutta`)
`DAMPING_SLOPES` sixteen more, Δ_d G, if it has slopes of its own
========== ===========================================================================

Law.  The engine knows a law by addresses of compiled loops over rows (`model.passes`) and by the
compressions at which it is declared not smooth.  Where the viscous potential is proportional to the
elastic one, :math:`G = \gamma F` needs no slopes of its own: the law is *single*.
"""

import math

import numpy as np

from granular_fronts.numerics.records import record_type
from granular_fronts.numerics.runge_kutta import LONG, SLOPES, STAGES

# As numpy integers, so that kernels are compiled once and not for each row.
U, D, NEW_U, NEW_D, PARTIAL, VALUE, FORCE, DAMPING, STIFFNESS, VISCOSITY, MOBILITY = np.arange(11)
ELASTIC_SLOPES = np.int64(11)
VISCOUS_SLOPES = ELASTIC_SLOPES + SLOPES
ROWS_OF_SINGLE, ROWS_OF_PAIR = VISCOUS_SLOPES, VISCOUS_SLOPES + SLOPES

MOST_PARAMETERS, MOST_KINKS = 8, 8

LAW = record_type(
    ("elastic", np.int64),
    ("viscous", np.int64),
    ("stage_pass", np.int64),
    ("elastic_parameters", float, MOST_PARAMETERS),
    ("viscous_parameters", float, MOST_PARAMETERS),
    ("single", np.bool),
    ("gamma", float),
    ("kinks", float, MOST_KINKS),
    ("kink_count", np.int64),
    ("has_stiff_kinks", np.bool),
    ("attraction", float),
)
"""A law as the kernels know it.  Addresses of the row maps F and G, and of the loop that sums
slopes and takes F at once (0 without one); their parameters.  Whether G = γF, and γ (if not, 1, the
factor of the viscous slopes).  Compressions at which F or G is not smooth, and whether F' is
infinite there, so that no contact may pass.  1 if the law acts in extension too, else 0."""

CLOCK = record_type(
    *[(name, float) for name in ("t", "h", "drive", "w_1", "power", "dissipated")],
    *[(name, np.int64) for name in ("reach", "accepted", "rejected", "cut", "right_hand_sides")],
)
"""Time and next step.  Drive at the last stage, and w_1 at t, if something drives the chain.  Power
dissipated at t less the power of the drive, and the energy of both since t = 0.  Last bead of the
active window; steps accepted, rejected and cut at contacts; right-hand sides."""

DRIVE = record_type(
    *[(name, float) for name in ("start", "constant", "rate", "amplitude", "frequency", "phase")]
)
"""A piece of a drive (`drives`)."""

CHAIN = record_type(
    ("law", LAW),
    ("clock", CLOCK),
    ("drive", DRIVE),
    ("beads", np.int64),
    ("contacts", np.int64),
    ("ring", np.bool),
    ("varied", np.bool),
    ("driven", np.bool),
    ("piston", float),
    ("gravity", float),
    ("ahead", float),
    ("margin", np.int64),
    ("elastic_weights", float, (STAGES, LONG)),
    ("viscous_weights", float, (STAGES, LONG)),
    ("probe", float, 3),
)
"""Law and clock.  Present piece of the force on bead 1, or of the acceleration of a piston.  Number
N of beads and of contacts that move, N − 1, or N on a ring and before a wall.  Whether it is a
ring, whether masses or contacts differ, and whether something drives the left end.  Mass of bead 1
if it is a piston, else 0; body force over mass.  Compression ahead of the active window, and how
many beads the window reaches beyond the last one that moves.  Weights of the slopes in every stage
of the present step.  Room for the law at a single compression.
"""


def make_table(rows, beads):
    """Return a table of zeros for a chain of `beads` beads.

    Rows are whole cache lines long, and column 1, the first bead, starts one.  The length is no
    multiple of 4096 bytes, which would make rows collide in the cache.
    """
    columns = 8 * math.ceil((beads + 2) / 8)
    columns += 8 if columns % 512 == 0 else 0
    buffer = np.zeros(rows * columns + 8)
    offset = (-(buffer.ctypes.data // 8 + 1)) % 8
    return buffer[offset : offset + rows * columns].reshape(rows, columns)
