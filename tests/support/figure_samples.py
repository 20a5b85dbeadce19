"""A dataset for each figure with values that are all different.

A figure computes nothing, so any numbers do: every variable is filled with random numbers of its
own, and what is drawn can be traced to one variable only.
"""

import json
import zlib

import numpy as np
import xarray as xr

FIELDS = ("relative_displacement", "velocity")
EQUATIONS = ("logarithmic", "unlimited")
CONTINUUM = ("logarithmic", "unlimited", "heteroclinic")
XI = {"xi": np.linspace(-6.0, 4.0, 21)}


def sample(coordinates, variables, config=None, **attributes):
    """A dataset of positive numbers below 1, other ones for each variable of each dataset."""
    sizes = {name: len(values) for name, values in coordinates.items()}

    def values(name, dimensions):
        seed = repr((name, sizes, config, attributes))
        generator = np.random.default_rng(zlib.crc32(seed.encode()))
        return generator.uniform(0.1, 0.9, [len(coordinates[each]) for each in dimensions])

    return xr.Dataset(
        {name: (dimensions, values(name, dimensions)) for name, dimensions in variables.items()},
        coordinates,
        attributes | {"config": json.dumps(config)},
    )


def driven_chain(*variables, gamma=0.06):
    """A chain driven by δ = 0.1 with a snapshot, a grid, and two sets of probes."""
    coordinates = {
        "t": [20.0],
        "bead": np.arange(1, 13),
        "t_grid": np.arange(8.0),
        "t_steady": np.linspace(5.0, 30.0, 26),
        "bead_steady": [6, 9, 12],
        "t_transient": np.linspace(0.0, 10.0, 11),
        "bead_transient": [1, 3],
    }
    dimensions = {
        "velocity": ["t", "bead"],
        "relative_displacement_grid": ["t_grid", "bead"],
        "velocity_grid": ["t_grid", "bead"],
        "relative_displacement_steady": ["t_steady", "bead_steady"],
        "relative_displacement_transient": ["t_transient", "bead_transient"],
    }
    config = {"boundary": {"left": 0.1}, "law": {"gamma": gamma}}
    return sample(coordinates, {name: dimensions[name] for name in variables}, config)


def ring(alpha, times=(0.0, 15.0, 30.0), *, equation=False):
    """A ring at some times, and the logarithmic Burgers equation where it is asked for."""
    coordinates = {"t": list(times), "bead": np.arange(1, 10), "site": np.arange(1.0, 10.0, 0.5)}
    variables = {field: ["t", "bead"] for field in FIELDS}
    if equation:
        variables |= {f"{field}_logarithmic": ["t", "site"] for field in FIELDS}
    return sample(coordinates, variables, {"law": {"alpha": alpha}})


def ring_distances(alpha):
    """Distances of a ring to both equations, and the errors of the solvers, over time."""
    variables = {
        f"{field}_{kind}_{equation}": ["t_grid"]
        for field in FIELDS
        for kind in ("sup", "rms", "floor")
        for equation in EQUATIONS
    }
    return sample({"t_grid": np.arange(7.0)}, variables, {"law": {"alpha": alpha}})


def log_burgers_fronts():
    """Fluxes over y and fronts over ξ, for two exponents and in the limit."""
    variables = {
        "flux": ["alpha", "force"],
        "compression": ["alpha", "force"],
        "front": ["alpha", "xi"],
        "flux_limit": ["force"],
        "front_limit": ["xi"],
    }
    return sample({"alpha": [1.5, 1.1], "force": np.linspace(0.0, 1.0, 11), **XI}, variables)


def heteroclinic():
    """Three fronts, the double well, and a phase portrait of two trajectories."""
    coordinates = {
        "mu": [0.3, 1.0, 2.0],
        "s": np.linspace(-5.0, 5.0, 11),
        "y": np.linspace(-1.5, 1.5, 13),
        "trajectory": [0, 1],
        "s_portrait": np.linspace(-3.0, 3.0, 13),
    }
    variables = {
        "rescaled_force": ["mu", "s"],
        "slope": ["mu", "s"],
        "potential": ["y"],
        "rescaled_force_portrait": ["trajectory", "s_portrait"],
        "slope_portrait": ["trajectory", "s_portrait"],
    }
    return sample(coordinates, variables, portrait_mu=0.3)


