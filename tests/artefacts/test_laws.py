"""Fronts of many laws agree with the jump conditions, and those of pistons with (22) and (23)."""

import pytest
from conftest import read_dataset


@pytest.mark.parametrize(
    "name",
    [
        "speed_exact",
        "speed_travelling",
        "speed_driven",
        "velocity_jump_driven",
        "power_exact",
        "power_driven",
    ],
)
def test_measurements_agree_with_theory(results, name, as_in_the_paper):
    as_in_the_paper("laws/jump_conditions")
    data = read_dataset(results / "data/laws/jump_conditions.nc", "jump_conditions")
    expected = f"{name.rpartition('_')[0]}_expected"
    errors = data[f"{name}_error"] + data[f"{expected}_error"]
    assert data.sizes["law"] >= 8
    assert (abs(data[name] - data[expected]) <= errors).all()
    assert name.endswith("driven") or (data[f"{name}_error"] < 1e-12).all()


@pytest.mark.parametrize("name", ["front_speed", "compression_behind", "velocity_behind"])
def test_fronts_of_pistons_agree_with_theory(results, name, as_in_the_paper):
    """Within errors of 1e-6 on 1600 beads."""
    as_in_the_paper("laws/piston")
    data = read_dataset(results / "data/laws/piston.nc", "piston")
    assert 0.0 in data["ramp"]
    assert data.sizes["ramp"] >= 2
    assert (abs(data[name] - data[f"{name}_expected"]) <= data[f"{name}_error"]).all()
    assert (data[f"{name}_error"] <= 1e-6).all()
