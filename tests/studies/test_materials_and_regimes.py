"""Materials and damping regimes against closed formulas and each other."""

import numpy as np
import pandas as pd
import pytest
from configurations import DEFAULT
from tabulate_materials import tabulate_materials

import granular_fronts as gf
from granular_fronts.output.datasets import write_dataset
from granular_fronts.scenes.yaml_files import load_configuration
from granular_fronts.studies.damping_regimes import evaluate_regimes
from granular_fronts.studies.materials import evaluate_materials


@pytest.fixture(scope="module")
def given():
    return load_configuration(DEFAULT)["laws"]["materials"]


@pytest.fixture(scope="module")
def materials(given):
    return evaluate_materials(**given)


def test_materials_are_consistent(materials, given):
    for material in materials["material"].values:
        one, mass = materials.sel(material=material), given["beads"][material]["mass"]
        law = float(one["stiffness"]), float(one["contact_damping"])
        scaled = gf.Scaling(mass, *law, given["impact_velocity"])
        assert scaled.gamma == pytest.approx(float(one["gamma"]), rel=1e-12)
        e, printed = float(one["restitution"]), float(one["gamma_printed"])
        assert gf.restitution(float(one["gamma"])) == pytest.approx(e, rel=1e-12)
        assert gf.restitution(printed) == pytest.approx(float(one["restitution_exact"]), rel=1e-12)
        # The linear rule is right for weak damping and too low otherwise.
        assert printed < float(one["gamma"])
        assert abs(float(one["gamma"]) / printed - 1.0) < 3.0 * (1.0 - e)


def test_front_damping_scales_with_the_velocity_and_hardly_with_the_stiffness(materials, given):
    """γ ∝ k^(−1/15) at a given force: a modulus known to a few per cent is good enough."""
    ratio = materials["gamma_front_piston"] / materials["gamma"]
    expected = (materials["piston_velocity"] / given["impact_velocity"]) ** 0.2
    np.testing.assert_allclose(ratio, expected.broadcast_like(ratio), rtol=1e-12)
    beads = given["beads"]["cork"]
    found = evaluate_materials({"ptfe": beads, "cork": beads}, 0.5, [1.0], [100.0])
    stiff, soft = found["gamma_front_force"].values[:, 0]
    ratio = np.divide(*found["stiffness"].values)
    assert soft / stiff == pytest.approx(ratio ** (1.0 / 15.0), rel=1e-12)


def test_table_names_the_regime_of_each_front(materials, tmp_path):
    csv, markdown = tmp_path / "materials.csv", tmp_path / "materials.md"
    write_dataset(materials, tmp_path / "data.nc", scene_id="materials", config={})
    tabulate_materials(tmp_path / "data.nc", csv, markdown)
    table = pd.read_csv(csv)
    oscillates = table["gamma_of_front"] < gf.critical_damping(1.5)
    assert list(table["regime"] == "underdamped") == list(oscillates)
    assert 0 < oscillates.sum() < len(table)
    critical = float(materials["critical_gamma"])
    for gamma, complex_root in ((0.999 * critical, True), (1.001 * critical, False)):
        assert (gf.tail_roots(1.5, gamma, count=1)[0].imag > 0.0) == complex_root


def test_regimes_follow_equation_29():
    found = evaluate_regimes(1.5, [1.0, 1.25, 1.5, 2.5], 2.0, 5)
    slopes = np.diff(np.log(found["gamma"])) / np.diff(np.log(found["velocity_ratio"]))
    for beta, slope in zip(found["beta"].values, slopes, strict=True):
        np.testing.assert_allclose(slope, 2.0 * beta / 2.5 - 1.0, atol=1e-14)
    np.testing.assert_allclose(found["gamma"].sel(velocity_ratio=1.0, method="nearest"), 1.0)
    critical = found["critical_gamma"]
    assert float(critical.sel(beta=1.5)) == gf.critical_damping(1.5)
    np.testing.assert_allclose(critical * critical["beta"], 1.5 * gf.critical_damping(1.5))
    e = found["restitution"]
    assert np.all(np.diff(e.sel(beta=2.5)) < 0.0)
    assert np.all(np.diff(e.sel(beta=1.0)) >= 0.0)
    assert np.all(np.diff(e.sel(beta=1.25)) == 0.0)
