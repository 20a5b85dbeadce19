"""Fronts of many laws agree with the jump conditions."""

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
