"""Whatever is impossible is refused in sentences: key, value and limit, and the way out.

`REFUSALS[ask]` lists what `ask(given)` refuses: rows of what is given and of words of the sentence,
between bars; a line of words for each sentence.
"""

import json
import time
import tracemalloc
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
import xarray as xr
from configurations import DEFAULT, SCENE, assert_refused, change
from potentials import NO_DISSIPATION, fpu, lennard_jones, morse, toda
from rings import scene_with

import granular_fronts as gf
from campaigns import CHAINS, CHAINS_OF_A_LAW, PULSE, RATIOS, RINGS, TODA, campaign
from campaigns import SCENE as MOTION
from granular_fronts import arguments
from granular_fronts.campaign.ring_points import make_ring
from granular_fronts.continuum.evolution import evolve_unlimited
from granular_fronts.continuum.log_burgers.equation import flux
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import turning_points
from granular_fronts.errors import InputError
from granular_fronts.model import scaling
from granular_fronts.referee.problems import load_problems
from granular_fronts.referee.settings import read_settings
from granular_fronts.reference_methods import half_step
from granular_fronts.scenes import memory
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.configuration import SCENES, check_configuration
from granular_fronts.scenes.ring import Ring
from granular_fronts.scenes.yaml_files import LONGEST_FILE, load_configuration
from granular_fronts.studies.numerical_damping import Case, theta_chain

DEFAULTS = load_configuration(DEFAULT)


@pytest.fixture(autouse=True)
def sixteen_gibibytes(monkeypatch):
    """What is refused must not depend on the machine of the test."""
    monkeypatch.setattr(memory, "memory_of_machine", lambda: 16 * 2**30)


REFUSALS = {}


