import copy
import functools
import json
import math
import operator
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from granular_fronts.errors import InputError
from granular_fronts.scenes.configuration import (
    argument_errors,
    check_configuration,
    folder_errors,
)
from granular_fronts.scenes.constraints import CONSTRAINTS, RELATIVE_TOLERANCE_FLOOR
from granular_fronts.scenes.sizes import SIZES
from granular_fronts.scenes.validation import check_scene
from granular_fronts.scenes.yaml_files import load_configuration, merge

ROOT = Path(__file__).parents[1]
DEFAULT = ROOT / "config" / "default.yaml"
SMOKE = ROOT / "config" / "smoke.yaml"
SCENE = "initiation_underdamped"


def change(configuration, family="chain", scene=SCENE, **changes):
    """Set `record__grid__step=…` in the scene; an ellipsis takes the key away."""
    changed = copy.deepcopy(configuration)
    for path, value in changes.items():
        *parents, last = path.split("__")
        node = changed["scenes"][family][scene]
        for parent in parents:
            node = node[parent]
        if value is ...:
            del node[last]
        else:
            node[last] = value
    return changed


def refusal(configuration):
    with pytest.raises(InputError) as caught:
        check_configuration(configuration)
    return str(caught.value)


@pytest.fixture
def default():
    return load_configuration(DEFAULT)


@pytest.mark.parametrize("files", [[DEFAULT], [DEFAULT, SMOKE]], ids=["default", "smoke"])
def test_configuration_files_are_accepted(files):
    check_configuration(load_configuration(*files))


def test_smoke_changes_values_but_not_what_is_drawn(default):
    smoke = load_configuration(DEFAULT, SMOKE)
    assert smoke["results"] != default["results"]
    for name, scene in default["scenes"]["chain"].items():
        record = smoke["scenes"]["chain"][name]["record"]
        assert record.keys() == scene["record"].keys()
        assert record["probes"].keys() == scene["record"]["probes"].keys()


def test_merge_goes_deep_and_replaces_lists():
    below = {"a": {"b": 1, "c": [1, 2, 3]}, "d": 4}
    above = {"a": {"c": [5]}}
    assert merge(below, above) == {"a": {"b": 1, "c": [5]}, "d": 4}
    assert below["a"]["c"] == [1, 2, 3]


PISTON = {"kind": "piston", "velocity": 0.05, "right": 0}


def at_velocity(velocity):
    """A start of 420 beads of which only the first moves."""
    velocities = [velocity, *[0.0] * 419]
    return {"kind": "given", "relative_displacement": [0.0] * 419, "velocity": velocities}


