"""Scenes and sections of the configuration: accepted, or refused by key, value and limit."""

import json
import time
import tracemalloc

import numpy as np
import pytest
from configurations import SCENE, assert_refused, change, refusal, set_value

from granular_fronts.errors import InputError
from granular_fronts.scenes import memory
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.configuration import SCENES, check_configuration
from granular_fronts.scenes.orbit import Orbits

PISTON = {"kind": "piston", "velocity": 0.05, "right": 0}


@pytest.fixture(autouse=True)
def sixteen_gibibytes(monkeypatch):
    """What is refused must not depend on the machine of the test."""
    monkeypatch.setattr(memory, "memory_of_machine", lambda: 16 * 2**30)


def given(displacements, *velocities):
    """A start of 420 beads, of which the first moves."""
    velocity = [*velocities, *[0.0] * (420 - len(velocities))]
    return {"kind": "given", "relative_displacement": displacements, "velocity": velocity}


def at_velocity(velocity):
    return given([0.0] * 419, velocity)


PROBE = {"beads": [1], "start": 0, "stop": 1, "step": 1}
STEADY = "record__probes__steady__"
CHAIN_REFUSED = [
    # What the schema says.
    ({"law__alpha": 0}, "law.alpha is 0 | above 0"),
    ({"law__gamma": -0.1}, "law.gamma is -0.1 | limit 0"),
    ({"law__gamma": ...}, "law.gamma is missing | viscous force"),
    ({"law": None}, "law is null"),
    ({"beads": 1}, "beads is 1 | limit 2"),
    ({"beads": 420.0}, "beads is 420.0"),
    ({"beads": True}, "beads is true"),
    ({"beads": 10**30}, "beads is 1000000000000000000000000000000 | beyond what an array"),
    ({"beads": "420.5"}, 'beads is "420.5"'),
    ({"law__alpha": "1,5"}, 'law.alpha is "1,5" | no comma | write 1.5'),
    ({"law__alpha": "1,500"}, 'law.alpha is "1,500" | no comma | point'),
    ({"law__gamma": "1,5e-3"}, 'law.gamma is "1,5e-3" | write 0.0015'),
    ({"law__alpha": "3/2"}, 'law.alpha is "3/2" | write 1.5'),
    ({"law__alpha": "3/0"}, 'law.alpha is "3/0" | give a number'),
    ({"end_time": ".5e3"}, 'end_time is ".5e3" | write 500'),
    ({"boundary__left": "−1e-20"}, 'boundary.left is "−1e-20" | write -1.0e-20'),
    ({"beads": 4.2e2}, "beads is 420.0 | whole: write 420"),
    ({"beads": "840/2"}, 'beads is "840/2" | write 420'),
    ({"beads": 1e30}, "beads is 1e+30 | give a whole number"),
    ({"law": {"alpha": 1, 5: None, "beta": 1, "gamma": 1}}, "law.5 is no key | no comma | point"),
    ({"end_time": 10**400}, "beyond what an array can hold"),
    ({"end_time": 0}, "end_time is 0 | above 0"),
    ({"end_time": "long"}, 'end_time is "long"'),
    ({"tolerance__relative": "1.0e-13"}, 'relative is "1.0e-13" | write 1.0e-13'),
    ({"tolerance__relative": "1e-13"}, 'relative is "1e-13" | exponent | write 1.0e-13'),
    ({"boundary": {"kind": "rign"}}, 'boundary.kind is "rign" | pressure or ring or piston'),
    ({"boundary__kind": "ring"}, "boundary.left is no key\nboundary.right is no key"),
    ({"start": {"kind": "given"}}, "relative_displacement is missing\nvelocity is missing"),
    ({"boundary": PISTON | {"ramp": -2}}, "boundary.ramp is -2 | limit 0"),
    ({f"{STEADY}beads": []}, "record.probes.steady.beads is empty"),
    ({"record__probes__Fig 1": PROBE}, '"Fig 1" in record.probes'),
    ({"record__probes": {3: PROBE}}, "3 in record.probes is no usable name"),
    ({"record__snapshots": {1.0, 2.0}}, 'record.snapshots is "{1.0, 2.0}" | give a list'),
    ({"start": given([[0.1]] * 419)}, "start.relative_displacement (entry 1) is [0.1]"),
    (
        {"law": {"elastic": {"kind": "toda", "rate": [1]}}},
        "elastic.rate is [1] | give a number",
    ),
    ({"record__snapshots": [450, 450.0]}, "record.snapshots (entry 2) is 450.0"),
    # What ties keys together.
    ({"tolerance__relative": 9.0e-16}, "tolerance.relative is 9e-16 | 1e-15"),
    ({"tolerance__absolute": 9.9e-22}, "absolute is 9.9e-22, below 1e-20 | about 0.1 | 1.0e-21"),
    ({"tolerance__absolute": 0.011}, "tolerance.absolute is 0.011, above 0.1 | 1.0e-02"),
    ({"boundary__left": -0.1}, "boundary.left is -0.1 | limit 0"),
    ({"boundary": PISTON | {"velocity": -1}}, "boundary.velocity is -1 | above 0"),
    ({"boundary": PISTON, "start": at_velocity(0.2)}, "start.velocity begins with 0.2 | give 0.05"),
    (
        {"boundary": PISTON | {"ramp": 3}, "start": at_velocity(0.05)},
        "start.velocity begins with 0.05 | give 0 first",
    ),
    ({"boundary": {"kind": "ring"}}, "start.kind is rest | ring"),
    ({"start": given([0.1] * 420)}, "start.relative_displacement has 420 numbers | 419"),
    (
        {"start": given([0.1] * 419), "boundary": {"kind": "ring"}},
        "start.relative_displacement has 419 numbers | 420",
    ),
    ({"law__alpha": 0.8}, "law has alpha 0.8, below 1"),
    ({"record__snapshots": [450, 2601]}, "record.snapshots (entry 2) is 2601 | end_time 2600"),
    ({"record__grid__step": 2700}, "record.grid.step is 2700 | end_time 2600"),
    ({f"{STEADY}stop": 9e3}, "record.probes.steady.stop is 9000 | end_time 2600"),
    ({f"{STEADY}start": 420}, "record.probes.steady.start is 420 | stop 420"),
    ({f"{STEADY}step": 400}, "record.probes.steady.step is 400 | 360"),
    ({f"{STEADY}beads": [420, 421]}, "record.probes.steady.beads names bead 421 | 1 to 420"),
    ({"record__probes__grid": PROBE}, "probes.grid has"),
    ({"record__arrival_level": 1.5}, "record.arrival_level is 1.5 | below 1 where about 0.1"),
    ({"law__alpha": -1, "beads": 0}, "law.alpha is -1 | above 0\nbeads is 0 | limit 2"),
    ({"law__alpha": 150}, "law has alpha 150 | energies of about 1e-151 | 1e±140"),
    ({"law__gamma": 1e141}, "law has gamma 1e+141 | 1e±140"),
    # Sizes, as numbers that a mistake in their formula changes.
    ({"beads": 10**9}, "beads is 1000000000 and end_time is 2600 | 16,004 GiB | the 16 GiB"),
    ({f"{STEADY}step": 1.0e-9}, "record.probes.steady.step is 1e-09 | 53,644 GiB"),
]
ORBIT_REFUSED = [
    ({"mu": [0.3, 2, 0.3]}, "mu (entry 3) is 0.3"),
    ({"mu": [0.3, 9e-281]}, "mu (entry 2) is 9e-281 | 1e-280"),
    ({"profile__start": 10}, "profile.start is 10 | stop 10"),
    ({"profile__step": 60}, "profile.step is 60 | 50"),
    ({"profile__step": 1.0e-9}, "profile.step is 1e-09 | 2,980 GiB"),
    ({"mu": [0.3, 0], "profile__stop": 53}, "profile.stop is 53 | mu = 0 | s = 52.40"),
    ({"mu": [0.3, 0], "profile__start": -57}, "profile.start is -57 | s = -56.77"),
    ({"profile__stop": 1e6}, "profile.stop is 1000000 | s = 54.50"),
    ({"well__step": 2}, "well.step is 2 | 1.75"),
    ({"portrait__mu": 0.5}, "portrait.mu is 0.5 | [0.3, 2]"),
    ({"portrait__starts": []}, "portrait.starts is empty"),
    ({"portrait__starts": [[0.5]]}, "portrait.starts (entry 1) has 1 entry | list 2"),
    ({"portrait__starts": [[0.5, 0], [-1, 0]]}, "portrait.starts (entry 2) is [-1, 0]"),
]
SCENES_REFUSED = [
    *[("chain", SCENE, *row) for row in CHAIN_REFUSED],
    *[("heteroclinic", "front_profiles", *row) for row in ORBIT_REFUSED],
]


