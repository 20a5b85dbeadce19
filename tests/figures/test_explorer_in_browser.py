"""The page to explore in a browser: it answers hands and keys, and asks the network for nothing."""

import re
from pathlib import Path
from urllib.parse import urlparse
from urllib.request import url2pathname

import numpy as np
import pytest
from browser import CHROMIUM, browser
from explored import GAMMAS, write_page

from explorer.encoding import decode, encode

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium to show the page"),
]

NUMBER = r"(-?[\d.]+(?:e-\d+)?)"
READING = re.compile(
    rf"At t = {NUMBER}, bead (\d+): relative displacement {NUMBER} ± {NUMBER}, "
    rf"velocity {NUMBER} ± {NUMBER}\. (?:No contact is open|Open contacts: (\d+))\."
)
FIELDS = ("relative_displacement_grid", "velocity_grid")


@pytest.fixture(scope="module")
def data(tmp_path_factory):
    """The datasets, and the address of the page."""
    page, datasets = write_page(tmp_path_factory.mktemp("explorer"))
    return datasets | {"address": page.as_uri()}


@pytest.fixture(scope="module")
def shown(tmp_path_factory):
    """A browser for all tests."""
    with browser(tmp_path_factory.mktemp("profile")) as found:
        yield found


@pytest.fixture
def page(shown, data):
    """The page as it opens; in the end nothing was asked of the network, nothing complained."""
    shown.open(data["address"], 1280, 900)
    shown.wait_for("document.getElementById('front-reading')?.textContent.includes('α')")
    yield shown
    assert shown.complaints() == []
    assert shown.requests() == [data["address"]]


def text(page, name):
    return page.evaluate(f"document.getElementById('{name}').textContent")


def drag_slider(page, name, share):
    """Drag the knob of a slider to a share of its length, as a mouse does."""
    page.evaluate(f"document.getElementById('{name}').scrollIntoView({{block: 'center'}})")
    left, top, width, height, place = page.evaluate(
        f"(() => {{ const s = document.getElementById('{name}'), b = s.getBoundingClientRect();"
        "return [b.left, b.top, b.width, b.height, (s.value - s.min) / (s.max - s.min)] })()"
    )
    knob = 16.0
    start, stop = (left + knob / 2 + (width - knob) * one for one in (place, share))
    page.drag((start, top + height / 2), (stop, top + height / 2))


def expect_motion(page, motion):
    """The words beside the motion are true of the dataset within the errors that they state."""
    found = READING.fullmatch(text(page, "motion-reading"))
    t, bead, *numbers, opened = found.groups()
    moment = motion.sel(t_grid=float(t), method="nearest")
    for field, value, error in zip(FIELDS, numbers[::2], numbers[1::2], strict=True):
        exact = float(moment[field].sel(bead=int(bead)))
        assert abs(float(value) - exact) <= float(error) < 1e-4
    encoded = encode(moment[FIELDS[0]])
    error = moment[FIELDS[0]].attrs["error_estimate"] + encoded["steps"] / 2
    assert int(opened or 0) == (decode(encoded) < -error).sum()
    return float(t), int(opened or 0)


def test_words_and_panels_follow_the_dragged_time_and_bead(page, data):
    motion = data["flying"]
    start, _ = expect_motion(page, motion)
    drag_slider(page, "time", 0.9)
    drag_slider(page, "bead", 0.5)
    t, opened = expect_motion(page, motion)
    assert t > start
    assert opened > 0
    spoken = page.evaluate("document.getElementById('time').getAttribute('aria-valuetext')")
    assert text(page, "time-value") == spoken == f"t = {t:g}"
    moment, largest = motion.sel(t_grid=t), float(motion["relative_displacement_grid"].max())
    u, source = moment[FIELDS[0]], "Array.from(Bokeh.documents[0].get_model_by_name('{}')"
    source += ".renderers[{}].data_source.data.{})"
    v = page.evaluate(source.format("velocity", 0, "v"))
    np.testing.assert_allclose(v, moment["velocity_grid"], rtol=0, atol=1e-4)
    marked = page.evaluate(source.format("relative_displacement", 2, "n"))
    assert len(marked) == opened
    assert (u.sel(bead=marked) < 0.0).all()
    places, beads = (page.evaluate(source.format("beads", 0, name)) for name in ("x", "n"))
    expected = 0.4 * u.sel(bead=beads[:-1]) / largest
    np.testing.assert_allclose(1.0 - np.diff(places), expected, rtol=0, atol=1e-4 / largest)