def front_by_two_methods(gamma):
    """A front by the profile equation and by shooting, with both residual histories."""
    coordinates = {
        **XI,
        "xi_shooting": np.arange(-3.0, 3.0, 0.25),
        "iteration_profile": np.arange(5),
        "iteration_shooting": np.arange(4),
    }
    variables = {
        "relative_displacement": ["xi"],
        "relative_displacement_shooting": ["xi_shooting"],
        "residual_history_profile": ["iteration_profile"],
        "residual_history_shooting": ["iteration_shooting"],
    }
    variables |= {f"{field}_difference": ["xi_shooting"] for field in FIELDS}
    data = sample(coordinates, variables, alpha=1.5, gamma=gamma)
    # A difference has a sign, which a logarithmic axis cannot show.
    return data.assign(velocity_difference=-data["velocity_difference"])


def compared_front(gamma):
    """A front beside a driven chain and three continuum fronts."""
    variables = {}
    for field in FIELDS:
        variables |= {field: ["xi"], f"{field}_driven": ["xi_driven"]}
        variables |= {f"{field}_{front}": ["xi"] for front in CONTINUUM}
    coordinates = {**XI, "xi_driven": np.arange(-4, 4)}
    return sample(coordinates, variables, alpha=1.5, gamma=gamma)


def survey():
    """Distances of continuum fronts over the damping, for four exponents: a row and a panel."""
    variables = {f"distance_{front}": ["alpha", "gamma"] for front in CONTINUUM}
    coordinates = {"alpha": [1.02, 1.1, 1.5, 2.0], "gamma": np.geomspace(0.1, 2.0, 5)}
    return sample(coordinates, variables | {"critical_damping": ["alpha"]})


def critical_damping():
    """Overshoot over exponent and damping, and four curves; one overshoot is below what shows."""
    variables = {"overshoot": ["alpha", "gamma"]}
    for meaning in ("tail", "double_root", "long_wave", "overshoot"):
        variables[f"critical_damping_{meaning}"] = ["alpha"]
    coordinates = {"alpha": np.linspace(1.1, 1.6, 4), "gamma": np.geomspace(0.1, 2.0, 5)}
    data = sample(coordinates, variables, overshoot_cut=1e-3, exchange_exponent=1.3)
    data["overshoot"][0, 0] = 1e-9
    return data


def multipliers():
    """Multipliers of two fronts in three windows, and those of waves behind the front."""
    coordinates = {
        "scene": ["underdamped", "overdamped"],
        "beads_behind": [20, 40, 80],
        "multiplier": np.arange(5),
        "branch": [0, 1],
        "wavenumber": np.linspace(0.0, 3.0, 7),
    }
    variables = {"alpha": ["scene"], "gamma": ["scene"]}
    for part in ("real", "imaginary"):
        variables[f"multiplier_{part}"] = ["scene", "beads_behind", "multiplier"]
        variables[f"essential_multiplier_{part}"] = ["scene", "branch", "wavenumber"]
    return sample(coordinates, variables)


def speed_error():
    """Two problems by two methods, of which one failed once and one was disturbed once."""
    coordinates = {
        "problem": ["ring_hertz", "contact_loss"],
        "method": ["strain_form", "scipy_dop853"],
        "tolerance": [1e-8, 1e-4, 1e-6],
    }
    measured = ["problem", "method", "tolerance"]
    variables = {"error": measured, "seconds": measured, "reference_error": ["problem"]}
    data = sample(coordinates, variables, absent=json.dumps(["diffrax_dopri8"]))
    data["own_method"] = "problem", ["strain_form", "strain_form"]
    data["disturbed"] = xr.zeros_like(data["error"])
    data["disturbed"].loc["ring_hertz", "strain_form", 1e-6] = 1.0
    for name in ("error", "seconds"):
        data[name].loc["contact_loss", "scipy_dop853", 1e-8] = np.nan
    return data


def hard_cases():
    """A case that passed, one that failed, one without a result, and three curves of order."""
    coordinates = {
        "case": ["gamma_1e_6", "alpha_1_02", "colliding_fronts"],
        "method": ["strain_form", "positions_and_w", "positions_and_velocities"],
        "rung": [0, 1, 2],
    }
    variables = {
        "error": ["case"],
        "limit": ["case"],
        "event_steps": ["method", "rung"],
        "event_error": ["method", "rung"],
        "observed_order": ["method"],
    }
    data = sample(coordinates, variables)
    data["error"][2] = np.nan
    data["passed"] = "case", [1, 0, 0]
    return data


def atlas():
    """A front at each exponent and damping: monotone, oscillating, visibly so, and one unsolved."""
    coordinates = {"alpha": [1.1, 1.3, 1.5], "gamma": [0.1, 0.5]}
    names = "overshoot", "width_10_90", "tail_frequency"
    data = sample(coordinates, {name: ["alpha", "gamma"] for name in names})
    data["tail_frequency"][0] = 0.0
    data["overshoot"][1] = 1e-4
    data["overshoot"][0] = 0.0
    data["status"] = ["alpha", "gamma"], np.array([[0, 0], [0, 0], [0, 1]])
    data["width_10_90"][2, 1] = data["overshoot"][2, 1] = np.nan
    return data


