"""Whatever is impossible is refused in sentences: key, value and limit, and the way out."""

import functools
import json

import numpy as np
import pytest
from configurations import DEFAULT, SCENE, assert_refused, change
from rings import scene_with

import granular_fronts as gf
from granular_fronts.campaign.definition import check_campaign
from granular_fronts.continuum.evolution import evolve_unlimited
from granular_fronts.errors import InputError
from granular_fronts.model.scaling import Scaling
from granular_fronts.scenes import memory
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.configuration import SCENES, check_configuration
from granular_fronts.scenes.yaml_files import load_configuration

DEFAULTS = load_configuration(DEFAULT)


@pytest.fixture(autouse=True)
def sixteen_gibibytes(monkeypatch):
    """What is refused must not depend on the machine of the test."""
    monkeypatch.setattr(memory, "memory_of_machine", lambda: 16 * 2**30)


# Scenes of chains and of orbits, of which some keys are changed.

PISTON = {"kind": "piston", "velocity": 0.05, "right": 0}


def scene(family, name):
    def read(changes):
        SCENES[family].read(
            change(DEFAULTS, family, name, **changes)["scenes"][family][name], "mine"
        )

    return read


def given(displacements, *velocities):
    """A start of 420 beads, of which the first moves."""
    velocity = [*velocities, *[0.0] * (420 - len(velocities))]
    return {"kind": "given", "relative_displacement": displacements, "velocity": velocity}


def at_velocity(velocity):
    return given([0.0] * 419, velocity)