@pytest.mark.parametrize(
    ("family", "name", "changes", "words"), SCENES_REFUSED, ids=[row[3] for row in SCENES_REFUSED]
)
def test_impossible_scene_is_refused(default, family, name, changes, words):
    scene = change(default, family, name, **changes)["scenes"][family][name]
    with pytest.raises(InputError, match=r"^Scene mine: ") as caught:
        SCENES[family].read(scene, "mine")
    assert_refused(str(caught.value), words)


@pytest.mark.parametrize("beads", [10**9, 10**13, {"count": 10**9, "cell": ["steel 9.5 mm"]}])
def test_many_beads_are_refused_at_once_and_without_memory(default, beads):
    scene = change(default)["scenes"]["chain"][SCENE]
    Chain.read(scene, "mine")
    scene["beads"] = beads
    tracemalloc.start()
    start = time.process_time()
    with pytest.raises(InputError, match="GiB of memory are needed, above the 16 GiB"):
        Chain.read(scene, "mine")
    assert time.process_time() - start < 1.0
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 10 * 2**20


FRONT = {
    "law": {"alpha": 1.5, "gamma": 0.06},
    "displacement": 0.1,
    "window": {"start": -40, "stop": 5, "step": 0.02},
    "driven_bead": 400,
}
ORBIT = {"mu": [1], "profile": {"start": -1, "stop": 1, "step": 0.5}}
FRONT_SCENE = "scenes.front.underdamped"
BALL = {"gamma": 0.05, "mass": 0.147, "radius": 0.0165}
GLASS, STATES = "laws.materials.beads.glass", "laws.jump_conditions.cases.mine"
RING = "scenes.periodic.weak"
THETA, HALF_STEPS = "laws.numerical_damping", "laws.half_step_damping"
BEADS, HEAVY = "scenes.chain.initiation_overdamped.beads", {"impurity": {"bead": 30, "mass": 5}}


