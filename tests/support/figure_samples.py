"""A dataset for each figure with values that are all different.

A figure computes nothing, so any numbers do: every variable is filled with random numbers of its
own, and what is drawn can be traced to one variable only.
"""

import inspect
import json
import zlib

import numpy as np
import xarray as xr

FIELDS = ("relative_displacement", "velocity")
EQUATIONS = ("logarithmic", "unlimited")
CONTINUUM = ("logarithmic", "unlimited", "heteroclinic")
MODELS = ("logarithmic", "unlimited", "dispersive")
# Names that xarray has taken: `sel` reads them as its options, or `dataset.name` is another thing.
TAKEN = {*dir(xr.Dataset()), *inspect.signature(xr.Dataset.sel).parameters}
XI = {"xi": np.linspace(-6.0, 4.0, 21)}
GAMMAS = {"gamma": np.geomspace(0.1, 2.0, 5)}


def sample(coordinates, variables, config=None, **attributes):
    """A dataset of positive numbers below 1, other ones for each variable of each dataset.

    `variables` are names by the dimensions that they have, both separated by blanks.
    """
    sizes = {name: len(values) for name, values in coordinates.items()}

    def values(name, dimensions):
        seed = repr((name, sizes, config, attributes))
        generator = np.random.default_rng(zlib.crc32(seed.encode()))
        return generator.uniform(0.1, 0.9, [sizes[each] for each in dimensions])

    filled = {
        name: (dimensions.split(), values(name, dimensions.split()))
        for dimensions, names in variables.items()
        for name in names.split()
    }
    return xr.Dataset(filled, coordinates, attributes | {"config": json.dumps(config)})


def each(form, *words):
    """Names of one form, with `%` in the place of each word."""
    return " ".join(form.replace("%", word) for word in words)


def driven_chain(variables):
    """Some of a chain driven by δ = 0.1: a snapshot, a grid, and two sets of probes."""
    coordinates = {
        "t": [20.0],
        "bead": np.arange(1, 13),
        "t_grid": np.arange(8.0),
        "t_steady": np.linspace(5.0, 30.0, 26),
        "bead_steady": [6, 9, 12],
        "t_transient": np.linspace(0.0, 10.0, 11),
        "bead_transient": [1, 3],
    }
    config = {"boundary": {"left": 0.1}, "law": {"gamma": 0.06}}
    return sample(coordinates, variables, config)


def ring(alpha, times=(0.0, 15.0, 30.0), *, equation=False):
    """A ring at some times, and the logarithmic Burgers equation where it is asked for."""
    coordinates = {"t": list(times), "bead": np.arange(1, 10), "site": np.arange(1.0, 10.0, 0.5)}
    variables = {"t bead": each("%", *FIELDS)}
    if equation:
        variables |= {"t site": each("%_logarithmic", *FIELDS)}
    return sample(coordinates, variables, {"law": {"alpha": alpha}})


def ring_distances(alpha):
    """Distances of a ring to both equations, and the errors of the solvers, over time."""
    kinds = [f"{field}_{kind}_%" for field in FIELDS for kind in ("sup", "rms", "floor")]
    variables = {"t_grid": " ".join(each(kind, *EQUATIONS) for kind in kinds)}
    return sample({"t_grid": np.arange(7.0)}, variables, {"law": {"alpha": alpha}})


def log_burgers_fronts():
    coordinates = {"alpha": [1.5, 1.1], "force": np.linspace(0.0, 1.0, 11), **XI}
    variables = {"alpha force": "flux compression", "alpha xi": "front"}
    return sample(coordinates, variables | {"force": "flux_limit", "xi": "front_limit"})


def heteroclinic():
    """Three fronts, the double well, and a phase portrait of two trajectories."""
    coordinates = {
        "mu": [0.3, 1.0, 2.0],
        "s": np.linspace(-5.0, 5.0, 11),
        "y": np.linspace(-1.5, 1.5, 13),
        "trajectory": [0, 1],
        "s_portrait": np.linspace(-3.0, 3.0, 13),
    }
    names = "rescaled_force", "slope"
    variables = {"mu s": each("%", *names), "y": "potential"}
    variables |= {"trajectory s_portrait": each("%_portrait", *names)}
    return sample(coordinates, variables, portrait_mu=0.3)


