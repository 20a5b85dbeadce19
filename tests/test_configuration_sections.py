"""Sections of the configuration outside `scenes`: each is checked, and refused in a sentence."""

import functools
import operator
import re

import pytest
from configurations import ROOT, refusal, set_value

from granular_fronts.scenes.configuration import check_configuration
from granular_fronts.scenes.constraints import CONSTRAINTS
from granular_fronts.scenes.sizes import SIZES


@pytest.mark.parametrize(
    ("configuration", "words"),
    [
        ({}, "scenes is missing"),
        (None, "the file is null: give a mapping"),
        ({"results": "", "scenes": {"chain": {}}}, "results is empty"),
        ({"results": "results", "scenes": {"chain": {}}}, "scenes.heteroclinic is missing"),
        ({"results": "results", "scenes": {"chian": {}}}, "did you mean chain?"),
        ({"results": "results", "scenes": {"chain": {1: {}}}}, "1 in scenes.chain is no usable"),
    ],
)
def test_impossible_configuration_outside_scenes_is_refused(configuration, words):
    assert words in refusal(configuration)


FRONT = {
    "law": {"alpha": 1.5, "gamma": 0.06},
    "displacement": 0.1,
    "window": {"start": -40, "stop": 5, "step": 0.02},
    "driven_bead": 400,
}
ORBIT = {"mu": [1], "profile": {"start": -1, "stop": 1, "step": 0.5}}
MATERIAL = "laws.materials.beads.glass"
SECTIONS_REFUSED = [
    # Entries listed twice.
    ("exact_fronts.survey.alpha", [1.1, 1.5, 1.1], ["alpha (entry 3) is 1.1", "list it once"]),
    ("front_exponents", [1.5, 1.5], ["front_exponents (entry 2) is 1.5", "list it once"]),
    ("laws.damping_regimes.betas", [1, 1.0], ["betas (entry 2) is 1.0", "list it once"]),
    ("laws.piston.ramps", [0, 10, 10], ["ramps (entry 3) is 10", "list it once"]),
    ("hard_cases", ["delta_1e8"] * 2, ['hard_cases (entry 2) is "delta_1e8"', "list it once"]),
    # Unknown names.
    ("hard_cases", ["gama_zero"], ['"gama_zero", which is unknown: did you mean gamma_zero?']),
    ("hard_cases", ["something"], ["is unknown: choose gamma_zero or", "or front_dashpot."]),
    # What is no mapping.
    ("scenes.periodic.weak", None, ["Scene weak is null: give a mapping of keys to values"]),
    # Names that clash.
    ("scenes.front.survey", FRONT, ["scenes.front.survey has the name of the survey", "rename"]),
    ("scenes.front.multipliers", FRONT, ["has the name of the multipliers", "rename"]),
    ("scenes.front.critical_damping", FRONT, ["has the name of the map", "rename"]),
    ("scenes.heteroclinic.log_burgers_fronts", ORBIT, ["has the name of the fluxes", "rename"]),
    ("scenes.heteroclinic.weak", ORBIT, ["has the name of scenes.heteroclinic.weak", "rename"]),
    ("scenes.front.piston", FRONT, ["has the name of the fronts driven by pistons", "rename"]),
    # Sizes.
    ("proofs.intervals.hertz.parts", [{"to": 1, "chunks": 10**9}], ["above its limit 10000"]),
    ("proofs.fronts.hertz_1.gamma", [0.31, 0.3], ["fronts.hertz_1.gamma goes from 0.31 to 0.3"]),
    (
        "scenes.chain.initiation_underdamped.record.snapshots",
        [*range(1_000_001)],
        ["values, above the limit of 1,000,000: list fewer"],
    ),
    ("exact_fronts.survey.gamma.num", 10**9, ["gamma.num = 1000000000", "GiB", "lower gamma.num"]),
    ("exact_fronts.critical_damping.alpha.num", 10**9, ["alpha.num = 1000000000", "74 days"]),
    ("exact_fronts.multipliers.beads_behind", [10**6], ["beads_behind = [1000000]", "years"]),
    ("scenes.front.underdamped.window.step", 1e-9, ["window.step = 1e-09", "GiB", "raise window"]),
    ("scenes.front.underdamped.driven_bead", 10**9, ["driven_bead = 1000000000", "years"]),
    ("scenes.periodic.weak.record.grid.step", 1e-9, ["record.grid.step = 1e-09", "GiB"]),
    ("scenes.periodic.weak.equations.upwind.points", 10**7, ["upwind.points = 10000000", "years"]),
    ("laws.damping_regimes.points", 10**9, ["points = 1000000000", "GiB"]),
    ("laws.piston.beads", 10**9, ["beads = 1000000000", "years", "lower beads"]),
    ("laws.jump_conditions.beads", 10**9, ["beads = 1000000000", "years", "lower beads"]),
    ("laws.numerical_damping.profile.step", 1e-12, ["profile.step = 1e-12", "days"]),
    ("laws.half_step_damping.collision_times", 10**9, ["collision_times = 1000000000", "GiB"]),
    ("precision.chain.contact_loss.repeats", 10**12, ["repeats = 1000000000000", "lower repeats"]),
    ("precision.chain.contact_loss.end_time", 1e300, ["end_time = 1e+300", "years"]),
    ("precision.log_burgers.weak.longest_steps", [1e-30], ["longest_steps = [1e-30]", "raise"]),
    # What figures and tables need.
    ("scenes.periodic.weak.record.snapshots", [10, 20], ["figure 5 needs 0 too", "add it"]),
    ("scenes.periodic.weak.record.snapshots", [0], ["is [0]", "needs 2 entries or more"]),
    # Waves of the limiting cases.
    ("laws.limiting_cases.beads", 250, ["beads is 250", "about 276 beads", "smaller end_time"]),
    ("laws.limiting_cases.end_time", 0.1, ["end_time is 0.1", "strong_gamma 1", "give 32 or more"]),
    ("laws.limiting_cases.strong_gamma", 40, ["strong_gamma 40", "give 656 or more"]),
    ("laws.limiting_cases.beads", 10**9, ["beads = 1000000000", "GiB", "lower beads"]),
    ("laws.limiting_cases.rings.gamma", 1e12, ["rings.slow_time = 1", "years on one core"]),
    # Units.
    (f"{MATERIAL}.radius", 19.6, ["radius is 19.6", "density of 2.5e-06 kg/m³", "give metres"]),
    (f"{MATERIAL}.mass", 78.8, ["its mass 78.8", "2.5e+06 kg/m³", "kilograms"]),
    (f"{MATERIAL}.youngs_modulus", 70, ["youngs_modulus is 70 Pa", "70 GPa are 7.0e+10"]),
    (f"{MATERIAL}.radius", 1e-200, ["radius is 1e-200", "below its limit"]),
    # Ranges and steps.
    ("exact_fronts.survey.gamma.start", 2, ["gamma.start is 2", "its stop 2", "raise stop"]),
    ("laws.numerical_damping.profile.step", 0.7, ["no whole number of such steps ends at"]),
    ("laws.numerical_damping.order.steps", [0.24], ["has 1 entry, below its limit 3"]),
    ("laws.half_step_damping.alpha", 2, ["alpha is 2", "above its limit 1.5"]),
    ("laws.half_step_damping.gammas", [0.05, 0.2], ["gammas (entry 2) is 0.2", "limit 0.13"]),
    ("laws.half_step_damping.betas", [1, 1.1, 1.2, 1.5], ["has 4 entries", "limit 3"]),
    ("laws.half_step_damping.shown.beta", 1.1, ["shown.beta is 1.1, but betas are 1.5, 1.25, 1"]),
    ("laws.half_step_damping.gammas", [0.1], ["shown.gamma is 0.05, but gammas are 0.1"]),
    ("laws.jump_conditions.cases.toda.states", [-2, -2], ["two different states"]),
    (
        "laws.jump_conditions.cases.hertz_dashpot",
        {
            "elastic": {"kind": "hertz", "alpha": 2},
            "dissipation": {"kind": "fpu"},
            "states": [0, 1],
        },
        ["cases.hertz_dashpot.states are 0 and 1", "elastic force of Hertz vanishes", "below 0"],
    ),
    ("laws.piston.tolerance.absolute", 1e-300, ["below 1e-20 of the largest", "or more"]),
    ("scenes.periodic.weak.tolerance.absolute", 1e-300, ["below 1e-20 of the largest", "or more"]),
    ("precision.log_burgers.weak.reference.points", 9, ["no multiple of 2"]),
    (
        "precision.chain.contact_loss.own_tolerances",
        {"scipy_rk54": [1e-4]},
        ['"scipy_rk54"', "is unknown: did you mean scipy_rk45?"],
    ),
]