def lattice(elastic, *states):
    return {"elastic": elastic, "dissipation": {"kind": "linear", "gamma": 1}, "states": [*states]}


SECTIONS_REFUSED = [
    ("exact_fronts.survey.gamma", ..., "survey.gamma is missing | Dampings at equal ratios"),
    # Entries listed twice, unknown names, what is no mapping.
    ("exact_fronts.survey.alpha", [1.1, 1.5, 1.1], "exact_fronts.survey.alpha (entry 3) is 1.1"),
    ("hard_cases", ["gama_zero"], '"gama_zero" | did you mean gamma_zero?'),
    (RING, None, f"{RING} is null"),
    ("precision.chain.contact_loss.own_tolerances", {"scipy_dop835": [1e-4]}, '"scipy_dop835"'),
    # Names that clash, or that nothing has.
    ("scenes.front.survey", FRONT, "scenes.front.survey has the name of the study survey"),
    ("scenes.heteroclinic.weak", ORBIT, "weak has the name of scenes.heteroclinic.weak"),
    ("precision.log_burgers.nosuch", ..., "nosuch names no periodic scene | weak, hertz"),
    # Counts and steps beyond the schema's limits.
    ("proofs.intervals.hertz.parts", [{"to": 1, "chunks": 10**9}], "chunks is 1000000000 | 10000"),
    ("exact_fronts.survey.gamma.num", 10**9, "num is 1000000000 | limit 10000"),
    ("exact_fronts.multipliers.beads_behind", [10**6], "(entry 1) is 1000000 | 2000"),
    ("laws.damping_regimes.points", 10**9, "points is 1000000000 | 100000"),
    ("laws.jump_conditions.beads", 10**9, "beads is 1000000000 | 100000"),
    (f"{THETA}.profile.step", 1e-12, "profile.step is 1e-12 | 1e-06"),
    (f"{THETA}.order.steps", [0.24], "order.steps has 1 entry | limit 3"),
    (f"{HALF_STEPS}.alpha", 2, "alpha is 2 | limit 1.5"),
    (f"{HALF_STEPS}.gammas", [0.05, 0.2], "gammas (entry 2) is 0.2 | limit 0.13"),
    (f"{STATES}", lattice({"kind": "toda"}, -1, -0.5, 0), "states has 3 entries: list 2"),
    ("precision.chain.contact_loss.repeats", 10**12, "repeats is 1000000000000 | 1000 or"),
    ("precision.chain.contact_loss.end_time", 1e300, "end_time is 1e+300 | 10000"),
    ("precision.log_burgers.weak.longest_steps", [1e-30], "(entry 1) is 1e-30 | 1e-06"),
    ("precision.log_burgers.weak.reference.points", 9, "points is 9 | multiple of 2"),
    (BEADS, {"count": 9, "mass": {"taper": {"ratio": -1}}}, "ratio is -1 | above 0"),
    (BEADS, {"count": 1}, "beads.count is 1 | 2"),
    (BEADS, {"count": 10**9, "cell": ["steel 9.5 mm"]}, "beads.count is 1000000000 | GiB"),
    (BEADS, {"count": 20, "mass": HEAVY}, "impurity is at 30 | there are 20"),
    # Sizes.
    ("scenes.front.underdamped.window.step", 1e-9, "window.step is 1e-09 | 8,047 GiB"),
    ("scenes.front.underdamped.driven_bead", 10**8, "driven_bead is 100000000 | 48 GiB"),
    (f"{RING}.record.grid.step", 1e-9, "record.grid.step is 1e-09 | 1e+06 GiB"),
    (f"{RING}.equations.unlimited.cells", 10**8, "equations.unlimited.cells is 100000000 | 48 GiB"),
    (
        HALF_STEPS,
        {"collision_times": 1000, "steps_per_collision": [10, 99, 10**4]},
        "collision_times is 1000 and | 18 GiB",
    ),
    # Fronts.
    (f"{FRONT_SCENE}.law.alpha", 1, "law.alpha is 1 | above 1"),
    (f"{FRONT_SCENE}.law.gamma", 0, "law.gamma is 0 | above 0"),
    (f"{FRONT_SCENE}.displacement", 0, "displacement is 0 | above 0"),
    (f"{FRONT_SCENE}.driven_bead", 2, "driven_bead is 2 | limit"),
    # Equations of a ring.
    (f"{RING}.equations", {}, "weak: equations is empty"),
    (f"{RING}.equations.logarithmic", ..., "logarithmic is missing | equations.upwind"),
    # Waves of the limiting cases.
    ("laws.limiting_cases.beads", 275, "beads is 275 | 276"),
    ("laws.limiting_cases.end_time", 31.9, "end_time is 31.9 | strong_gamma 1 | 32"),
    ("laws.limiting_cases.strong_gamma", 40, "end_time is 240, | strong_gamma 40 | 656"),
    # Units.
    (f"{GLASS}.radius", 19.6, "radius is 19.6 | 2.5e-06 kg/m³ | 1 to 30000"),
    ("laws.materials.beads", {"steal": BALL}, "beads.steal: | did you mean steel?"),
    # Ranges and steps.
    ("laws.damping_regimes.alpha", "3/2", 'alpha is "3/2" | write 1.5'),
    ("laws.damping_regimes.points", 4.2e2, "points is 420.0 | whole: write 420"),
    ("exact_fronts.survey.gamma.start", 2, "survey.gamma.start is 2 | stop 2"),
    (f"{THETA}.profile.step", 0.7, "profile.step is 0.7"),
    # Laws, states, what is shown.
    (f"{HALF_STEPS}.shown.beta", 1.1, "shown.beta is 1.1 | 1.5, 1.25, 1"),
    (STATES, lattice({"kind": "toda"}, -2, -2), "cases.mine.states are -2 and -2"),
    (STATES, lattice({"kind": "hertz", "alpha": 2}, 0, 1), "cases.mine.states are 0 and 1"),
    (STATES, lattice({"kind": "lennard_jones"}, -5, 0), "cases.mine.states has -5 | -1 and inf"),
    ("proofs.fronts.hertz_1.gamma", [0.31, 0.3], "fronts.hertz_1.gamma goes from 0.31 to 0.3"),
    ("proofs.fronts.hertz_1.gamma", [0.3, 0.3], "fronts.hertz_1.gamma goes from 0.3 to 0.3"),
    ("proofs.shown", "dashpots_0_3", "shown is dashpots_0_3, with β = 1"),
    ("proofs.shown", "nosuch", "shown is nosuch | figure_1"),
]