def front_by_two_methods(gamma):
    """A front by the profile equation and by shooting, with both residual histories."""
    iterations = {"iteration_profile": np.arange(5), "iteration_shooting": np.arange(4)}
    coordinates = {**XI, "xi_shooting": np.arange(-3.0, 3.0, 0.25), **iterations}
    variables = {
        "xi": "relative_displacement",
        "xi_shooting": "relative_displacement_shooting " + each("%_difference", *FIELDS),
        "iteration_profile": "residual_history_profile",
        "iteration_shooting": "residual_history_shooting",
    }
    data = sample(coordinates, variables, alpha=1.5, gamma=gamma)
    # A difference has a sign, which a logarithmic axis cannot show.
    return data.assign(velocity_difference=-data["velocity_difference"])


def compared_front(gamma):
    fronts = [each(f"{field}_%", *CONTINUUM) for field in FIELDS]
    variables = {"xi": " ".join([*FIELDS, *fronts]), "xi_driven": each("%_driven", *FIELDS)}
    return sample({**XI, "xi_driven": np.arange(-4, 4)}, variables, alpha=1.5, gamma=gamma)


def survey():
    variables = {"alpha gamma": each("distance_%", *CONTINUUM), "alpha": "critical_damping"}
    return sample({"alpha": [1.02, 1.1, 1.5, 2.0], **GAMMAS}, variables)


def critical_damping():
    """Curves of critical damping, of two peaks, and of levels; one level is not reached."""
    curves = each("critical_damping_%", "tail", "double_root", "long_wave", "overshoot")
    coordinates = {"alpha": np.linspace(1.1, 1.6, 4), "level": [0.01, 0.1], **GAMMAS}
    variables = {
        "level alpha": "overshoot_level",
        "alpha": f"{curves} second_peak_leads first_peak_stays_below",
    }
    data = sample(coordinates, variables, overshoot_cut=1e-3, exchange_exponent=1.3)
    data["overshoot_level"][1, :2] = np.nan
    return data


def materials():
    return sample({"material": ["steel", "cork"]}, {"material": "gamma_printed"})


def multipliers():
    coordinates = {
        "scene": ["underdamped", "overdamped"],
        "beads_behind": [20, 40, 80],
        "multiplier": np.arange(5),
        "branch": [0, 1],
        "wavenumber": np.linspace(0.0, 3.0, 7),
    }
    variables = {
        "scene": "alpha gamma",
        "scene beads_behind": "spectral_radius_without_translation reflection_radius",
        "scene beads_behind multiplier": each("multiplier_%", "real", "imaginary", "rounding"),
        "scene branch wavenumber": each("essential_multiplier_%", "real", "imaginary"),
    }
    data = sample(coordinates, variables)
    # Some are moved too far by rounding to be shown.
    return data.assign(multiplier_rounding=2e-2 * data["multiplier_rounding"])


def speed_error():
    """Two problems by two methods, of which one failed once and one was disturbed once."""
    coordinates = {
        "problem": ["front_underdamped", "contact_loss"],
        "solver": ["strain_form", "scipy_dop853"],
        "step_tolerance": [1e-8, 1e-4, 1e-6],
    }
    variables = {"problem solver step_tolerance": "error seconds", "problem": "reference_error"}
    data = sample(coordinates, variables, absent=json.dumps(["diffrax_dopri8"]))
    data["own_method"] = "problem", ["strain_form", "strain_form"]
    data["disturbed"] = xr.zeros_like(data["error"])
    data["disturbed"].loc["front_underdamped", "strain_form", 1e-6] = 1.0
    for name in ("error", "seconds"):
        data[name].loc["contact_loss", "scipy_dop853", 1e-8] = np.nan
    return data


