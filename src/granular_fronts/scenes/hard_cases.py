"""The section ``hard_cases``: problems at the edge of what the solvers can do."""

from typing import Literal

from granular_fronts.scenes.parts import Listed

HardCases = Listed[
    Literal[
        "gamma_zero",
        "gamma_1e_6",
        "gamma_1e_3",
        "gamma_5",
        "gamma_50",
        "alpha_1_001",
        "alpha_1_02",
        "alpha_3",
        "alpha_5",
        "alpha_10",
        "beta_1",
        "beta_alpha_plus_1",
        "delta_1e_8",
        "delta_1e8",
        "precompression_1e_12",
        "colliding_fronts",
        "many_beads",
        "many_contact_losses",
        "bouncing_bead",
        "free_flight",
        "energy_of_openings",
        "elastic_collision",
        "dashpot_collision",
        "mu_below_2",
        "mu_above_2",
        "floor_1e_300",
        "true_zeros",
        "front_double_root",
        "front_triple_root",
        "front_crossing",
        "front_gamma_0_01",
        "front_gamma_20",
        "front_alpha_1_02",
        "front_alpha_5",
        "front_dashpot",
    ]
]
"""Names of some of the cases."""