def with_change(configuration, path, value):
    """Set a value; a mapping is laid over the one there, an ellipsis copies or takes away."""
    *parents, last = path.split(".")
    node = configuration = json.loads(json.dumps(configuration))
    for parent in parents:
        node = node.setdefault(parent, {})
    if value is ...:
        if last in node:
            del node[last]
        else:
            node[last] = next(iter(node.values()))
    elif isinstance(value, dict) and value and isinstance(node.get(last), dict):
        node[last].update(value)
    else:
        node[last] = value
    return configuration


@pytest.mark.parametrize(
    ("path", "value", "words"), SECTIONS_REFUSED, ids=[row[2] for row in SECTIONS_REFUSED]
)
def test_impossible_section_is_refused(default, path, value, words):
    assert_refused(refusal(with_change(default, path, value)), words)


@pytest.mark.parametrize(
    ("configuration", "words"),
    [
        ({}, "scenes is missing"),
        (None, "the file is null"),
        ({"results": "", "scenes": {"chain": {}}}, "results is empty"),
        ({"results": "results", "scenes": {"chain": {}}}, "scenes.heteroclinic is missing"),
        ({"results": "results", "scenes": {"chian": {}}}, "did you mean chain?"),
        ({"results": "results", "scenes": {"chain": {1: {}}}}, "1 in scenes.chain is no usable"),
    ],
)
def test_impossible_configuration_outside_scenes_is_refused(configuration, words):
    assert words in refusal(configuration)