def hard_cases():
    """A case that passed, one that failed, one without a result, and three curves of order."""
    coordinates = {
        "case": ["gamma_1e_6", "alpha_1_02", "colliding_fronts"],
        "solver": ["strain_form", "positions_and_w", "positions_and_velocities"],
        "rung": [0, 1, 2],
    }
    variables = {"case": "error limit", "solver rung": "event_steps event_error"}
    data = sample(coordinates, variables | {"solver": "observed_order"})
    data["error"][2] = np.nan
    data["passed"] = "case", [1, 0, 0]
    return data


def jump_conditions():
    """Theory and measurements of three lattices with their errors, and profiles."""
    numbers = each("speed_%", "expected", "exact", "travelling", "driven").split()
    numbers += each("velocity_jump_%", "expected", "driven").split()
    numbers += each("power_%", "expected", "exact", "driven").split()
    names = " ".join(["state_minus", "state_plus", *numbers, each("%_error", *numbers)])
    damping = {
        "toda": {"kind": "fpu"},
        "fpu_alpha": {"kind": "fpu"},
        "hertz_kuwabara_kono": {"kind": "hertz", "alpha": 1.5},
    }
    cases = {name: {"dissipation": dissipation} for name, dissipation in damping.items()}
    return sample({"law": list(cases), **XI}, {"law xi": "profile", "law": names}, {"cases": cases})


def damping_regimes():
    """γ and restitution over velocity for two laws; each γ crosses its critical value."""
    variables = {"beta velocity_ratio": "gamma restitution", "beta": "critical_gamma"}
    coordinates = {"beta": [1.0, 1.5], "velocity_ratio": np.geomspace(0.1, 10.0, 9)}
    return sample(coordinates, variables, {"alpha": 1.5})


def numerical_damping():
    coordinates = {"theta": [0.75, 1.0], "step": [0.24, 0.12, 0.06], "bead": np.arange(1, 10)}
    variables = {
        "bead": each("relative_displacement_%", "method", "damped", "conservative"),
        "theta step": "damping_distance conservative_distance",
        "theta": "order",
    }
    profile = {"theta": 0.75, "step": 0.12, "end_time": 12.0, "beads": 10}
    return sample(coordinates, variables, {"profile": profile})


def half_step_damping():
    """A motion by the scheme and accurately, and what is read and checked, over the step."""
    coordinates = {
        "beta": [1.5, 1.25],
        "gamma": [0.05, 0.2],
        "step": [0.04, 0.02, 0.01],
        "t": np.linspace(0.0, 40.0, 41),
    }
    variables = {
        "t": each("relative_displacement_%", "accurate", "method"),
        "beta gamma step": "excess_overshoot excess_tail error",
        "step": each("%_defect", "restitution", "energy", "speed", "momentum"),
        "beta gamma": "order",
    }
    shown = {"beta": 1.25, "gamma": 0.2, "steps_per_collision": 25}
    return sample(coordinates, variables, {"shown": shown})


def rings(**axes):
    """A campaign of rings: ε and errors of three equations at three slow times."""
    coordinates = {**axes, "alpha": [1.01, 1.05, 1.1, 1.5], "slow_time": [0.5, 1.0, 2.0]}
    names = f"epsilon_of_ring {each('displacement_sup_%', *MODELS)}"
    return sample(coordinates, {" ".join(coordinates): names})


def proofs(alphas, gammas):
    """Certificates of fronts that overshoot, are monotone, are either, and exist."""
    names = "error_bound overshoot_bound gamma_low gamma_high"
    data = sample({"certificate": ["a", "b", "c", "d"]}, {"certificate": names})
    data["error_bound"] = "certificate", [1e-8, 1e-7, 1e-6, 1e-5]
    data["overshoot_bound"] = "certificate", [0.1, np.nan, np.nan, np.nan]
    for row, shape in enumerate(("oscillates", "monotone", "critical")):
        data[shape] = "certificate", np.where(np.arange(4) == row, 1.0, np.nan)
    data["alpha"], data["beta"] = (("certificate", alphas) for _ in range(2))
    data["gamma_low"], data["gamma_high"] = (("certificate", ends) for ends in gammas)
    return data