REFUSED = [
    ({"law__alpha": 0}, ["law.alpha is 0", "above 0"]),
    ({"law__beta": 0.5}, ["law.beta is 0.5", "limit 1", "give 1 or more"]),
    ({"law__gamma": -0.1}, ["law.gamma is -0.1", "limit 0", "give 0 or more"]),
    ({"law__gamma": ...}, ["law.gamma is missing", "add it", "viscous force"]),
    ({"law__gama": 0.1}, ["law.gama is no key", "did you mean gamma?"]),
    ({"law__colour": 1}, ["law.colour is no key", "alpha, beta, gamma"]),
    ({"law": None}, ["law is null", "a mapping of keys to values"]),
    ({"beads": 1}, ["beads is 1", "limit 2", "give 2 or more"]),
    ({"beads": 420.0}, ["beads is 420.0", "whole number"]),
    ({"beads": True}, ["beads is true", "whole number"]),
    ({"end_time": 0}, ["end_time is 0", "above 0"]),
    ({"end_time": "long"}, ['end_time is "long"', "give a number"]),
    ({"end_time": math.inf}, ["end_time is inf", "must be finite"]),
    ({"law__gamma": math.nan}, ["law.gamma is nan", "must be finite"]),
    ({"record__snapshots": [1.0, math.nan]}, ["record.snapshots (entry 2) is nan"]),
    ({"tolerance__relative": "1e-13"}, ['tolerance.relative is "1e-13"', "write 1.0e-13"]),
    ({"tolerance__relative": "1.0e-13"}, ['is "1.0e-13"', "quotes: write 1.0e-13 without them"]),
    ({"end_time": "450"}, ['end_time is "450"', "stands in quotes: write 450 without them"]),
    ({"beads": "420"}, ['beads is "420"', "stands in quotes: write 420 without them"]),
    ({"beads": "420.5"}, ['beads is "420.5": give a whole number instead']),
    ({"tolerance__absolute": "2.5E6"}, ["write 2.5e+6"]),
    (
        {"tolerance__relative": 1.0e-17},
        ["tolerance.relative is 1e-17", f"floor of {RELATIVE_TOLERANCE_FLOOR}", "or more"],
    ),
    ({"tolerance__absolute": 0.0}, ["tolerance.absolute is 0.0", "above 0"]),
    ({"boundary": {"kind": "rign"}}, ['boundary.kind is "rign"', "pressure or ring or piston"]),
    ({"boundary__left": -0.1}, ["boundary.left is -0.1", "limit 0"]),
    ({"boundary__kind": "ring"}, ["boundary.left, boundary.right are no keys"]),
    ({"boundary": PISTON | {"velocity": -1}}, ["boundary.velocity is -1", "above 0"]),
    ({"boundary": PISTON | {"ramp": -2}}, ["boundary.ramp is -2", "limit 0"]),
    ({"boundary": PISTON | {"left": 0.1}}, ["boundary.left is no key"]),
    ({"boundary": {"kind": "piston", "right": 0}}, ["boundary.velocity is missing"]),
    (
        {"boundary": PISTON, "start": at_velocity(0.2)},
        ["start.velocity begins with 0.2", "bead 1 is a piston", "give 0.05 first"],
    ),
    (
        {"boundary": PISTON | {"ramp": 3}, "start": at_velocity(0.05)},
        ["start.velocity begins with 0.05", "give 0 first"],
    ),
    ({"boundary": {"kind": "ring"}}, ["start.kind is rest", "ring", "kind given"]),
    ({"start": {"kind": "given"}}, ["start.relative_displacement is missing", "start.velocity"]),
    (
        {"start": {"kind": "given", "relative_displacement": [0.1] * 420, "velocity": [0.0] * 420}},
        ["start.relative_displacement has 420 numbers", "need 419"],
    ),
    ({"law__alpha": 0.8}, ["law.alpha is 0.8", "below 1", "uncompressed", "alpha of 1 or more"]),
    ({"record__snapshots": [450, 3000]}, ["record.snapshots (entry 2) is 3000", "end_time 2600"]),
    ({"record__grid__step": 2700}, ["record.grid.step is 2700", "end_time 2600"]),
    ({"record__probes__steady__stop": 9e3}, ["probes.steady.stop is 9000.0", "end_time 2600"]),
    ({"record__probes__steady__start": 420}, ["probes.steady.start is 420", "stop 420"]),
    (
        {"record__probes__steady__step": 400},
        ["probes.steady.step is 400", "range of 360", "give 360 or less"],
    ),
    (
        {"record__arrival_level": 1.5},
        ["arrival_level is 1.5", "stay below 1 where about 0.1 drives them", "give 0.05"],
    ),
    ({"record__probes__steady__beads": []}, ["probes.steady.beads is empty", "at least one"]),
    (
        {"record__probes__steady__beads": [50, 421]},
        ["probes.steady.beads names bead 421", "420 beads", "1 to 420"],
    ),
    ({"record__probes__steady__beads": [0]}, ["probes.steady.beads (entry 1) is 0", "limit 1"]),
    ({"record__probes__Fig 1": {}}, ['"Fig 1" in record.probes is no usable name']),
    ({"tolerance__relative": 1.0e3}, ["tolerance.relative is 1000.0", "limit 0.1", "or less"]),
    (
        {"tolerance__absolute": 1.0e-300},
        ["tolerance.absolute is 1e-300, below 1e-20", "about 0.1", "give 1.0e-21 or more"],
    ),
    ({"tolerance__absolute": 1.0e3}, ["above 0.1 of the largest", "give 1.0e-02 or less"]),
    ({"law__gamma": 1.0e300}, ["law.gamma is 1e+300", "1e±140", "nearer to 1"]),
    ({"law__alpha": 1.0e3}, ["law.alpha is 1000.0", "energies of about 1e-1001", "nearer to 1"]),
    ({"beads": 10**9}, ["beads = 1000000000", "16,004 GiB", "limit of 16 GiB", "lower beads"]),
    ({"beads": 10**30}, ["beads is 1000", "beyond what an array can hold"]),
    ({"end_time": 1.0e300}, ["end_time = 1e+300", "years on one core", "lower beads or end_time"]),
    ({"record__grid__step": 1.0e-9}, ["record.grid.step = 1e-09", "raise record.grid.step"]),
    (
        {"record__probes__steady__step": 1.0e-9},
        ["probes.steady.step = 1e-09", "53,644 GiB", "raise record.probes.steady.step"],
    ),
    ({"record__snapshots": [450, 450.0]}, ["record.snapshots (entry 2) is 450.0", "list it once"]),
    (
        {"record__probes__grid": {"beads": [1], "start": 0, "stop": 1, "step": 1}},
        ["record.probes.grid has the name", "another name"],
    ),
    ({"record__snapshots": []}, ["record.snapshots is empty", "figure 1 needs it"]),
    ({"record__probes__transient": ...}, ["probes.transient is missing", "figure 1 needs it"]),
    ({"record__extremes": False}, ["record.extremes is empty or off", "printed numbers"]),
    ({"record__extremes": "yes"}, ['record.extremes is "yes"', "true or false"]),
]


