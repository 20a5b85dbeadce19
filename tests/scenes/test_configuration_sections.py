"""Sections of the configuration outside `scenes`: each is checked, and refused in a sentence."""

import pytest
from configurations import refusal, set_value

from granular_fronts.scenes.configuration import SECTIONS, check_configuration


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
    ("hard_cases", ["delta_1e8"] * 2, ['hard_cases (entry 2) is "delta_1e8"', "list it once"]),
    # Unknown names.
    ("hard_cases", ["gama_zero"], ['"gama_zero", which is unknown: did you mean gamma_zero?']),
    # What is no mapping.
    ("scenes.periodic.weak", None, ["Scene weak is null: give a mapping of keys to values"]),
    # Names that clash.
    ("scenes.front.survey", FRONT, ["has the name of the study survey", "rename"]),
    ("scenes.heteroclinic.log_burgers_fronts", ORBIT, ["the study log_burgers_fronts", "rename"]),
    ("scenes.heteroclinic.weak", ORBIT, ["has the name of scenes.heteroclinic.weak", "rename"]),
    # Sizes.
    ("proofs.intervals.hertz.parts", [{"to": 1, "chunks": 10**9}], ["above its limit 10000"]),
    ("proofs.fronts.hertz_1.gamma", [0.31, 0.3], ["fronts.hertz_1.gamma goes from 0.31 to 0.3"]),
    (
        "scenes.chain.initiation_underdamped.record.snapshots",
        [*range(1_000_001)],
        ["values, above the limit of 1,000,000: list fewer"],
    ),
    ("exact_fronts.survey.gamma.num", 10**9, ["gamma.num is 1000000000", "above its limit 10000"]),
    (
        "exact_fronts.critical_damping.alpha.num",
        10**9,
        ["num is 1000000000", "10000 or less"],
    ),
    ("exact_fronts.multipliers.beads_behind", [10**6], ["(entry 1) is 1000000", "2000 or less"]),
    ("scenes.front.underdamped.window.step", 1e-9, ["window.step = 1e-09", "GiB", "raise window"]),
    ("scenes.periodic.weak.record.grid.step", 1e-9, ["record.grid.step = 1e-09", "GiB"]),
    ("scenes.periodic.weak.equations.upwind.points", 10**7, ["upwind.points = 10000000", "years"]),
    ("laws.damping_regimes.points", 10**9, ["points is 1000000000", "100000 or less"]),
    ("laws.piston.beads", 10**9, ["beads is 1000000000", "100000 or less"]),
    ("laws.jump_conditions.beads", 10**9, ["beads is 1000000000", "100000 or less"]),
    ("laws.numerical_damping.profile.step", 1e-12, ["profile.step is 1e-12", "1e-06 or more"]),
    ("laws.half_step_damping.collision_times", 10**9, ["collision_times is 1000000000", "1000 or"]),
    ("precision.chain.contact_loss.repeats", 10**12, ["repeats is 1000000000000", "1000 or less"]),
    ("precision.chain.contact_loss.end_time", 1e300, ["end_time is 1e+300", "10000 or less"]),
    ("precision.log_burgers.weak.longest_steps", [1e-30], ["is 1e-30", "1e-06 or more"]),
    # What figures and tables need.
    ("scenes.periodic.weak.record.snapshots", [10, 20], ["figure 5 needs 0 too", "add it"]),
    ("scenes.periodic.weak.record.snapshots", [0], ["is [0]", "needs 2 entries or more"]),
    # Waves of the limiting cases.
    ("laws.limiting_cases.beads", 250, ["beads is 250", "about 276 beads", "smaller end_time"]),
    ("laws.limiting_cases.end_time", 0.1, ["end_time is 0.1", "strong_gamma 1", "give 32 or more"]),
    ("laws.limiting_cases.strong_gamma", 40, ["strong_gamma 40", "give 656 or more"]),
    ("laws.limiting_cases.beads", 10**9, ["beads is 1000000000", "100000 or less"]),
    ("laws.limiting_cases.rings.gamma", 1e12, ["rings.gamma is 1000000000000.0", "100 or less"]),
    # Units.
    (f"{MATERIAL}.radius", 19.6, ["radius is 19.6", "density of 2.5e-06 kg/m³", "give metres"]),
    (f"{MATERIAL}.youngs_modulus", 70, ["youngs_modulus is 70 Pa", "70 GPa are 7.0e+10"]),
    # Ranges and steps.
    ("exact_fronts.survey.gamma.start", 2, ["gamma.start is 2", "its stop 2", "raise stop"]),
    ("laws.numerical_damping.profile.step", 0.7, ["no whole number of such steps ends at"]),
    ("laws.numerical_damping.order.steps", [0.24], ["has 1 entry, below its limit 3"]),
    ("laws.half_step_damping.alpha", 2, ["alpha is 2", "above its limit 1.5"]),
    ("laws.half_step_damping.gammas", [0.05, 0.2], ["gammas (entry 2) is 0.2", "limit 0.13"]),
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
    ("precision.log_burgers.weak.reference.points", 9, ["no multiple of 2"]),
    ("precision.chain.contact_loss.own_tolerances", {"scipy_rk54": [1e-4]}, ['"scipy_rk54"']),
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


RINGS = {"gamma": 100, "half_length": 100, "slow_time": 10, "exponents": [1.2, 1.1, 1.02]}


@pytest.mark.parametrize(
    ("section", "changed", "words"),
    [
        (
            "half_step_damping",
            {"collision_times": 1000, "steps_per_collision": [10, 99, 10**4]},
            "GiB",
        ),
        ("limiting_cases.rings", RINGS, "3 days"),
        ("numerical_damping.profile", {"beads": 10**4, "end_time": 10**4, "step": 1e-6}, "days"),
    ],
)
def test_products_of_allowed_counts_are_weighed(default, section, changed, words):
    node = default["laws"]
    for key in section.split("."):
        node = node[key]
    node.update(changed)
    assert words in refusal(default)


def unchecked_sections(configuration, checks):
    """Sections of a configuration at no path of a dictionary of checks."""
    return [
        key
        for key, node in configuration.items()
        if isinstance(node, dict) and not is_checked(key, node, checks)
    ]


def is_checked(path, node, checks):
    """Whether a node, or all that it holds, has checks; a list or a number has the schema's."""
    if not isinstance(node, dict) or {path, f"{path}.*"} & set(checks):
        return True
    return all(
        isinstance(v, dict) and is_checked(f"{path}.{k}", v, checks) for k, v in node.items()
    )


def test_every_section_is_checked(default):
    assert not unchecked_sections(default, SECTIONS)
    for path in ("laws.limiting_cases", "scenes.chain.*", "precision.ring.*"):
        fewer = {key: section for key, section in SECTIONS.items() if key != path}
        assert unchecked_sections(default, fewer) == [path.partition(".")[0]]


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