@pytest.mark.parametrize(
    ("path", "value", "words"),
    SECTIONS_REFUSED,
    ids=[f"{path} {value}"[:70] for path, value, _ in SECTIONS_REFUSED],
)
def test_impossible_section_is_refused_in_a_sentence(default, path, value, words):
    [sentence] = refusal(set_value(default, path, value)).splitlines()
    assert sentence.endswith((".", "?"))
    for word in words:
        assert word in sentence


def unchecked_sections(configuration, checks):
    """Sections that a rule of the workflow is given, at no path of a dictionary of checks."""
    rules = "".join(file.read_text("utf-8") for file in (ROOT / "workflow/rules").glob("*.smk"))
    given = re.findall(r'config((?:\["\w+"\])+)', rules)
    unchecked = []
    for names in {tuple(re.findall(r"\w+", keys)) for keys in given}:
        if names[0] in configuration:  # The name of a campaign comes from the command line only.
            node = functools.reduce(operator.getitem, names, configuration)
            if not is_checked(".".join(names), node, checks):
                unchecked.append(".".join(names))
    return unchecked


def is_checked(path, node, checks):
    """Whether a node, or all that it holds, has checks; a list or a number has the schema's."""
    if not isinstance(node, dict) or {path, f"{path}.*"} & set(checks):
        return True
    return all(
        isinstance(v, dict) and is_checked(f"{path}.{k}", v, checks) for k, v in node.items()
    )


