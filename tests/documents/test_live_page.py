"""The page that computes a chain in a browser, against the package."""

import json

import pytest
from browser import CHROMIUM, browser

import granular_fronts as gf
from projects import ROOT

FILES = [(ROOT / "docs" / "live" / name).as_uri() for name in ("index.html", "chain.js")]
MOTION = "JSON.stringify({...chain, seen: chain.measure(), scene: JSON.parse(python.textContent)})"
MOVE = "find('{0}').value = {1}; find('{0}').dispatchEvent(new Event('input')); chain.time"
pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium to show the page")


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    with browser(tmp_path_factory.mktemp("profile")) as page:
        page.open(FILES[0], 1000, 900)
        page.wait_for("document.readyState === 'complete'")
        page.evaluate(MOVE.format("count", 20))
        yield page
        assert (page.complaints(), page.requests()) == ([], FILES)


def compute(scene, end_time):
    scene = scene | {"end_time": end_time, "record": {"snapshots": [end_time]}}
    motion = gf.simulate_chain(scene).isel(t=0)
    return motion["relative_displacement"].values[:-1], motion["velocity"].values


def agree(shown, computed):
    runs = zip(shown["seen"].values(), computed, shown["errors"].values(), strict=True)
    return all([*a.values()] == pytest.approx(b, rel=0, abs=error) for a, b, error in runs)


@pytest.mark.parametrize(("how", "beta"), [("press", 1.5), ("strike", 1.2), ("push", 2)])
def test_motion_is_that_of_the_package_within_its_own_error(page, how, beta):
    page.evaluate(MOVE.format("beta", beta) + f"; find('{how}').click(); find('play').click()")
    shown = json.loads(page.evaluate(f"while (chain.time < 60) chain.advance(); {MOTION}"))
    assert agree(shown, compute(shown["scene"], shown["time"]))


def test_another_damping_acts_at_once_and_the_motion_goes_on(page):
    page.evaluate(MOVE.format("count", 120) + "; find('press').click()")
    page.wait_for("chain.time > 5")
    turned = page.evaluate(MOVE.format("gamma", 0.4))
    page.wait_for(f"chain.time > {turned + 5}")
    shown = json.loads(page.evaluate(MOTION))
    scene = shown["scene"]
    assert not agree(shown, compute(scene, shown["time"]))
    u, v = compute(scene | {"law": scene["law"] | {"gamma": 0.06}}, turned)
    scene["start"] = {"kind": "given", "relative_displacement": [*u], "velocity": [*v]}
    assert agree(shown, compute(scene, shown["time"] - turned))


def test_critical_damping_is_that_of_the_package(page):
    shown = page.evaluate("criticalDamping(3)")
    assert shown == pytest.approx(3 * gf.critical_damping(3), rel=1e-12)