@pytest.mark.parametrize(("changes", "words"), REFUSED, ids=[str(c)[:50] for c, _ in REFUSED])
def test_impossible_scene_is_refused_in_a_sentence(default, changes, words):
    sentence = refusal(change(default, **changes))
    assert sentence.startswith(f"Scene {SCENE}: ")
    assert sentence.endswith((".", "?"))
    for word in words:
        assert word in sentence


HETEROCLINIC_REFUSED = [
    ({"mu": []}, ["mu is empty", "at least one"]),
    ({"mu": [0.3, -1]}, ["mu (entry 2) is -1", "limit 0"]),
    ({"mu": [0.3, math.inf]}, ["mu (entry 2) is inf", "must be finite"]),
    ({"mu": [0.3, 2, 0.3]}, ["mu (entry 3) is 0.3", "list it once"]),
    ({"profile__start": 10}, ["profile.start is 10", "stop 10"]),
    ({"profile__step": 0}, ["profile.step is 0", "above 0"]),
    ({"profile__step": 60}, ["profile.step is 60", "range of 50", "give 50 or less"]),
    ({"well__step": 2}, ["well.step is 2", "range of 1.75", "(limit)"]),
    ({"portrait__step": 26}, ["portrait.step is 26", "range of 25", "(span)"]),
    ({"profile__step": 1.0e-9}, ["profile.step = 1e-09", "2,980 GiB", "raise profile.step"]),
    ({"portrait__step": 1.0e-9}, ["portrait.step = 1e-09", "GiB", "raise portrait.step"]),
    ({"portrait__mu": 0.5}, ["portrait.mu is 0.5", "one of mu [0.3, 2]", "add 0.5 to mu"]),
    ({"mu": [0.3, 1e-300]}, ["mu (entry 2) is 1e-300", "give 0, or 1e-280 or more"]),
    ({"mu": [0.3, 0], "profile__stop": 53}, ["profile.stop is 53", "mu = 0", "s = 52.40"]),
    ({"mu": [0.3, 0], "profile__start": -57}, ["profile.start is -57", "s = -56.77"]),
    ({"profile__stop": 1e6}, ["profile.stop is 1000000.0", "s = 54.50"]),
    ({"well": ...}, ["well is missing", "figure 8 needs it"]),
    ({"portrait__starts": []}, ["portrait.starts is empty"]),
    ({"portrait__starts": [[0.5, 0], [-1, 0]]}, ["starts (entry 2) is [-1, 0]", "equilibrium"]),
    ({"well__limit": -1}, ["well.limit is -1", "above 0"]),
]


@pytest.mark.parametrize(
    ("changes", "words"), HETEROCLINIC_REFUSED, ids=[str(c)[:50] for c, _ in HETEROCLINIC_REFUSED]
)
def test_impossible_heteroclinic_scene_is_refused_in_a_sentence(default, changes, words):
    sentence = refusal(change(default, "heteroclinic", "front_profiles", **changes))
    assert sentence.startswith("Scene front_profiles: ")
    for word in words:
        assert word in sentence


def test_heteroclinic_scene_may_leave_out_what_only_the_figure_needs():
    scene = {"mu": np.array([0.3]), "profile": {"start": -1, "stop": np.float64(1), "step": 0.5}}
    assert check_scene("heteroclinic", scene, "mine")["mu"] == [0.3]


