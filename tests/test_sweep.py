"""Sweeps of exact fronts along the damping."""

import numpy as np
import pytest

import granular_fronts as gf
from granular_fronts.configuration import ConfigurationError
from granular_fronts.datasets import read_dataset, write_dataset


@pytest.mark.parametrize(("alpha", "beta"), [(1.5, None), (1.5, 1.0), (3.0, 4.0)])
def test_sweep_agrees_with_single_fronts_in_any_order(alpha, beta):
    gammas = np.geomspace(0.08, 1.2, 25)
    shuffled = np.random.default_rng(3).permutation(gammas)
    sweep = gf.sweep_fronts(alpha, shuffled, beta)
    np.testing.assert_array_equal(sweep["gamma"], shuffled)
    assert (sweep["converged"] == 1).all()
    power = (alpha - 1.0) / (2.0 * (alpha + 1.0))
    np.testing.assert_allclose(sweep["dissipated_power"], power, atol=1e-14)
    assert np.abs(sweep["speed_defect"]).max() <= 1e-14
    assert sweep["error_estimate"].max() <= 1e-12
    for gamma in shuffled[::8]:
        front, point = gf.solve_front(alpha, gamma, beta), sweep.sel(gamma=gamma)
        for name in ("overshoot", "width_10_90", "slope", "dissipated_power"):
            allowed = 1e-14 + 2.0 * (point[f"{name}_error"] + front.attrs[f"{name}_error"])
            assert abs(point[name] - front.attrs[name]) <= allowed
        root = gf.tail_roots(alpha, gamma, beta, count=1)[0]
        assert point["tail_rate"] == root.real
        assert point["tail_frequency"] == root.imag


def test_a_point_that_fails_is_named_and_the_sweep_goes_on():
    sweep = gf.sweep_fronts(5.0, [0.5, 1e-3, 0.1])
    np.testing.assert_array_equal(sweep["converged"], [1, 0, 1])
    assert sweep["reason"].values[1]
    assert np.isnan(sweep["overshoot"].values[1])
    assert 0.0 < sweep["overshoot"].values[0] < sweep["overshoot"].values[2]


def test_overshoot_falls_and_width_grows_with_damping():
    sweep = gf.sweep_fronts(1.5, np.geomspace(0.05, 0.2, 40))
    assert (np.diff(sweep["overshoot"]) < 0.0).all()
    assert (np.diff(sweep["width_10_90"]) > 0.0).all()


def test_a_sweep_can_be_written_and_read(tmp_path):
    sweep = gf.sweep_fronts(1.5, [0.3, 0.2])
    write_dataset(sweep, tmp_path / "sweep.nc", scene_id="sweep", config={"alpha": 1.5})
    again = read_dataset(tmp_path / "sweep.nc", "sweep")
    np.testing.assert_array_equal(again["overshoot"], sweep["overshoot"])


def test_impossible_sweeps_are_refused():
    with pytest.raises(ConfigurationError, match="gamma is 0"):
        gf.sweep_fronts(1.5, [0.1, 0.0])
    with pytest.raises(ConfigurationError, match="must be a list"):
        gf.sweep_fronts(1.5, [])
