"""The data of every chain scene obey the laws they should, and say how wrong they can be."""

import json

import numpy as np
import pytest
from conftest import read_dataset

SCENES = ["initiation_underdamped", "initiation_overdamped"]


@pytest.fixture(params=SCENES)
def motion(request, results):
    return read_dataset(results / "data" / "chain" / f"{request.param}.nc")


@pytest.fixture
def scene(motion):
    return json.loads(motion.attrs["config"])


def test_balances_close(motion):
    assert motion.attrs["momentum_drift"] < 1e-12
    assert motion.attrs["energy_drift"] < 1e3 * motion.attrs["relative_tolerance"]


def test_momentum_law(motion, scene):
    exact = scene["boundary"]["left"] ** scene["law"]["alpha"] * motion["t_grid"]
    np.testing.assert_allclose(motion["total_velocity"], exact, rtol=1e-12, atol=1e-13)


def test_front_runs_at_the_predicted_speed(motion, scene, as_in_the_paper):
    as_in_the_paper(f"chain/{motion.attrs['scene']}")
    predicted = scene["boundary"]["left"] ** ((scene["law"]["alpha"] - 1.0) / 2.0)
    # The transient of the sudden start fades along the chain.
    assert float(motion["front_speed"]) == pytest.approx(predicted, rel=0.3 / scene["beads"])


def test_every_number_has_an_error(motion):
    for name, variable in motion.data_vars.items():
        estimate = variable.attrs["error_estimate"]
        assert estimate >= 0.0 or np.isnan(variable).all(), name


def test_strong_damping_opens_no_gap(results, as_in_the_paper):
    as_in_the_paper("chain/initiation_overdamped")
    motion = read_dataset(results / "data" / "chain" / "initiation_overdamped.nc")
    assert np.isnan(motion["first_gap_time"])
    # Ahead of the wave the interpolation rounds to either side of zero.
    assert float(motion["relative_displacement_grid"].min()) > -1e-30