PROBE = {"beads": [1], "start": 0, "stop": 1, "step": 1}
STEADY = "record__probes__steady__"
CHAINS = [
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
    ({"law__alpha": "1,500"}, 'law.alpha is "1,500" | no comma: write a point'),
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
ORBITS = [
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

# Chains of laws of potentials.

TODA = {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.3}}
BARRIER = gf.Potential(
    lambda r: -np.log(-r),
    lambda r: -1.0 / r,
    lambda r: r**-2.0,
    interval=(-2.0, -0.01),
    name="−ln(−r)",
)


def chain_of(changes):
    chain = {"beads": 20, "boundary": pressed(0.3), "start": {"kind": "rest"}, "end_time": 12.0}
    chain |= {"tolerance": {"relative": 1e-9, "absolute": 1e-11}, "record": {"snapshots": [12.0]}}
    Chain.read(chain | changes, "mine")


def pressed(left, right=0.0):
    return {"kind": "pressure", "left": left, "right": right}


def of(kind, **parameters):
    return {"law": {"elastic": {"kind": kind, **parameters}}}


POWERS = {"law": {"alpha": 1.5, "beta": 2.5, "gamma": 0.2}}
CHAINS_OF_LAWS = [
    ({"law": TODA | {"alpha": 1.5}}, "law.alpha is no key"),
    (of("toda", rate=0), "law: rate is 0 | above 0"),
    ({"law": {"elastic": {"rate": 1}}}, "law.elastic.kind is missing"),
    ({"law": {"viscous": {"kind": "none"}}}, "law.elastic is missing"),
    (of("lennard_jones", distance=0.2), "boundary.left is 0.3 | 0.2 only"),
    (of("hertz", alpha=0.5), "law has alpha 0.5, below 1"),
    (of("hertz", alpha=300), "law has alpha 300 | energies of about 1e-157 | 1e±140"),
    (
        {"law": TODA, "boundary": pressed(1e-200)},
        "law.elastic | about 1e-200 | energies of about 1e-323 | 1e±140\n"
        "law.viscous | about 1e-200 | 1e±140",
    ),
    (POWERS | {"boundary": pressed(-0.1)}, "boundary.left is -0.1 | limit 0"),
    (POWERS | {"record": {"snapshots": [], "arrival_level": -0.1}}, "level is -0.1 | above 0"),
    (
        {"law": gf.make_law(elastic=BARRIER), "boundary": {"kind": "piston", "velocity": 0.0}},
        "boundary.right is 0 | between 0.01 and 2\nstart.relative_displacement of a",
    ),
    (
        {"law": gf.make_law(elastic=BARRIER), "boundary": pressed(0.5, 0.4)},
        "start.relative_displacement of a chain at rest is 0",
    ),
]


# Sections of the configuration, of which one value is changed.

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
THETA = "laws.numerical_damping"
BEADS, HEAVY = "scenes.chain.initiation_overdamped.beads", {"impurity": {"bead": 30, "mass": 5}}


def lattice(elastic, *states):
    return {"elastic": elastic, "dissipation": {"kind": "linear", "gamma": 1}, "states": [*states]}


SECTIONS = [
    (("exact_fronts.survey.gamma", ...), "survey.gamma is missing | Dampings at equal ratios"),
    # Entries listed twice, unknown names, what is no mapping.
    (("exact_fronts.survey.alpha", [1.1, 1.5, 1.1]), "exact_fronts.survey.alpha (entry 3) is 1.1"),
    ((RING, None), f"{RING} is null"),
    # Names that clash, or that nothing has.
    (("scenes.front.survey", FRONT), "scenes.front.survey has the name of the study survey"),
    (("scenes.heteroclinic.weak", ORBIT), "weak has the name of scenes.heteroclinic.weak"),
    # Counts and steps beyond the schema's limits.
    (("exact_fronts.survey.gamma.num", 10**9), "num is 1000000000 | limit 10000"),
    (("exact_fronts.multipliers.beads_behind", [10**6]), "(entry 1) is 1000000 | 2000"),
    (("laws.damping_regimes.points", 10**9), "points is 1000000000 | 100000"),
    (("laws.jump_conditions.beads", 10**9), "beads is 1000000000 | 100000"),
    ((f"{THETA}.profile.step", 1e-12), "profile.step is 1e-12 | 1e-06"),
    ((f"{THETA}.order.steps", [0.24]), "order.steps has 1 entry | limit 3"),
    ((f"{STATES}", lattice({"kind": "toda"}, -1, -0.5, 0)), "states has 3 entries: list 2"),
    ((BEADS, {"count": 9, "mass": {"taper": {"ratio": -1}}}), "ratio is -1 | above 0"),
    ((BEADS, {"count": 1}), "beads.count is 1 | 2"),
    ((BEADS, {"count": 10**9, "cell": ["steel 9.5 mm"]}), "beads.count is 1000000000 | GiB"),
    ((BEADS, {"count": 20, "mass": HEAVY}), "impurity is at 30 | there are 20"),
    # Sizes.
    (("scenes.front.underdamped.window.step", 1e-9), "window.step is 1e-09 | 8,047 GiB"),
    (("scenes.front.underdamped.driven_bead", 10**8), "driven_bead is 100000000 | 48 GiB"),
    ((f"{RING}.record.grid.step", 1e-9), "record.grid.step is 1e-09 | 1e+06 GiB"),
    (
        (f"{RING}.equations.unlimited.cells", 10**8),
        "equations.unlimited.cells is 100000000 | 48 GiB",
    ),
    # Fronts.
    ((f"{FRONT_SCENE}.law.alpha", 1), "law.alpha is 1 | above 1"),
    ((f"{FRONT_SCENE}.law.gamma", 0), "law.gamma is 0 | above 0"),
    ((f"{FRONT_SCENE}.displacement", 0), "displacement is 0 | above 0"),
    ((f"{FRONT_SCENE}.driven_bead", 2), "driven_bead is 2 | limit"),
    # Equations of a ring.
    ((f"{RING}.equations", {}), "weak: equations is empty"),
    ((f"{RING}.equations.logarithmic", ...), "logarithmic is missing | equations.upwind"),
    # Waves of the limiting cases.
    (("laws.limiting_cases.beads", 275), "beads is 275 | 276"),
    (("laws.limiting_cases.end_time", 31.9), "end_time is 31.9 | strong_gamma 1 | 32"),
    (("laws.limiting_cases.strong_gamma", 40), "end_time is 240, | strong_gamma 40 | 656"),
    # Units.
    ((f"{GLASS}.radius", 19.6), "radius is 19.6 | 2.5e-06 kg/m³ | 1 to 30000"),
    (("laws.materials.beads", {"steal": BALL}), "beads.steal: | did you mean steel?"),
    # Ranges and steps.
    (("laws.damping_regimes.alpha", "3/2"), 'alpha is "3/2" | write 1.5'),
    (("laws.damping_regimes.points", 4.2e2), "points is 420.0 | whole: write 420"),
    (("exact_fronts.survey.gamma.start", 2), "survey.gamma.start is 2 | stop 2"),
    ((f"{THETA}.profile.step", 0.7), "profile.step is 0.7"),
    # Laws, states, what is shown.
    ((STATES, lattice({"kind": "toda"}, -2, -2)), "cases.mine.states are -2 and -2"),
    ((STATES, lattice({"kind": "hertz", "alpha": 2}, 0, 1)), "cases.mine.states are 0 and 1"),
    ((STATES, lattice({"kind": "lennard_jones"}, -5, 0)), "cases.mine.states has -5 | -1 and inf"),
]


def section(change):
    """Set a value; a mapping is laid over the one there, an ellipsis copies or takes away."""
    path, value = change
    *parents, last = path.split(".")
    node = configuration = json.loads(json.dumps(DEFAULTS))
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
    check_configuration(configuration)


# Fronts.


def front_of(kind, viscous, states, **parameters):
    return {"law": {"elastic": {"kind": kind, **parameters}, "viscous": viscous}, "states": states}


def linear(gamma):
    return {"kind": "linear", "gamma": gamma}


HERTZ, LATTICE = {"alpha": 1.5, "gamma": 0.2}, front_of("toda", linear(0.3), (-2.0, 0.0))
FRONTS = [
    ({}, "alpha is None"),
    (HERTZ | {"alpha": 1.0}, "linear chain"),
    (HERTZ | {"alpha": 0.5}, "runs the other way"),
    (HERTZ | {"gamma": 0.0}, "conservative chain"),
    (HERTZ | {"beta": 0.9}, "at least 1"),
    (HERTZ | {"right_state": 1.0}, "right_state is 1.0 | at least 0 and below 1"),
    (HERTZ | {"right_state": 0.2, "method": "shooting"}, 'at rest ahead | method "profile"'),
    (HERTZ | {"method": "guess"}, "method is 'guess'"),
    ({"law": LATTICE["law"]}, "states is missing"),
    ({"states": (-1, 0)}, "law is missing"),
    (LATTICE | {"states": (-1, 0, 1)}, "states holds 3 numbers"),
    (LATTICE | {"alpha": 1.5}, "alpha and law are given together"),
    (LATTICE | {"right_state": 0.1}, "right_state is 0.1, but the states"),
    (LATTICE | {"method": "shooting"}, 'shooting takes only the law (28) | method "profile"'),
    (LATTICE | {"law": 1.5}, "law is 1.5"),
    # Between these states there is no front, or none that is sought.
    (LATTICE | {"states": (0.0, -2.0)}, "leaves R = -2 behind it, eq. (17): give (-2, 0)"),
    (LATTICE | {"states": (-1.0, -1.0)}, "both -1"),
    (front_of("toda", {"kind": "none"}, (-2.0, 0.0)), "Nothing dissipates"),
    (front_of("fpu", linear(0.3), (-1.0, 0.0)), "Remark 3"),
    (front_of("lennard_jones", linear(0.3), (-1.5, 0.0)), "at least -1"),
    (front_of("fpu", linear(1.0), (-1.0, 0.9), quartic=1.0), "V''' has one sign"),
    (front_of("hertz", linear(1.0), (0.0, -1.0), alpha=0.5), "V'' is inf, W'' is 1"),
    (
        front_of("toda", {"kind": "power", "beta": 0.5, "gamma": 1.0}, (-1.0, 0.0)),
        "R = 0, the state ahead of the front | W'' is inf",
    ),
    (
        front_of("fpu", {"kind": "power", "beta": 1.5, "gamma": 1.0}, (1.0, -0.1), cubic=1.0),
        "W'' is 0 at R = 1, the state behind",
    ),
]
SWEEPS = [
    ({"alpha": 1.5, "gammas": [0.1, 0.0]}, "gammas holds 0"),
    ({"alpha": 1.5, "gammas": []}, "must be a list"),
]
TAILS = [
    ({"alpha": 1.0, "gamma": 0.1}, "alpha is 1.0 | linear chain"),
    ({"alpha": 1.5, "gamma": 0.1, "count": 0}, "count is 0"),
]
CRITICAL = [
    ({"alpha": 1.5, "definition": "double-root"}, "no double root above"),
    ({"alpha": 1.5, "definition": "best"}, "definition is 'best'"),
    ({"alpha": float("nan")}, "alpha is nan"),
]


# The rest.


def without(family):
    """A ring whose scene names no such equation."""
    ring = scene_with()
    del ring["equations"]["upwind"], ring["equations"][family]
    return {"scene": ring, "name": "mine"}


def keywords(function):
    return lambda given: function(**given)


MANY_BEADS = {
    "kind": "chain",
    "axes": {"beads": {"linspace": [40, 1e12, 3]}, "gamma": [0.1]},
    "fixed": {"alpha": 1.5, "delta": 0.1},
}
REFUSALS = {
    scene("chain", SCENE): CHAINS,
    scene("heteroclinic", "front_profiles"): ORBITS,
    chain_of: CHAINS_OF_LAWS,
    section: SECTIONS,
    keywords(gf.solve_front): FRONTS,
    keywords(gf.sweep_fronts): SWEEPS,
    keywords(gf.tail_roots): TAILS,
    keywords(gf.critical_damping): CRITICAL,
    keywords(gf.restitution): [
        ({"gamma": 1e308, "alpha": 1.5, "beta": 1.0}, "collision lies beyond double")
    ],
    keywords(Scaling): [
        (
            {"mass": 1e300, "stiffness": 1e-300, "damping": 0.0, "velocity": 1e-300},
            "A scale of this chain lies beyond double",
        )
    ],
    functools.partial(check_campaign, name="big"): [
        (MANY_BEADS, "beads (entry 2) is 500000000020 | GiB")
    ],
    keywords(gf.evolve_log_burgers): [(without("logarithmic"), "equations.logarithmic is missing")],
    keywords(evolve_unlimited): [(without("unlimited"), "equations.unlimited is missing")],
    keywords(gf.evolve_log_kdv_burgers): [
        (without("dispersive"), "equations.dispersive is missing")
    ],
}


@pytest.mark.parametrize(
    ("ask", "given", "words"),
    [pytest.param(ask, *row, id=row[-1]) for ask, rows in REFUSALS.items() for row in rows],
)
def test_what_is_impossible_is_refused(ask, given, words):
    with pytest.raises(InputError) as caught:
        ask(given)
    assert_refused(str(caught.value), words)