@pytest.mark.parametrize(
    ("family", "name", "scene", "words"),
    [
        ("chain", "initiation_underdampt", {"beads": 9}, "lacks law | initiation_underdamped?"),
        ("chain", "initiation_underdampt", {"beads": "x"}, "mean initiation_underdamped?"),
        ("chain", "initiation_underdampt", 3, "initiation_underdampt is 3"),
        ("chain", "dimer", {"beads": 40}, "law is missing"),
        ("heteroclinic", "damping_swep", {"mu": [1]}, "lacks profile | mean damping_sweep?"),
    ],
)
def test_scene_with_a_misspelt_name_is_one_sentence(default, family, name, scene, words):
    default["scenes"][family][name] = scene
    found = refusal(default).splitlines()
    assert_refused(found[0], words)
    assert (len(found) == 1) == (name != "dimer")


@pytest.mark.parametrize("key", ["law", "boundary", "start"])
def test_a_key_without_a_value_is_one_sentence(default, key):
    for value in (None, ...):
        assert_refused(refusal(change(default, **{key: value})), f"{key} is")


LARGE = {"beads": 100_000, "record__grid__step": 500, f"{STEADY}step": 3.6e-5}
PISTON_FOR_EVER = {"boundary": PISTON, "end_time": 1e12, "record__grid__step": 1e9}


@pytest.mark.parametrize(
    ("changes"),
    [
        *({f"record__probes__{name}": PROBE} for name in ("start", "stop", "step", "limit")),
        {"record__probes__span": PROBE, f"{STEADY}beads": [1, 420]},
        # A hundred thousand beads for an hour, a thousand snapshots, ten million samples.
        LARGE,
        # Beads thrown off a free end cost nothing.
        PISTON_FOR_EVER,
    ],
)
def test_what_is_large_or_odd_but_possible_is_accepted(default, changes):
    check_configuration(change(default, **changes))


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("laws.damping_regimes", {"alpha": 2, "betas": [1, 1.5, 2, 3], "decades": 5, "points": 9}),
        ("scenes.heteroclinic.damping_sweep.mu", [1, 2]),
    ],
)
def test_other_values_of_parameters_than_those_of_the_paper_are_accepted(default, path, value):
    """The table of printed numbers leaves out what it cannot measure."""
    check_configuration(set_value(default, path, value))


def test_single_scene_is_checked_under_its_own_name_and_may_hold_numpy_values(default):
    scene = change(
        default,
        beads=np.int64(3),
        law__gamma=np.float64(0.1),
        record={"snapshots": np.array([1.0, 2.0])},
        boundary={"kind": "ring"},
        start={"kind": "given", "relative_displacement": np.ones(3), "velocity": np.zeros(3)},
    )["scenes"]["chain"][SCENE]
    checked = Chain.read(scene, "mine")
    assert checked.start.velocity == (0.0, 0.0, 0.0)
    assert type(checked.beads.count) is int
    with pytest.raises(InputError, match=r"^Scene mine: law\.gamma is -1"):
        Chain.read(scene | {"law": scene["law"] | {"gamma": -1}}, "mine")
    orbit = {"mu": np.array([0.3]), "profile": {"start": -1, "stop": np.float64(1), "step": 0.5}}
    assert Orbits.read(orbit, "mine").mu == (0.3,)