@pytest.mark.parametrize("checks", [CONSTRAINTS, SIZES], ids=["constraints", "sizes"])
def test_every_section_given_to_a_rule_is_checked(default, checks):
    assert not unchecked_sections(default, checks)
    for path in ("laws.limiting_cases", "scenes.chain.*", "precision.ring.*"):
        fewer = {key: check for key, check in checks.items() if key != path}
        unchecked = unchecked_sections(default, fewer)
        assert unchecked
        assert all(path.startswith(section) for section in unchecked)


def test_log_burgers_problem_names_a_ring(default):
    problems = default["precision"]["log_burgers"]
    problems["nosuch"] = problems["weak"]
    assert "nosuch names no periodic scene: choose one of weak, hertz" in refusal(default)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("laws.damping_regimes", {"alpha": 2, "betas": [1, 1.5, 2, 3], "decades": 5, "points": 9}),
        ("scenes.heteroclinic.damping_sweep.mu", [1, 2]),
        ("laws.piston.ramps", [5]),
    ],
)
def test_other_values_of_parameters_than_those_of_the_paper_are_accepted(default, path, value):
    """The table of printed numbers leaves out what it cannot measure."""
    check_configuration(set_value(default, path, value))


def test_missing_key_is_described_by_its_definition(default):
    del default["exact_fronts"]["survey"]["gamma"]
    sentence = "exact_fronts.survey.gamma is missing: add it (Dampings at equal ratios)."
    assert refusal(default) == sentence
