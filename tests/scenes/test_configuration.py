"""Scenes and sections of the configuration: what is accepted, and how soon something is refused."""

import time
import tracemalloc

import numpy as np
import pytest
from configurations import SCENE, change

from granular_fronts.errors import InputError
from granular_fronts.scenes import memory
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.configuration import check_configuration
from granular_fronts.scenes.orbit import Orbits

PISTON = {"kind": "piston", "velocity": 0.05, "right": 0}


@pytest.fixture(autouse=True)
def sixteen_gibibytes(monkeypatch):
    """What is refused must not depend on the machine of the test."""
    monkeypatch.setattr(memory, "memory_of_machine", lambda: 16 * 2**30)


PROBE = {"beads": [1], "start": 0, "stop": 1, "step": 1}
STEADY = "record__probes__steady__"


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


def test_parameters_may_leave_out_what_printed_numbers_measure(default):
    regimes = {"alpha": 2, "betas": [1, 1.5, 2, 3], "decades": 5, "points": 9}
    default["laws"]["damping_regimes"] = regimes
    default["scenes"]["heteroclinic"]["damping_sweep"]["mu"] = [1, 2]
    check_configuration(default)


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