def beads():
    """Damping of two materials."""
    return sample({"material": ["steel", "cork"]}, {"gamma_printed": ["material"]})


def jump_conditions():
    """Theory and measurements of three lattices with their errors, and profiles."""
    variables = {"profile": ["law", "xi"], "state_minus": ["law"], "state_plus": ["law"]}
    for quantity, ways in {
        "speed": ("expected", "exact", "travelling", "driven"),
        "velocity_jump": ("expected", "driven"),
        "power": ("expected", "exact", "driven"),
    }.items():
        for way in ways:
            variables |= {f"{quantity}_{way}": ["law"], f"{quantity}_{way}_error": ["law"]}
    return sample({"law": ["toda", "fpu_alpha", "hertz_kuwabara_kono"], **XI}, variables)


def damping_regimes():
    """γ and restitution over velocity for two laws; each γ crosses its critical value."""
    variables = {
        "gamma": ["beta", "velocity_ratio"],
        "restitution": ["beta", "velocity_ratio"],
        "critical_gamma": ["beta"],
    }
    return sample({"beta": [1.0, 1.5], "velocity_ratio": np.geomspace(0.1, 10.0, 9)}, variables)


def numerical_damping():
    """Three chains, and distances over the step for two θ."""
    variables = {
        f"relative_displacement_{name}": ["bead"] for name in ("method", "damped", "conservative")
    }
    variables |= {
        "damping_distance": ["theta", "step"],
        "conservative_distance": ["theta", "step"],
        "order": ["theta"],
    }
    coordinates = {"theta": [0.75, 1.0], "step": [0.24, 0.12, 0.06], "bead": np.arange(1, 10)}
    profile = {"theta": 0.75, "step": 0.12, "end_time": 12.0, "beads": 10}
    return sample(coordinates, variables, {"profile": profile})


def half_step_damping():
    """A motion by the scheme and accurately, and what is read and checked, over the step."""
    chains = ["beta", "gamma", "step"]
    variables = {f"relative_displacement_{name}": ["t"] for name in ("accurate", "method")}
    variables |= dict.fromkeys(["excess_overshoot", "excess_tail", "error"], chains)
    variables |= {
        f"{one}_defect": ["step"] for one in ("restitution", "energy", "speed", "momentum")
    }
    coordinates = {
        "beta": [1.5, 1.25],
        "gamma": [0.05, 0.2],
        "step": [0.04, 0.02, 0.01],
        "t": np.linspace(0.0, 40.0, 41),
    }
    shown = {"beta": 1.25, "gamma": 0.2, "steps_per_collision": 25}
    return sample(coordinates, variables | {"order": ["beta", "gamma"]}, {"shown": shown})


MODELS = ("logarithmic", "unlimited", "dispersive")
ALPHAS = [1.01, 1.05, 1.1, 1.5]
SLOW_TIMES = [0.5, 1.0, 2.0]


def rings(axes, *fields, **attributes):
    """A campaign of rings: ε and errors of three equations at three slow times."""
    coordinates = {**axes, "slow_time": SLOW_TIMES}
    variables = {f"{field}_{model}": list(coordinates) for field in fields for model in MODELS}
    return sample(
        coordinates, variables | {"epsilon_of_ring": list(coordinates)}, None, **attributes
    )


def ring_limit():
    """Campaigns of figure 20: three limits, two other starts, and a pulse and a front over time."""
    sup, rms, alpha = "displacement_sup", "displacement_rms", {"alpha": ALPHAS}
    limit = rings({"damping": [0.3, 1.0], **alpha}, sup)
    residuals = {
        f"residual_{formula}": factor * limit["epsilon_of_ring"]
        for formula, factor in (("leading", 2.0), ("printed", 3.0), ("first_order", 5.0))
    }
    return {
        "damping": limit.assign(residuals),
        "gamma": rings(alpha, sup, gamma=0.24),
        "mu": rings({"mu": [2.0, 8.0], **alpha}, sup, rms),
        "leading": rings({"mu": [2.0], **alpha}, rms),
        "plateau": rings(alpha, rms, gamma=0.24, delta=5.0),
        "time": rings({"mu": [2.0, 8.0]}, sup),
        "front": rings({}, sup, alpha=1.02, mu=8.0),
    }


def ring_map():
    """The campaign of figure 21, all of whose rings are solved, and the two runs of the paper."""
    lost = [f"lost_{loss}" for loss in (1, 5, 10)]
    campaign = rings({"gamma": [0.2, 1.0, 5.0], "alpha": ALPHAS}, "displacement_sup", *lost)
    runs = {
        name: sample({}, {}, {"law": {"alpha": alpha, "gamma": gamma}, "displacement": 5.0})
        for name, alpha, gamma in (("weak", 1.1, 0.24), ("hertz", 1.5, 0.24))
    }
    solved = campaign["epsilon_of_ring"].astype(int).where(False, 0)
    return {"rings": campaign.assign(status=solved), **runs}