def keywords(function):
    """A function that is given its arguments by name."""
    return lambda given: function(**given)


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
CHAIN = scene("chain", SCENE)
REFUSALS[CHAIN] = [
    # What the schema says.
    ({"law__alpha": 0}, "law.alpha is 0 | above 0"),
    ({"law__gamma": -0.1}, "law.gamma is -0.1 | limit 0"),
    ({"law__gamma": ...}, "law.gamma is missing | viscous force"),
    ({"law": None}, "law is null"),
    ({"boundary": None}, "boundary is null"),
    ({"start": ...}, "start is missing"),
    ({"beads": 1}, "beads is 1 | pressure | take a wall"),
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
    ({"law__alpha": -1, "beads": 0}, "law.alpha is -1 | above 0\nbeads is 0 | limit 1"),
    ({"law__alpha": 150}, "law has alpha 150 | energies of about 1e-151 | 1e±140"),
    ({"law__gamma": 1e141}, "law has gamma 1e+141 | 1e±140"),
    # Sizes, as numbers that a mistake in their formula changes.
    ({"beads": 10**9}, "beads is 1000000000 and end_time is 2600 | 16,004 GiB | the 16 GiB"),
    ({f"{STEADY}step": 1.0e-9}, "record.probes.steady.step is 1e-09 | 53,644 GiB"),
]
REFUSALS[scene("heteroclinic", "front_profiles")] = [
    ({"mu": [0.3, 2, 0.3]}, "mu (entry 3) is 0.3"),
    ({"mu": [0.3, 9e-281]}, "mu (entry 2) is 9e-281 | 1e-280"),
    ({"mu": [0.3, 2e280]}, "mu (entry 2) is 2e+280 | 1e+280"),
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

# Chains of laws of potentials, of unlike beads, with drives and sensors.

POWERS = {"law": {"alpha": 1.5, "gamma": 0.2}}
BARRIER = gf.Potential(
    lambda r: -np.log(-r),
    lambda r: -1.0 / r,
    lambda r: r**-2.0,
    interval=(-2.0, -0.01),
    name="−ln(−r)",
)


def chain_of(changes):
    chain = POWERS | {"beads": 20, "boundary": pressed(0.3), "start": {"kind": "rest"}}
    chain |= {"tolerance": {"relative": 1e-9, "absolute": 1e-11}, "record": {"snapshots": [12.0]}}
    Chain.read(chain | {"end_time": 12.0} | changes, "mine")


def pressed(left, right=0.0):
    return {"kind": "pressure", "left": left, "right": right}


def of(kind, **parameters):
    return {"law": {"elastic": {"kind": kind, **parameters}}}


REFUSALS[chain_of] = [
    ({"law": TODA | {"alpha": 1.5}}, "law.alpha is no key"),
    (of("toda", rate=0), "law: rate is 0 | above 0"),
    ({"law": {"elastic": {"rate": 1}}}, "law.elastic.kind is missing"),
    ({"law": {"viscous": {"kind": "none"}}}, "law.elastic is missing"),
    (of("lennard_jones", distance=0.2), "boundary.left is 0.3 | 0.2 only"),
    (
        {"law": TODA, "boundary": pressed(1e-200)},
        "law.elastic | about 1e-200 | energies of about 1e-323 | 1e±140\n"
        "law.viscous | about 1e-200 | 1e±140",
    ),
    ({"record": {"snapshots": [], "arrival_level": 0}}, "level is 0 | above 0"),
    (
        {"law": gf.make_law(elastic=BARRIER), "boundary": {"kind": "piston", "velocity": 0.0}},
        "boundary.right is 0 | between 0.01 and 2\nstart.relative_displacement of a",
    ),
    (
        {"law": gf.make_law(elastic=BARRIER), "boundary": pressed(0.5, 0.4)},
        "start.relative_displacement of a chain at rest is 0",
    ),
]


def masses(**pattern):
    return {"beads": {"count": 5, "mass": pattern}}


def held(boundary, kind="equilibrium", **changes):
    """A chain that begins in balance."""
    return {"boundary": boundary, "start": {"kind": kind} | changes}


FREE, WALL = pressed(0.0), {"kind": "wall", "left": 0.0}
FAST = {"beads": 1, "velocity": 1.0}
ON_A_RING = {"kind": "given", "relative_displacement": [0.1] * 13, "velocity": [0.0] * 13}
THIRTEEN = {"beads": 13, "boundary": {"kind": "ring"}, "start": ON_A_RING}
REFUSALS[chain_of] += [
    (masses(list=[1.0, 2.0]), "beads.mass.list has 2 values | 5"),
    (masses(impurity=[{"bead": 3, "mass": m} for m in (2, 5)]), "impurity names 3 more than once"),
    (masses(taper={}), "beads.mass.taper is empty"),
    (masses(taper={"difference": -0.25}), "difference is -0.25 | -0.25"),
    (masses(random={"spread": 1.5, "seed": 1}), "spread is 1.5 | 1"),
    (masses(cell=[1.0e6], random={"spread": 0.5, "seed": 1}), "beads.mass comes to 1e±6 | 1e±6"),
    (masses(list=[1.0e-3] * 5, taper={"ratio": 0.1}), "beads.mass comes to 1e±7"),
    (masses(impurity={"bead": 1, "mass": 1.0e-7}), "beads.mass comes to 1e±7"),
    (THIRTEEN | {"contacts": {"elastic": {"cell": [1, 2]}}}, "13 | 12"),
    (THIRTEEN | {"contacts": {"viscous": {"taper": {"ratio": 0.9}}}}, "viscous.taper is given"),
    ({"contacts": {"elastic": {"impurity": {"contact": 20, "factor": 2}}}}, "is at 20 | 19"),
    (held(FREE, "striker", **FAST | {"beads": 20}), "start.beads is 20 | 19"),
    (held(FREE, "striker", **FAST | {"velocity": 0.0}), "start.velocity is 0"),
    (held(FREE, "striker", **FAST) | {"gravity": 0.1}, "gravity 0.1 | balance"),
    (held(pressed(0.1), "striker", **FAST), "boundary.left is 0.1 | 0"),
    (held(WALL | {"left": -0.1}) | {"law": TODA}, "boundary.left is -0.1 | pulls"),
    (held(WALL) | {"gravity": -0.1}, "gravity is -0.1 | 0 or more"),
    (THIRTEEN | {"gravity": 0.1}, "gravity is 0.1 | ring"),
]
STEEL_WALL = WALL | {"material": "steel"}


def spheres(words, **changes):
    return {"beads": {"count": 12, "cell": [words]}} | changes


REFUSALS[chain_of] += [
    (spheres("steal 9.5 mm"), "beads.cell (entry 1): 'steal' is no material: did you mean steel?"),
    (spheres("steel 9.5 kg"), "'steel 9.5 kg' has the unit kg, which is no length | mm"),
    (spheres("steel 9.5"), "has the unit none | mm"),
    (spheres("steel 0 mm"), "has the diameter 0: give a number above 0"),
    (spheres("steel 1e999 mm"), "has the diameter 1e999"),
    (spheres("steel"), "without a diameter: give one, as in steel 9.5 mm"),
    (spheres("9.5 mm steel"), "is no body | as in steel 9.5 mm"),
    (spheres("steel 5 mm", law={"alpha": 2, "gamma": 0}), "law has alpha 2: give alpha 1.5"),
    (spheres("steel 5 mm", boundary=WALL), "boundary.material is missing"),
    (spheres("steel 5 mm", boundary=STEEL_WALL | {"material": "wood"}), "'wood' is no material"),
    (spheres("steel 5 mm", contacts={"elastic": 2.0}), "contacts.elastic is given"),
    ({"boundary": STEEL_WALL}, "boundary.material is steel | no material"),
    ({"beads": {"count": 3, "list": ["steel 1 m"]}}, "beads.list has 1 values | 3"),
    ({"beads": {"count": 3, "cell": ["steel 1 m"], "mass": 2.0}}, "but mass is given"),
    ({"beads": {"count": 2, "list": ["steel 1 m", "steel 1 um"]}}, "beads comes to 1e±18"),
]
SINE, STEP = {"amplitude": 1.0, "angular_frequency": 1.0}, {"height": 1, "duration": 1}


def push(force):
    return {"boundary": {"kind": "force", "force": force}}


def pull(velocity, **changes):
    return {"boundary": {"kind": "piston", "velocity": velocity} | changes}


REFUSALS[chain_of] += [
    ({"boundary": {"kind": "force", "right": 0}}, "boundary.force is missing | External force"),
    (push({}), "boundary.force is empty | half_sine"),
    (push(float("inf")), "boundary.force is inf | finite"),
    (push(1.0e200), "law has alpha 1.5 | energies of about 1e+333"),
    (push({"square": SINE}), "boundary.force.square is no key | pulse, half_sine"),
    (push({"harmonic": SINE, "pulse": STEP}), "give one"),
    (push({"pulse": STEP | {"duration": 0}}), "pulse.duration is 0 | above 0"),
    (push({"table": {"times": [0, 1], "values": [1]}}), "2 entries, but values has 1"),
    (push({"table": {"times": [0, 2, 1], "values": [1] * 3}}), "(entry 3) is 1 | is 2"),
    (push({"table": {"times": [-1, 0], "values": [1, 1]}}), "(entry 1) is -1"),
    (pull({"pulse": STEP}), "boundary.velocity.pulse jumps | infinite force | table"),
    (pull({"harmonic": SINE}, ramp=1), "boundary.ramp is given"),
    ({"boundary": WALL | {"force": 0.1}}, "boundary has left and force"),
]


def sensor(**places):
    one = {"start": 0.0, "stop": 8.0, "step": 0.02} | places
    return {"record": {"snapshots": [], "sensors": {"one": one}}}


REFUSALS[chain_of] += [
    (sensor(contacts=[20]), "sensors.one.contacts names contact 20 | 19 contacts | 1 to 19"),
    (sensor(beads=[21]), "sensors.one.beads names bead 21 | 20 beads"),
    (sensor(), "sensors.one has neither contacts nor beads"),
    (sensor(contacts=[1], step=30.0), "sensors.one.step"),
    (sensor(contacts=[1], stop=13.0), "sensors.one.stop is 13 | end_time 12"),
    (sensor(contacts=[1], step=1e-8), "sensors.one.step is 1e-08 | GiB"),
    (
        {"record": sensor(contacts=[1])["record"] | {"probes": {"one": PROBE}}},
        "sensors.one has the name of record.probes.one",
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


REFUSALS[section] = [
    (("exact_fronts.survey.gamma", ...), "survey.gamma is missing | Dampings at equal ratios"),
    # Entries listed twice, unknown names, what is no mapping.
    (("exact_fronts.survey.alpha", [1.1, 1.5, 1.1]), "exact_fronts.survey.alpha (entry 3) is 1.1"),
    (("results", ""), "results is empty"),
    (("scenes.heteroclinic", ...), "scenes.heteroclinic is missing"),
    (("scenes.chian", {}), "did you mean chain?"),
    # Names that clash, or that nothing has.
    (("scenes.front.survey", FRONT), "scenes.front.survey has the name of the study survey"),
    (("scenes.heteroclinic.weak", ORBIT), "weak has the name of scenes.heteroclinic.weak"),
    (("scenes.chain.initiation_underdampt", {"beads": 9}), "lacks law | underdamped?"),
    (("scenes.chain.initiation_underdampt", 3), "initiation_underdampt is 3"),
    (("scenes.heteroclinic.damping_swep", {"mu": [1]}), "lacks profile | mean damping_sweep?"),
    # Counts and steps beyond the schema's limits.
    (("exact_fronts.survey.gamma.num", 10**9), "num is 1000000000 | limit 10000"),
    (("exact_fronts.multipliers.beads_behind", [10**6]), "(entry 1) is 1000000 | 2000"),
    (("laws.damping_regimes.points", 10**9), "points is 1000000000 | 100000"),
    (("laws.jump_conditions.beads", 10**9), "beads is 1000000000 | 100000"),
    ((f"{THETA}.profile.step", 1e-12), "profile.step is 1e-12 | 1e-06"),
    ((f"{THETA}.profile.theta", 0.5), "theta is 0.5 | above 0.5"),
    (("laws.materials.beads.cork.gamma", 0.438), "gamma is 0.438 | below 0.438"),
    ((f"{THETA}.order.steps", [0.24]), "order.steps has 1 entry | limit 3"),
    ((f"{STATES}", lattice({"kind": "toda"}, -1, -0.5, 0)), "states has 3 entries: list 2"),
    ((BEADS, {"count": 9, "mass": {"taper": {"ratio": -1}}}), "ratio is -1 | above 0"),
    ((BEADS, {"count": 0}), "beads.count is 0 | 1"),
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
    (("exact_fronts.survey.gamma.start", 2), "survey.gamma.start is 2 | stop 2"),
    ((f"{THETA}.profile.step", 0.7), "profile.step is 0.7"),
    # Laws, states, what is shown.
    ((STATES, lattice({"kind": "toda"}, -2, -2)), "cases.mine.states are -2 and -2"),
    ((STATES, lattice({"kind": "hertz", "alpha": 2}, 0, 1)), "cases.mine.states are 0 and 1"),
    ((STATES, lattice({"kind": "lennard_jones"}, -5, 0)), "cases.mine.states has -5 | -1 and inf"),
]


REFUSALS[check_configuration] = [(None, "the file is null")]


# Fronts.


def front_of(kind, viscous, states, **parameters):
    return {"law": {"elastic": {"kind": kind, **parameters}, "viscous": viscous}, "states": states}


def linear(gamma):
    return {"kind": "linear", "gamma": gamma}


HERTZ, LATTICE = {"alpha": 1.5, "gamma": 0.2}, front_of("toda", linear(0.3), (-2.0, 0.0))
REFUSALS[keywords(gf.solve_front)] = [
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
REFUSALS[keywords(gf.sweep_fronts)] = [
    ({"alpha": 1.5, "gammas": [0.1, 0.0]}, "gammas holds 0"),
    ({"alpha": 1.5, "gammas": []}, "must be a list"),
]
REFUSALS[keywords(gf.tail_roots)] = [
    ({"alpha": 1.0, "gamma": 0.1}, "alpha is 1.0 | linear chain"),
    ({"alpha": 1.5, "gamma": 0.1, "count": 0}, "count is 0"),
]
REFUSALS[keywords(gf.critical_damping)] = [
    ({"alpha": 1.5, "definition": "double-root"}, "no double root above"),
    ({"alpha": 1.5, "definition": "best"}, "definition is 'best'"),
    ({"alpha": float("nan")}, "alpha is nan"),
]


# Laws, jump conditions, collisions and units.

LINEAR = {"kind": "linear", "gamma": 0.3}
REFUSALS[keywords(gf.make_law)] = [
    ({}, "no elastic potential: give elastic"),
    ({"beta": 1.5}, "no alpha, the exponent of its elastic force: give one"),
    ({"alfa": 1.5}, "'alfa' is no part of a law: did you mean alpha?"),
    ({"alpha": 1.5, "elastic": {"kind": "toda"}}, "alpha besides elastic | leave one of them out"),
    ({"alpha": 1.5, "gamma": -0.1}, "gamma is -0.1 | at least 0"),
    ({"elastic": "toda"}, "elastic is 'toda' | a Mapping: give a mapping"),
    ({"elastic": {"kind": "hertz"}}, "hertz has no alpha"),
    ({"elastic": {"kind": "hertz", "alpha": 0.0}}, "alpha is 0 | above 0"),
    ({"elastic": {"kind": "hertz", "alpha": 1.5, "stiffness": -1.0}}, "stiffness is -1 | above 0"),
    (of("toda")["law"] | {"viscous": {"kind": "dashpot"}}, "no kind of viscous potential"),
    (of("toda")["law"] | {"viscous": {"kind": "proportional"}}, "proportional has no gamma"),
    (of("toda")["law"] | {"viscous": {"kind": "none", "gamma": 1}}, "no parameter of none"),
    *(
        (of("toda")["law"] | {"viscous": LINEAR | {"kind": kind}}, "to the elastic kind hertz")
        for kind in ("kuwabara_kono", "simon_hunt_crossley")
    ),
]
BROKEN = gf.Potential(
    toda().value,
    toda().first,
    lambda r: np.where(abs(r + 0.53) < 0.01, np.nan, toda().second(r)),
    interval=(-1.0, 0.1),
    name="mine",
)
NARROW = gf.Potential(
    np.square, lambda r: 2.0 * r, lambda r: 2.0 + 0.0 * r, interval=(-0.5, 0.5), name="W"
)
REFUSALS[lambda given: gf.jump_conditions(*given[:3], dissipation=given[3])] = [
    ((fpu(), -1.0, 0.0, None), "quadratic between the states | Remark 3"),
    ((fpu(-1.0, 0.0, -1.0), 0.0, 1.0, None), "strictly concave | Remark 1"),
    ((morse(), 0.6, 3.0, None), "is the square of a speed | eq. 13"),
    ((fpu(1.0, 0.0, 1.0), -1.0, 1.0, None), "vanishes between -1 and 1 | eq. 18"),
    ((toda(), -1.0, 0.0, NO_DISSIPATION), "area (20) to be 0, but it is 0.14 | Remark 4"),
    ((fpu(1.0, 0.0, 1.0), -1.0, 1.0, NO_DISSIPATION), "speed 1.41421 | Remark 4"),
    ((toda(), -1.0, 0.0, fpu(-1.0)), "W'' of FPU potential is -1 | convex"),
    ((toda(), -0.1, -0.1, None), "both -0.1, but a front joins two different states"),
    ((lennard_jones(), -2.0, 0.0, None), "R_minus is -2.0 | defined from -1 to inf"),
    ((lennard_jones(), -1.0, 0.0, None), "V of Lennard-Jones potential is inf at r = -1"),
    ((BROKEN, -1.0, 0.0, None), "V'' of mine is nan at r = -0.5"),
    ((toda(), -1.0, 0.0, NARROW), "is -1.0 | W is defined from -0.5 to 0.5"),
    ((gf.make_law(alpha=1.5), -0.5, 0.0, None), "Remark 4"),
    ((gf.make_law(alpha=1.5), -0.5, 0.0, NO_DISSIPATION), "dissipation is | leave dissipation out"),
]
REFUSALS[lambda law: gf.make_law(law, gamma=1.0)] = [
    ({"alpha": 1.5}, "as a whole and gamma besides: give one"),
    (gf.make_law(alpha=1.5), "as a whole and gamma besides: give one"),
]
REFUSALS[keywords(gf.contact_stiffness)] = [
    ({"first": "steel", "second": "glass"}, "are flat"),
    ({"first": "steel 1e-110 mm", "second": "glass"}, "is 1e-113 m wide: give 1e-12 to"),
]
REFUSALS[lambda given: scaling.Scaling(*given).critical_velocity] = [
    ((0.1, 1.0e9, 1.0e-6, 1.0, 1.5, 1.25), "gamma is 0.1 | there is no velocity v_c"),
    ((0.1, 1.0e9, 0.0, 1.0), "gamma is 0 | there is no velocity v_c"),
]
REFUSALS[lambda chain: half_step.integrate(half_step.Chain(*chain), [0, 0], [1, 0], 0.1, 3)] = [
    ((1.5, 0.5, 0.1), "beta is 0.5"),
    ((1.5, 1.5, -1.0), "gamma is -1.0"),
    ((1.5, 1.5, 0.1, -1.0), "left is -1.0"),
]
REFUSALS[lambda given: half_step.integrate(half_step.Chain(1, 1, 0), [0, 0], *given)] = [
    (([1], 0.1, 3), "v holds 1 numbers, but x 2: give one for each bead"),
    (([1, 0], 0.1, 3, [5]), "follow is | beads are 0 to 1"),
]
REFUSALS[lambda step: half_step.integrate(half_step.Chain(1, 1, 0), [0, 0], [1, 0], step, 3)] = [
    (0.0, "step is 0.0")
]
REFUSALS[lambda given: theta_chain(Case(given[0], 0.1, 14, 12.0), *given[1:])] = [
    ((1.5, 0.4, 0.1), "theta is 0.4"),
    ((1.5, 1.1, 0.1), "theta is 1.1"),
    ((0.5, 1.0, 0.1), "alpha is 0.5"),
    ((2.0, 1.0, 0.7), "end_time is 12"),
]
REFUSALS[keywords(gf.restitution)] = [
    ({"gamma": 1e308, "alpha": 1.5, "beta": 1.0}, "collision lies beyond double"),
    ({"gamma": 0.5, "alpha": 1.5, "beta": 195.0}, "beta is 195 | at most 50"),
]
SPHERE = {"radius": 0.01, "youngs_modulus": 1.0e9, "poisson_ratio": 0.3}
BEAD = {"mass": 0.1, "stiffness": 1.0e9}
REFUSALS[keywords(gf.damping_for_restitution)] = [
    ({"e": 0.0}, "e is 0.0 | above 0 and at most 1"),
    ({"e": 1.0001}, "e is 1.0001 | above 0 and at most 1"),
]
REFUSALS[keywords(scaling.sphere_stiffness)] = [
    (SPHERE | {"youngs_modulus": -1.0}, "modulus is -1.0 | above 0"),
    (SPHERE | {"poisson_ratio": 0.5}, "poisson_ratio is 0.5 | solid"),
    (SPHERE | {"poisson_ratio": -1.0}, "poisson_ratio is -1.0 | solid"),
]
REFUSALS[keywords(scaling.sphere_mass)] = [
    ({"radius": 0.01, "density": float("nan")}, "density is nan")
]
REFUSALS[keywords(scaling.velocity_of_compression)] = [(BEAD | {"delta": -1e-6}, "delta is -1e-06")]
REFUSALS[keywords(scaling.velocity_of_force)] = [(BEAD | {"force": 0.0}, "force is 0.0")]
REFUSALS[keywords(scaling.damping_from_restitution)] = [
    (BEAD | {"e": 1.2, "impact_velocity": 0.5}, "e is 1.2 | restitution")
]
REFUSALS[lambda unit: scaling.Scaling(damping=0.0, velocity=1.0, **BEAD).to_physical(1.0, unit)] = [
    ("mass", "quantity is 'mass'")
]
REFUSALS[keywords(scaling.Scaling)] = [
    (
        {"mass": 1e300, "stiffness": 1e-300, "damping": 0.0, "velocity": 1e-300},
        "A scale of this chain lies beyond double",
    )
]


# Equations of a ring.


def without(family):
    """A ring whose scene names no such equation."""
    ring = scene_with()
    del ring["equations"]["upwind"], ring["equations"][family]
    return {"scene": ring, "name": "mine"}


for evolve, family in (
    (gf.evolve_log_burgers, "logarithmic"),
    (evolve_unlimited, "unlimited"),
    (gf.evolve_log_kdv_burgers, "dispersive"),
):
    REFUSALS[keywords(evolve)] = [(without(family), f"equations.{family} is missing")]


REFUSALS[lambda changes: Ring.read(scene_with(**changes), "mine")] = [
    ({"law__alpha": 1}, "law.alpha is 1 | above 1"),
    ({"law__gamma": 0}, "law.gamma is 0 | above 0"),
    ({"start__floor": 1.5}, "start.floor is 1.5 | limit 1"),
    ({"start__half_width": 27.5}, "half_width is 27.5 | 27.7853"),
    ({"start": {"kind": "given", "rescaled_force": [0.0, -0.1, 0.0]}}, "-0.1"),
    ({"start": {"kind": "given", "rescaled_force": [0.0, 1.0, 0.5]}}, "ends with 0.5"),
    ({"equations__logarithmic__cells": 64}, "logarithmic.cells is 64 | 112"),
    ({"equations__upwind__points": 64}, "upwind.points is 64 | 112"),
    ({"equations__unlimited__tolerance": 1e-16}, "tolerance is 1e-16 | 1e-13"),
    ({"record__snapshots": [90.5]}, "record.snapshots (entry 1) is 90.5 | end_time 90"),
    ({"record__grid__step": 91}, "record.grid.step is 91 | end_time 90"),
]
REFUSALS[keywords(gf.heteroclinic)] = [
    ({"mu": -0.1}, "mu is -0.1 | 0"),
    ({"mu": 1.0e-300}, "mu is 1e-300 | 1e-280"),
    ({"mu": 1.0e300}, "mu is 1e+300 | at most 1e+280"),
    ({"mu": float("nan")}, "mu is nan"),
    ({"mu": 1.0, "s": [[0.0]]}, "s has shape (1, 1)"),
    ({"mu": 1.0, "s": [0.0, float("nan")]}, "s holds nan"),
    ({"mu": 1.0, "s": [0.0, 57.0]}, "mu = 1.0 | s = 56.01"),
    ({"mu": 0.0, "s": [-57.0]}, "s = -56.77"),
    ({"mu": 1.0e-9, "s": [-1.0e6]}, "mu = 1e-09 | 200000 | s = -35363.4"),
]
REFUSALS[turning_points] = [(1.0e-5, "mu = 1e-05")]
REFUSALS[keywords(flux)] = [
    ({"y": 0.5, "alpha": 1.0}, "alpha is 1.0 | 1"),
    ({"y": [-0.1, 0.5], "alpha": 1.5}, "y holds -0.1"),
]


# Campaigns.


def campaign_of(given):
    """Of a campaign some keys are changed; an ellipsis takes one away."""
    return lambda changes: campaign(given, **changes)


def gammas(values, **axes):
    return {"axes": {"delta": [1.0], "gamma": values, **axes}}


def fixed(given=CHAINS, **changes):
    return {"fixed": {**given["fixed"], "delta": 1.0, **changes}}


def profile(start, stop, count):
    return {"record": {"profile": {"start": start, "stop": stop, "count": count}}}


def listed(*force):
    bare = {"damping": 0.5, "half_length": 8.1}
    return {"start": {"profile": "given", "rescaled_force": [*force]}, "fixed": bare}


BARE = {"elastic": {"kind": "toda"}, "viscous": None}


def rates(*values, **axes):
    return {"axes": {"law.elastic.rate": [*values], "delta": [1.0], **axes}}


SENSOR = {"start": 0, "stop": 30, "step": 0.1}


def sensors(value):
    record = {"snapshots": [], "sensors": value}
    return {"scene": MOTION | {"record": record}}


REFUSALS[campaign_of(CHAINS)] = [
    (gammas([]), "axes.gamma is empty"),
    (gammas(0.5), "axes.gamma is 0.5 | a list"),
    (gammas([0.1, 0.3, 0.2]), "gamma has 0.2 after 0.3 | must increase"),
    (gammas([0.3, 0.3]), "gamma has 0.3 after 0.3"),
    (
        gammas({"linspace": [0.1, 1.0, 2.5]}),
        "axes.gamma.linspace (entry 3) is 2.5 | a whole number",
    ),
    (gammas({"linspace": [0.1, 1.0]}), "has 2 entries: list 3 (start, stop, count)"),
    (gammas({"logspace": [0.0, 1, 5]}), "axes.gamma.logspace (entry 1) is 0.0 | above 0"),
    (gammas({}), "axes.gamma has no spacing | linspace or logspace"),
    (gammas([0.1, float("inf")]), "axes.gamma (entry 2) is inf"),
    (gammas([1.0], gama=[1.0]), "gama is no key | did you mean gamma"),
    (gammas([-0.2, -0.1, 1.0]), "gamma (entry 1) is -0.2 | give 0 or more"),
    (gammas([1.0], alpha=[1.0, 1.5]), "alpha is given under axes and under fixed"),
    (gammas({"linspace": [0, 1, 10**10]}), "10,000,000,000 points\n10000000000 | GiB"),
    (gammas({"linspace": [0, 1, 10**6 + 1]}), "1,000,001 points | 1,000,000 | allow_large"),
    (fixed(alpha=1.0) | gammas([1.0]), "delta is given under axes and under fixed"),
    ({"fixed": {"alpha": 1.0, "beads": 30}}, "alpha is 1.0, but must be above 1"),
    ({"fixed": {"alpha": 1.5, "beads": 19}}, "beads is 19 | limit 20"),
    ({"fixed": {"alpha": 1.5, "beads": 30.5}}, "beads is 30.5 | a whole number"),
    ({"fixed": {"alpha": 1.5, "beads": 4 * 10**7}}, "beads is 40000000 | 19 GiB | 16 GiB"),
    ({"fixed": {"alpha": 1.5}}, "beads is missing | number of beads N"),
    ({"axes": {"beads": {"linspace": [20, 41, 3]}}}, "beads is given under axes and"),
    ({"record": {"scalars": ["speed"]}}, "(entry 1) is 'speed' | front_speed"),
    (profile(3, 1, 2), "record.profile.start is 3 | stop 1"),
    (profile(1, 7.5, 8), "there are 7 beads"),
    (profile(1, 1e9, 10**9), "record.profile.count is 1000000000 | 100000 or less"),
    ({"kind": "frnt"}, 'kind is "frnt" | chain or front or motion or ring'),
    ({"colour": 1}, "colour is no key"),
    ({"start": {"profile": "pulse"}}, "start is given, but kind chain has none"),
    (rates(1.0, gamma=[1.0]), "law.elastic.rate is no key"),
]
REFUSALS[campaign_of(CHAINS_OF_A_LAW)] = [
    ({"law": {"elastic": {"kind": "tode"}}}, "'tode' is no kind of elastic potential"),
    ({"law": {"viscous": {"kind": "none"}}}, "law.elastic is missing"),
    ({"law": TODA | {"elastic": {"kind": "toda", "rate": "2"}}}, "law.elastic.rate is"),
    (rates(-1.0, 1.0), "rate is -1.0 | above 0"),
    (rates(1.0, **{"law.elastic.rat": [1.0]}), "'rat' is no parameter of toda"),
    (rates(1.0, alpha=[1.5]), "alpha is no key"),
    (
        rates(1.0, **{"law.viscous.gamma": [1]}) | {"law": BARE},
        "law.viscous.kind is missing",
    ),
]
REFUSALS[campaign_of(RINGS)] = [
    (fixed(RINGS, mu=2), "damping and mu: keep one"),
    ({"fixed": PULSE}, "exactly one of gamma | have none"),
    (fixed(RINGS, half_beads=80), "half_beads and half_length: keep one"),
    ({"axes": {"alpha": [1e6], "slow_time": [1]}}, "alpha (entry 1) is | 10 or less"),
    (fixed(RINGS, half_width=1e-6), "half_width is 1e-06 | 0.01 or more"),
    ({"start": {"profile": "given"}}, "start has profile given, but rescaled_force"),
    ({"start": ...}, "start is missing, but kind ring needs one"),
    (listed(1, 1, 2, 1, 3), "start.rescaled_force begins with 1 and ends with 3"),
    (listed(0, 0, 0, 0, 0), "start.rescaled_force has one value"),
    (listed(1, 2, 3, 2, 1) | fixed(RINGS), "half_width is no key\nbase is no key"),
    ({"law": TODA}, "law is given, but kind ring has none"),
]
REFUSALS[campaign_of(RATIOS)] = [
    ({"axes": {"start.velocty": [1.0]}}, "start.velocty | did you mean start.velocity"),
    ({"axes": {"start.velocity": [0.0, 1.0]}}, "start.velocity is 0,"),
    ({"axes": {"beads.count": [20, 20.5]}}, "beads.count is 20.5"),
    ({"axes": {"beads.mass.cell.2": [-1.0, 1.0]}}, "beads.mass.cell (entry 2) is -1,"),
    ({"tolerance": 1e-8}, "tolerance is given, but kind motion has none"),
    ({"fixed": {"beads": 30}}, "fixed is given, but kind motion has none"),
    (sensors({}), "sensors has 0 entries"),
    (sensors({"a": 3}), "record.sensors.a is 3"),
    (sensors({"a": SENSOR | {"beads": [1]}}), "sensors has 1 entries, but must have one, with"),
    ({"scene": ...}, "scene is missing, but kind motion needs one"),
]


def ring_of(changes):
    point = {"alpha": 1.2, "delta": 1.0, "damping": 0.5, **PULSE, **changes}
    make_ring(point, point.pop("start", RINGS["start"]))


LOW = {"profile": "given", "rescaled_force": [0.001, 0.001, 1, 1, 0.001, 0.001]}
REFUSALS[ring_of] = [
    ({"damping": 0.02, "half_length": 12.5}, "half_width is 2, but beads are ε = 8.33 apart"),
    ({"damping": 0.1}, "half_length is 8.1, but beads are ε = 1.67 apart"),
    ({"damping": 1e300}, "gamma c is 1e+300, but rings are followed for 0.001 to 1000"),
    ({"damping": 1e-9}, "gamma c is 1e-09"),
    ({"half_width": 9}, "half_width is 9, but half of the ring is"),
    ({"base": 1.0}, "base is 1"),
    ({"alpha": 1 + 1e-9}, "half_length is 8.1, which asks for p | above 1e+06"),
    ({"alpha": 9.0, "delta": 1e300}, "A scale of this ring lies beyond double precision"),
    ({"alpha": 9.0, "delta": 1e-300}, "A scale of this ring lies beyond double precision"),
    ({"start": LOW}, "rescaled_force passes through"),
]


# Problems of the referee.

REFEREE = read_settings().plain()


def motion(name="front", **changes):
    return {"motions": {name: REFEREE["motions"]["front"] | changes}}


REFUSALS[lambda changes: load_problems(REFEREE | changes)] = [
    (motion("wave"), 'motions.wave is "wave" | choose plate'),
    (motion("solitary_wave", beads=11), "motions.solitary_wave.beads is 11 | 12 or more"),
    (motion(dampings=["stee"]), "motions.front.dampings names 'stee' | choose from"),
    (motion(beads=10**9), "motions.front.beads is 1000000000 | limit 10000"),
    (motion(end_time=100.2), "end_time is 100.2, no multiple of interval 0.5"),
    (motion("drop"), "motions.drop.beads is 60 | one bead hits a plate"),
    (motion(beads=1), "motions.front.beads is 1, but one bead hits a plate"),
    (motion("collision", beads=3), "motions.collision.beads is 3 | two beads"),
    ({"factors": [0.9, 1.1, 1.2]}, "factors are 0.9, 1.1, 1.2 | must increase and hold 1"),
    ({"laws": {"other": 1.1}}, "LAMMPS has no law with alpha = 1.5, beta = 1.1"),
    ({"dampings": dict.fromkeys(REFEREE["dampings"], 1.3)}, "beta = 1.25, gamma = 1.3"),
]


# Pictures.

SHOWN = xr.Dataset({"relative_displacement": ("xi", [0.0])}, attrs={"converged": 1})
NO_FRONT = SHOWN.assign_attrs(converged=0, reason="it is too steep")
REFUSALS[keywords(gf.plot.front)] = [
    ({"front": SHOWN, "ax": "x"}, "ax is 'x'"),
    ({"front": 3}, "front is 3"),
    ({"front": xr.Dataset()}, "relative_displacement on (xi)"),
    ({"front": NO_FRONT}, "it is too steep"),
]
REFUSALS[keywords(gf.plot.chain)] = [({"motion": xr.Dataset()}, "on (t, bead) | snapshots: [10]")]
REFUSALS[keywords(gf.plot.space_time)] = [
    ({"motion": xr.Dataset()}, "relative_displacement_grid | grid: {step: 1}")
]


# Kinds of arguments.

REFUSALS[lambda check: check()] = [
    (lambda: arguments.scalar("x", 2.5, above=1, most=2), "x is 2.5, | above 1 and at most 2"),
    (lambda: arguments.scalar("x", np.ones((3, 1))), "x is an array of shape (3, 1)"),
    (lambda: arguments.scalar("x", 1.0, below=1.0), "x is 1.0, | below 1"),
    (lambda: arguments.count("n", 1.5), "n is 1.5, | whole number, at least 1"),
    (lambda: arguments.array("s", [[1.0, 3.0]], below=3.0), "s holds 3.0 | below 3"),
    (lambda: arguments.choice("way", "c", ("a", "b")), "way is 'c' | a, b"),
    (lambda: arguments.instance("it", "x", Path, "give one"), "it is 'x' | a Path: give one."),
]


# Files.


def file_of(content):
    with TemporaryDirectory() as folder:
        file = Path(folder) / "mine.yaml"
        if content:
            file.write_bytes(content if isinstance(content, bytes) else content.encode())
        load_configuration(DEFAULT, file)


REFUSALS[file_of] = [
    ("a: b: c", "mine.yaml, line 1, column 5"),
    ("a: 1\nb: {c: 1, d: 2, c: 3}", "mine.yaml, line 2, column 17 | the key c is given twice"),
    ("[1, 2]", "holds no mapping"),
    ("a: \x00", "is no YAML"),
    ("a: 2026-13-45", "month must be in 1..12"),
    ("__use_yte__: true\na: ?1 + 1", "__use_yte__"),
    (None, "mine.yaml cannot be read"),
    ("a: 1".encode("utf-16"), "cannot be read | UTF-8"),
    (b" " * (LONGEST_FILE + 1), "64 MiB"),
]


@pytest.mark.parametrize(
    ("ask", "given", "words"),
    [pytest.param(ask, *row, id=row[-1]) for ask, rows in REFUSALS.items() for row in rows],
)
def test_what_is_impossible_is_refused(ask, given, words):
    with pytest.raises(InputError) as caught:
        ask(given)
    assert_refused(str(caught.value), words)


@pytest.mark.parametrize("beads", [10**13, {"count": 10**9, "cell": ["steel 9.5 mm"]}])
def test_many_beads_are_refused_at_once_and_without_memory(beads):
    tracemalloc.start()
    start = time.process_time()
    with pytest.raises(InputError, match="GiB of memory are needed, above the 16 GiB"):
        CHAIN({"beads": beads})
    assert time.process_time() - start < 1.0
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 10 * 2**20


POSSIBLE = [
    *((CHAIN, {f"record__probes__{name}": PROBE}) for name in ("start", "stop", "step", "limit")),
    (CHAIN, {"record__probes__span": PROBE, f"{STEADY}beads": [1, 420]}),
    # A hundred thousand beads for an hour, a thousand snapshots, ten million samples.
    (CHAIN, {"beads": 100_000, "record__grid__step": 500, f"{STEADY}step": 3.6e-5}),
    # Beads thrown off a free end cost nothing.
    (CHAIN, {"boundary": PISTON, "end_time": 1e12, "record__grid__step": 1e9}),
    (chain_of, masses(taper={"difference": -0.24})),
    # Its weight compresses each contact of a softening chain.
    (
        chain_of,
        {"law": {"alpha": 0.8, "beta": 1, "gamma": 0.2}, "gravity": 0.1} | held(WALL),
    ),
    # What printed numbers measure.
    (section, ("laws.damping_regimes", {"alpha": 2, "betas": [1, 3], "decades": 5, "points": 9})),
    (section, ("scenes.heteroclinic.damping_sweep.mu", [1, 2])),
]


@pytest.mark.parametrize(("ask", "given"), POSSIBLE)
def test_what_is_large_or_odd_but_possible_is_accepted(ask, given):
    ask(given)