def test_contacts_extended_by_less_than_the_error_are_not_open(shown, data, tmp_path):
    """The same page with an error of u that is larger than every gap."""
    u = data["flying"]["relative_displacement_grid"]
    html = Path(url2pathname(urlparse(data["address"]).path)).read_text(encoding="utf-8")
    known, larger = (f'["error",{error}]' for error in (u.attrs["error_estimate"], 1.0e3))
    assert html.count(known) == 1
    uncertain = tmp_path / "uncertain.html"
    uncertain.write_text(html.replace(known, larger), encoding="utf-8")
    expected = {data["address"]: "Open contacts:", uncertain.as_uri(): "No contact is open."}
    for address, opened in expected.items():
        shown.open(address, 1280, 900)
        shown.wait_for("document.getElementById('motion-reading')?.textContent.includes('bead')")
        drag_slider(shown, "time", 0.9)
        assert opened in text(shown, "motion-reading")


def test_time_runs_by_keys_and_by_itself(page, data):
    before, _ = expect_motion(page, data["flying"])
    page.evaluate("document.getElementById('time').focus()")
    page.press("ArrowRight", 39)
    after, _ = expect_motion(page, data["flying"])
    assert after == before + 2.0
    page.evaluate("document.getElementById('play').click()")
    assert page.evaluate("document.getElementById('motion-reading').ariaLive") == "off"
    page.wait_for("Number(document.getElementById('time').value) >= 15")
    page.evaluate("document.getElementById('play').click()")
    assert expect_motion(page, data["flying"])[0] >= 30.0
    assert text(page, "play") == "Play"
    assert page.evaluate("document.getElementById('motion-reading').ariaLive") == "polite"


def test_fronts_are_chosen_by_hand_and_on_the_atlas(page, data):
    drag_slider(page, "exponent", 1.0)
    drag_slider(page, "damping", 0.0)
    expect_front(page, data["collection"].isel(alpha=1, gamma=0))
    tap_panel(page, "atlas", 1.25, 0.7)
    expect_front(page, data["collection"].isel(alpha=0, gamma=2))


def tap_panel(page, name, x, y):
    """Tap on a panel where its axes say x and y."""
    left, top = page.evaluate(
        f"(() => {{ const view = Bokeh.index.find_one_by_id("
        f"Bokeh.documents[0].get_model_by_name('{name}').id);"
        "view.el.scrollIntoView({block: 'center'});"
        "const b = view.canvas_view.el.getBoundingClientRect();"
        "const {x_scale, y_scale} = view.frame;"
        f"return [b.left + x_scale.compute({x}), b.top + y_scale.compute({y})]"
        "})()"
    )
    page.drag((left, top), (left, top), steps=0)


def test_moment_is_chosen_on_the_space_time_picture(page, data):
    tap_panel(page, "spacetime", 7.2, 60.7)
    t, _ = expect_motion(page, data["flying"])
    assert t == 60.0
    assert text(page, "bead-value") == "n = 7"


def expect_front(page, front):
    said = text(page, "front-reading")
    alpha, gamma = float(front["alpha"]), float(front["gamma"])
    assert gamma in GAMMAS
    overshoot = four_digits(front["overshoot"])
    assert said.startswith(f"α = {alpha:g}, γ = {gamma:g}: overshoot {overshoot},")
    assert str(front["verdict"].values) in said
    assert f"λ = {four_digits(front['tail_root_real'][0])}" in said
    oscillates = float(front["tail_root_imaginary"][0]) > 0.0
    assert ("does not oscillate" in said) == (not oscillates)
    for words, name in {"(45)": "logarithmic", "(46)": "unlimited"}.items():
        assert f"{words} {four_digits(front[f'distance_{name}'])}" in said


def four_digits(value):
    """A number with four digits, as the page writes it."""
    rounded = f"{float(value):.4g}"
    return re.sub(r"e([+-])0(\d)", r"e\1\2", rounded)


def test_every_control_and_figure_has_a_name(page):
    nodes = page.call("Accessibility.getFullAXTree")["nodes"]
    named = {"slider": [], "combobox": [], "button": [], "figure": []}
    for node in nodes:
        if (role := node.get("role", {}).get("value")) in named:
            named[role].append(node.get("name", {}).get("value", ""))
    counts = {role: len(names) for role, names in named.items() if role != "button"}
    assert counts == {"slider": 4, "combobox": 2, "figure": 8}
    assert all(name for names in named.values() for name in names)


@pytest.mark.parametrize("width", [400, 1280])
def test_nothing_is_wider_than_the_window(page, width):
    page.resize(width, 900)
    page.wait_for(f"innerWidth === {width} && document.documentElement.scrollWidth <= innerWidth")