def enclosed_front():
    """A front with errors, a residual, and bounds of its tails, the first lower bound unknown."""
    variables = {"xi": "approximation error residual", "xi_ahead": "decay_low decay_high"}
    data = sample({**XI, "xi_ahead": [1.0, 1.5, 2.0, 2.5]}, variables, alpha=1.5, gamma=0.3)
    data["error"] = 1e-9 * data["error"]
    data["decay_high"][0] = np.inf
    return data.assign_attrs(rate_low=0.4, rate_high=0.5, amplitude_low=0.6, amplitude_high=0.7)


def honesty(*variables):
    """Three numbers of each variable."""
    names = np.repeat(variables, 3)
    data = sample({"number": np.arange(names.size)}, {"number": "ratio stated_error true_error"})
    return data.assign_coords(variable=("number", names))


def motions(**axes):
    """A campaign of motions: the energy that passes the last contact of a sensor."""
    variables = {" ".join(axes): "transmitted_energy"}
    return sample(axes, variables, {"scene": {"start": {"velocity": 1.0}}})


def draws():
    """The same for two draws of each spread, whose means have errors."""
    data = motions(beads_mass_random_spread=[0.1, 0.4, 0.8], beads_mass_random_seed=[1.0, 2.0])
    data["transmitted_energy"].attrs["error_estimate"] = 1e-6
    return data


STEADY = {"t_steady bead_steady": "relative_displacement_steady"}
TRANSIENT = {"t_transient bead_transient": "relative_displacement_transient"}
GRID = {"t_grid bead": "relative_displacement_grid"}
BOTH_GRIDS = {"t_grid bead": "relative_displacement_grid velocity_grid"}
ARRIVAL = {"bead": "arrival_time"}

SAMPLES = {
    "fig01": lambda: {"data": driven_chain({"t bead": "velocity"} | STEADY | TRANSIENT)},
    "fig02": lambda: {"data": driven_chain(BOTH_GRIDS | ARRIVAL)},
    "fig03": lambda: {"data": driven_chain(TRANSIENT | GRID | ARRIVAL)},
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
    "fig12": lambda: {"data": critical_damping(), "materials": materials()},
    "fig13": lambda: {"data": multipliers()},
    "fig14": lambda: {"data": speed_error()},
    "fig15": lambda: {"data": hard_cases()},
    "fig17": lambda: {"data": jump_conditions()},
    "fig18": lambda: {"data": damping_regimes()},
    "fig19": lambda: {"data": numerical_damping()},
    "fig20": lambda: {"damping": rings(damping=[0.3, 1.0]), "mu": rings(mu=[2.0, 8.0])},
    "fig22": lambda: {"data": half_step_damping()},
    "fig23": lambda: {
        "fronts": proofs([1.5, 2.0, 1.5, 3.0], ([0.2, 0.3, 0.25, 0.4], [0.2, 0.3, 0.25, 0.4])),
        "intervals": proofs([1.5] * 4, ([0.1, 0.2, 0.4, 0.8], [0.2, 0.4, 0.8, 1.0])),
    },
    "fig24": lambda: {"data": enclosed_front()},
    "fig25": lambda: {
        "chains": honesty("velocity", "arrival_time", "first_gap_bead", "front_speed"),
        "fronts": honesty("strain", "slope"),
        "rings": honesty("place_dispersive", "smallest_compression"),
    },
    "fig26": lambda: {
        "dimers": motions(
            record_sensors_far_contacts_2=[20, 60], beads_mass_cell_2=[0.1, 0.3, 0.6, 1.0]
        ),
        "tapers": motions(
            beads_mass_taper_ratio=[0.95, 1.0], beads_mass_impurity_mass=[0.1, 1.0, 9.0]
        ),
        "draws": draws(),
        "driven": sample(
            {"delta": [0.01, 0.1], "gamma": [0.02, 0.2, 2.0]}, {"delta gamma": "overshoot"}
        ),
    },
}
"""What each figure is given, by the names of its arguments."""