def proofs(alphas, gammas):
    """Certificates of fronts that overshoot, are monotone, are either, and exist."""
    names = "error_bound", "overshoot_bound", "gamma_low", "gamma_high"
    data = sample({"certificate": ["a", "b", "c", "d"]}, {name: ["certificate"] for name in names})
    data["error_bound"] = "certificate", [1e-8, 1e-7, 1e-6, 1e-5]
    data["overshoot_bound"] = "certificate", [0.1, np.nan, np.nan, np.nan]
    for row, shape in enumerate(("oscillates", "monotone", "critical")):
        data[shape] = "certificate", np.where(np.arange(4) == row, 1.0, np.nan)
    data["alpha"], data["beta"] = (("certificate", alphas) for _ in range(2))
    data["gamma_low"], data["gamma_high"] = (("certificate", ends) for ends in gammas)
    return data


def enclosed_front():
    """A front with errors, a residual, and bounds of its tails, the first lower bound unknown."""
    variables = {name: ["xi"] for name in ("approximation", "error", "residual")}
    variables |= {name: ["xi_ahead"] for name in ("decay_low", "decay_high")}
    data = sample({**XI, "xi_ahead": [1.0, 1.5, 2.0, 2.5]}, variables, alpha=1.5, gamma=0.3)
    data["error"] = 1e-9 * data["error"]
    data["decay_high"][0] = np.inf
    return data.assign_attrs(rate_low=0.4, rate_high=0.5, amplitude_low=0.6, amplitude_high=0.7)


def honesty(*variables):
    """Three numbers of each variable."""
    names = np.repeat(variables, 3)
    values = ("ratio", "stated_error", "true_error")
    data = sample({"number": np.arange(names.size)}, {name: ["number"] for name in values})
    return data.assign_coords(variable=("number", names))


PROBES = ("relative_displacement_steady", "relative_displacement_transient")
GRIDS = ("relative_displacement_grid", "velocity_grid")

SAMPLES = {
    "fig01": lambda: {"data": driven_chain("velocity", *PROBES)},
    "fig02": lambda: {"data": driven_chain(*GRIDS)},
    "fig03": lambda: {"data": driven_chain(PROBES[1], GRIDS[0])},
    "fig04": lambda: {"data": log_burgers_fronts()},
    "fig05": lambda: {"weak": ring(1.1, [0.0]), "hertz": ring(1.5, [0.0])},
    "fig06": lambda: {"data": ring(1.1, equation=True)},
    "fig07": lambda: {"data": ring(1.5, equation=True)},
    "fig07b": lambda: {"weak": ring_distances(1.1), "hertz": ring_distances(1.5)},
    "fig08": lambda: {"data": heteroclinic()},
    "fig09": lambda: {
        "underdamped": front_by_two_methods(0.05),
        "overdamped": front_by_two_methods(0.65),
    },
    "fig10": lambda: {"scenes": [compared_front(0.05), compared_front(0.65)]},
    "fig11": lambda: {"data": survey()},
    "fig12": lambda: {"data": critical_damping()},
    "fig13": lambda: {"data": multipliers()},
    "fig14": lambda: {"data": speed_error()},
    "fig15": lambda: {"data": hard_cases()},
    "fig16": lambda: {"atlas": atlas(), "curves": critical_damping(), "materials": beads()},
    "fig17": lambda: {"data": jump_conditions()},
    "fig18": lambda: {"data": damping_regimes()},
    "fig19": lambda: {"data": numerical_damping()},
    "fig20": ring_limit,
    "fig21": ring_map,
    "fig22": lambda: {"data": half_step_damping()},
    "fig23": lambda: {
        "fronts": proofs([1.5, 2.0, 1.5, 3.0], ([0.2, 0.3, 0.25, 0.4], [0.2, 0.3, 0.25, 0.4])),
        "intervals": proofs([1.5] * 4, ([0.1, 0.2, 0.4, 0.8], [0.2, 0.4, 0.8, 1.0])),
        "curves": critical_damping(),
    },
    "fig24": lambda: {"data": enclosed_front()},
    "fig25": lambda: {
        "chains": honesty("velocity", "arrival_time", "first_gap_bead", "front_speed"),
        "fronts": honesty("strain", "slope"),
        "evolutions": honesty("logarithmic", "dispersive", "unlimited"),
    },
}
"""What each figure is given, by the names of its arguments."""