def test_checking_waits_for_no_heavy_import():
    module = "granular_fronts.scenes.configuration"
    code = f"import {module}, sys; print({{'numpy', 'numba'}} & set(sys.modules))"
    environment = {"PYTHONPATH": str(ROOT / "src")}
    command = [sys.executable, "-c", code]
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert run.stdout == "set()\n"


def test_every_mistake_is_named_at_once(default):
    sentences = refusal(change(default, law__alpha=-1, beads=0)).splitlines()
    assert len(sentences) == 2


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


def set_value(configuration, path, value):
    """Set the value at a dotted path."""
    # Anchors of YAML let sections share a mapping; JSON writes each of them out.
    changed = json.loads(json.dumps(configuration))
    *parents, last = path.split(".")
    node = functools.reduce(operator.getitem, parents, changed)
    node[last] = value
    return changed


FRONT = {
    "law": {"alpha": 1.5, "gamma": 0.06},
    "displacement": 0.1,
    "window": {"start": -40, "stop": 5, "step": 0.02},
    "driven_bead": 400,
}
ORBIT = {"mu": [1], "profile": {"start": -1, "stop": 1, "step": 0.5}}
MATERIAL = "laws.materials.beads.glass"
SECTIONS_REFUSED = [
    # Numbers that are not finite.
    ("exact_fronts.survey.alpha", [1.1, math.nan], ["alpha (entry 2) is nan", "finite"]),
    ("exact_fronts.critical_damping.overshoot_cut", math.nan, ["is nan", "finite"]),
    ("laws.materials.impact_velocity", math.nan, ["is nan", "finite"]),
    ("laws.piston.velocity", math.nan, ["is nan", "finite"]),
    ("stiff_damping.gammas", [math.nan], ["gammas (entry 1) is nan", "finite"]),
    ("front_exponents", [1.5, math.inf], ["front_exponents (entry 2) is inf", "finite"]),
    ("chunk_seconds", math.inf, ["is inf", "finite"]),
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
    ("stiff_damping.repeats", 10**12, ["repeats = 1000000000000", "years", "lower repeats"]),
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


def test_what_is_large_but_possible_is_accepted(default):
    """A hundred thousand beads for an hour, a thousand snapshots, ten million samples."""
    large = change(
        default,
        beads=100_000,
        record__grid__step=500,
        record__probes__steady__step=3.6e-5,
    )
    check_configuration(large)


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


@pytest.mark.parametrize(
    ("results", "words"),
    [
        ("~/x", ["results is ~/x", f"write {Path.home()}/x"]),
        ("a{b}", ["'{}'", "use letters"]),
        (" a", ["blanks", "use letters"]),
        ("pyproject.toml/results", ["pyproject.toml is a file", "name a folder"]),
    ],
)
def test_folder_that_cannot_receive_results_is_refused(monkeypatch, results, words):
    monkeypatch.chdir(ROOT)
    [sentence] = folder_errors(results)
    for word in words:
        assert word in sentence


def test_folder_that_is_not_writable_is_refused(monkeypatch, tmp_path):
    monkeypatch.setattr("os.access", lambda path, mode: path != tmp_path)
    [sentence] = folder_errors(str(tmp_path / "new" / "results"))
    assert f"nothing can be written into {tmp_path}" in sentence


@pytest.mark.parametrize("results", ["results", "results/smoke", "/tmp", "resultate-2é"])
def test_usual_folder_is_accepted(results):
    assert not [*folder_errors(results)]


def test_mapping_after_config_names_the_way():
    [sentence] = argument_errors({"scenes": {"chain": {}}, "results": "x", "chunk_seconds": 3})
    assert "--config scenes=…" in sentence
    assert "--configfile mine.yaml" in sentence


YAML_REFUSED = [
    ("a: b: c", ["line 1, column 5", "no YAML", "correct it"]),
    ("a:\n\tb: 1", ["line 2, column 1", "no YAML"]),
    ("a: 1\nb: {c: 1, d: 2, c: 3}", ["line 2, column 17", "the key c stands twice", "keep one"]),
    ("a: 1\nb: 2\na: 3", ["line 3, column 1", "the key a stands twice"]),
    ("[1, 2]", ["holds no mapping", "write key: value"]),
    ("a: \x00", ["is no YAML"]),
]


@pytest.mark.parametrize(("text", "words"), YAML_REFUSED)
def test_wrong_yaml_is_refused_with_its_place(tmp_path, text, words):
    file = tmp_path / "mine.yaml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load_configuration(DEFAULT, file)
    [sentence] = str(caught.value).splitlines()
    assert sentence.startswith(str(file))
    for word in words:
        assert word in sentence


def test_missing_file_is_refused_in_a_sentence(tmp_path):
    with pytest.raises(InputError, match=r"nosuch\.yaml cannot be read .* name a text file"):
        load_configuration(tmp_path / "nosuch.yaml")


def test_merged_keys_may_be_overridden(tmp_path):
    """The key that overrides a merged one stands once; so it does where it is merged again."""
    file = tmp_path / "mine.yaml"
    text = "a: &a {x: 1, y: 2}\nb: &b\n  <<: *a\n  x: 3\nc:\n  <<: *b\n  y: 4\nd: *b"
    file.write_text(text, encoding="utf-8")
    loaded = load_configuration(file)
    assert loaded["c"] == {"x": 3, "y": 4}
    assert loaded["d"] == {"x": 3, "y": 2}


def test_missing_key_is_described_by_its_definition(default):
    del default["exact_fronts"]["survey"]["gamma"]
    sentence = "exact_fronts.survey.gamma is missing: add it (Dampings at equal ratios)."
    assert refusal(default) == sentence


def test_probes_may_have_the_names_of_limits(default):
    record = default["scenes"]["chain"][SCENE]["record"]
    for name in ("start", "stop", "step", "limit", "span"):
        record["probes"][name] = record["probes"]["steady"]
    check_configuration(default)


def test_single_scene_is_checked_under_its_own_name(default):
    scene = change(default, law__gamma=-1)["scenes"]["chain"][SCENE]
    with pytest.raises(InputError, match=r"^Scene mine: law\.gamma is -1"):
        check_scene("chain", scene, "mine")


def test_single_scene_may_hold_numpy_values(default):
    scene = change(
        default,
        beads=np.int64(3),
        law__gamma=np.float64(0.1),
        record={"snapshots": np.array([1.0, 2.0])},
        boundary={"kind": "ring"},
        start={"kind": "given", "relative_displacement": np.ones(3), "velocity": np.zeros(3)},
    )["scenes"]["chain"][SCENE]
    checked = check_scene("chain", scene, "mine")
    assert checked["start"]["velocity"] == [0.0, 0.0, 0.0]
    assert type(checked["beads"]) is int


def dry_run(*arguments):
    command = [sys.executable, "-m", "snakemake", "--cores", "1", "--dry-run", *arguments]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


def test_workflow_finds_a_repeated_key_in_the_file_of_the_user(tmp_path):
    """Snakemake hands over the merged values only, in which one of the two is lost."""
    file = tmp_path / "mine.yaml"
    file.write_text("results: results/a\nresults: results/b\n", encoding="utf-8")
    run = dry_run("fig04", "--configfile", str(file))
    assert run.returncode == 1
    assert f"{file}, line 2, column 1: the key results stands twice" in run.stderr
    assert "Traceback" not in run.stderr


def test_workflow_names_the_way_beside_mappings_on_the_command_line():
    run = dry_run("fig04", "--config", "scenes={chain: {a: {law: {gamma: 0.2}}}}")
    assert run.returncode == 1
    assert "--configfile mine.yaml" in run.stderr
    assert "Traceback" not in run.stderr


@pytest.mark.parametrize("name", ["Smoke", "nosuch"])
def test_workflow_says_which_campaigns_there_are(name):
    run = dry_run("campaign", "--config", f"campaign={name}")
    assert run.returncode == 1
    assert f"There is no campaign {name}" in run.stderr
    assert "choose one of driven_chain" in run.stderr


def test_wrong_file_is_located_from_the_command_line(tmp_path):
    file = tmp_path / "mine.yaml"
    file.write_text("a: b: c", encoding="utf-8")
    command = [sys.executable, "-m", "granular_fronts.scenes", DEFAULT, file]
    environment = {"PYTHONPATH": str(ROOT / "src")}
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert run.returncode == 1
    assert run.stderr.startswith(f"{file}, line 1, column 5: this is no YAML")
