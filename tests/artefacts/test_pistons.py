"""Every front of a piston has the speed, compression and velocity of equations (22) and (23)."""

import pytest
from conftest import read_dataset


@pytest.mark.parametrize("name", ["front_speed", "compression_behind", "velocity_behind"])
def test_fronts_of_pistons_agree_with_theory(results, name, as_in_the_paper):
    """Within errors of 1e-6 on 1600 beads."""
    as_in_the_paper("laws/piston")
    data = read_dataset(results / "data" / "laws" / "piston.nc", "piston")
    assert 0.0 in data["ramp"]
    assert data.sizes["ramp"] >= 2
    assert (abs(data[name] - data[f"{name}_expected"]) <= data[f"{name}_error"]).all()
    assert (data[f"{name}_error"] <= 1e-6).all()
