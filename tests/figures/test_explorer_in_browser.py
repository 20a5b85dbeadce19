"""The page to explore in a browser: it answers hands and keys, and asks the network for nothing."""

import re

import numpy as np
import pytest
from browser import CHROMIUM, browser
from explored import GAMMAS, SCENE, write_page

import granular_fronts as gf
from granular_fronts.output.style import CONTINUUM_LOOKS

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium to show the page"),
]

NUMBER = r"(-?[\d.]+(?:e-\d+)?)"
READING = re.compile(
    rf"At t = {NUMBER}, bead (\d+): (?:relative displacement {NUMBER} ± {NUMBER}, |the last one, )"
    rf"velocity {NUMBER} ± {NUMBER}\. (?:No contact is open|Open contacts: (\d+))\."
)
FIELDS = ("relative_displacement", "velocity")


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
    show(shown, data["address"])
    yield shown
    assert shown.complaints() == []
    assert {url.partition("#")[0] for url in shown.requests()} == {data["address"]}


def show(browser, address):
    browser.open(address, 1280, 900)
    browser.wait_for("document.getElementById('front-reading')?.textContent.includes('α')")


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


def place_on(page, half, plot, x, y):
    """Where on the screen the axes of a plot say x and y."""
    return page.evaluate(
        f"(() => {{ const plot = explorer.{half}.plots.{plot};"
        "plot.canvas.scrollIntoView({block: 'center'});"
        "const b = plot.canvas.getBoundingClientRect();"
        f"return [b.left + plot.x({x}), b.top + plot.y({y})] }})()"
    )


def expect_motion(page, motion):
    """The words beside the motion are true of the dataset within the errors that they state."""
    found = READING.fullmatch(text(page, "motion-reading"))
    t, bead, *numbers, opened = found.groups()
    moment = motion.sel(t_grid=float(t), method="nearest")
    for field, value, error in zip(FIELDS, numbers[::2], numbers[1::2], strict=True):
        if value is None:
            assert int(bead) == motion.sizes["bead"]
            continue
        exact = float(moment[f"{field}_grid"].sel(bead=int(bead)))
        assert abs(float(value) - exact) <= float(error) < 1e-4
    u = moment["relative_displacement_grid"]
    error = float(numbers[1] or 0.0)
    assert (u < -error).sum() <= int(opened or 0) <= (u < 0.0).sum()
    return float(t), int(bead), int(opened or 0)


def test_words_follow_the_dragged_time_and_bead(page, data):
    motion = data["flying"]
    start, *_ = expect_motion(page, motion)
    drag_slider(page, "time", 0.9)
    drag_slider(page, "bead", 0.5)
    t, bead, opened = expect_motion(page, motion)
    assert t > start
    assert opened > 0
    spoken = page.evaluate("document.getElementById('time').getAttribute('aria-valuetext')")
    assert text(page, "time-value") == spoken == f"t = {t:g}"
    u = motion.sel(t_grid=t)["relative_displacement_grid"]
    shown = page.evaluate("explorer.motions.plots.beads.shown")
    place = page.evaluate("explorer.motions.plots.beads.place")
    largest = float(motion["relative_displacement_grid"].max())
    expected = 0.4 * u.sel(bead=shown[:-1]) / largest
    apart = np.diff([place[str(n)] for n in shown])
    np.testing.assert_allclose(1.0 - apart, expected, rtol=0, atol=1e-4 / largest)
    assert place[str(bead)] == bead


def test_a_held_end_is_no_contact(page, data):
    """Contact N lies between the last bead and nothing: it is in no picture and no word."""
    rows = page.evaluate("explorer.motions.motion().relative_displacement.rows[0].length")
    assert rows == data["flying"].attrs["contacts"] == SCENE["beads"] - 1
    drag_slider(page, "bead", 1.0)
    assert "the last one, velocity" in text(page, "motion-reading")


def test_contacts_extended_by_less_than_the_error_are_not_open(page):
    drag_slider(page, "time", 0.9)
    assert "Open contacts:" in text(page, "motion-reading")
    page.evaluate("explorer.motions.motion().relative_displacement.error = 1e3")
    drag_slider(page, "time", 0.95)
    assert "No contact is open." in text(page, "motion-reading")


def test_time_runs_by_keys_and_by_itself_and_play_follows_the_front(page, data):
    before, *_ = expect_motion(page, data["flying"])
    page.evaluate("document.getElementById('time').focus()")
    page.press("ArrowRight", 39)
    after, *_ = expect_motion(page, data["flying"])
    assert after == before + 2.0
    page.evaluate("document.getElementById('play').click()")
    assert page.evaluate("document.getElementById('motion-reading').ariaLive") == "off"
    page.wait_for("Number(document.getElementById('time').value) >= 12")
    page.evaluate("document.getElementById('play').click()")
    t, bead, _ = expect_motion(page, data["flying"])
    assert text(page, "play") == "Play"
    assert page.evaluate("document.getElementById('motion-reading').ariaLive") == "polite"
    if t < SCENE["beads"] / 0.1**0.25:
        # The front of jump δ moves with the speed δ^((α − 1)/2), after some beads of build-up.
        assert bead == pytest.approx(0.1**0.25 * t, abs=3.0)


def test_crosshair_is_dragged_by_mouse_and_by_touch(page, data):
    start, stop = (place_on(page, "motions", "spacetime", *at) for at in ((3, 20), (7.2, 60.7)))
    page.drag(start, stop)
    assert expect_motion(page, data["flying"])[:2] == (60.0, 7)
    stop = place_on(page, "motions", "u", 12.1, 0)
    page.drag(place_on(page, "motions", "u", 4, 0), stop)
    assert expect_motion(page, data["flying"])[:2] == (60.0, 12)
    for kind, at in {"Start": (5, 30), "Move": (9.1, 40.3), "End": None}.items():
        x, y = place_on(page, "motions", "spacetime", *at) if at else (0, 0)
        points = [{"x": x, "y": y}] if at else []
        page.call("Input.dispatchTouchEvent", type=f"touch{kind}", touchPoints=points)
    page.wait_for("document.getElementById('bead').value === '9'")
    assert expect_motion(page, data["flying"])[:2] == (40.0, 9)


def test_fronts_are_chosen_by_hand_and_on_the_atlas(page, data):
    drag_slider(page, "exponent", 1.0)
    drag_slider(page, "damping", 0.0)
    expect_front(page, data["collection"].isel(alpha=1, gamma=0))
    start, stop = (place_on(page, "fronts", "atlas", *at) for at in ((1.5, 0.2), (1.25, 0.7)))
    page.drag(start, stop)
    expect_front(page, data["collection"].isel(alpha=0, gamma=2))


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
    for name, look in CONTINUUM_LOOKS.items():
        assert f"{look.label} {four_digits(front[f'distance_{name}'])}" in said


def four_digits(value):
    """A number with four digits, as the page writes it."""
    return re.sub(r"e([+-])0(\d)", r"e\1\2", f"{float(value):.4g}")


def test_address_restores_the_state(shown, page, data):
    page.drag(*[place_on(page, "motions", "spacetime", 7, 60)] * 2, steps=0)
    drag_slider(page, "exponent", 1.0)
    drag_slider(page, "damping", 0.0)
    page.evaluate("setControl(document.getElementById('field'), 'velocity')")
    page.wait_for("location.hash.includes('velocity')")
    address = page.evaluate("location.href")
    assert {"time=60", "bead=7", "exponent=1.5", "damping=0.1"} <= set(
        address.partition("#")[2].split("&")
    )
    words = [text(page, f"{name}-reading") for name in ("motion", "front")]
    show(shown, address)
    assert [text(shown, f"{name}-reading") for name in ("motion", "front")] == words
    assert shown.evaluate("document.getElementById('field').value") == "velocity"


@pytest.mark.parametrize("state", ["scene=none&field=<b>&time=x&bead=-4", "%%%", "gamma=1e999"])
def test_an_address_without_sense_does_no_harm(shown, data, state):
    show(shown, f"{data['address']}#{state}")
    expect_motion(shown, data["flying"])
    assert shown.complaints() == []


def test_tasks_bring_the_page_into_their_states(page, data):
    buttons = "document.querySelectorAll('button[data-state]')"
    assert page.evaluate(f"{buttons}.length") == 3
    page.evaluate(f"{buttons}[0].click()")
    page.wait_for("document.getElementById('bead').value === '20'")
    assert expect_motion(page, data["flying"])[2] > 0
    page.evaluate(f"{buttons}[1].click()")
    page.wait_for("document.getElementById('damping').value === '0'")
    assert "oscillates: λ" in text(page, "front-reading")
    page.evaluate(f"{buttons}[2].click()")
    page.wait_for("document.getElementById('scene').value === 'live'")
    page.wait_for("explorer.motions.motion().beads === 60")
    # Every bead between start and free end is passed by a pulse of the same height.
    rows = "explorer.motions.motion().velocity.rows.map(row => Array.from(row))"
    heights = np.max(page.evaluate(rows), axis=0)[15:50]
    assert np.ptp(heights) < 0.05 * heights.mean()


LIVE = {"alpha": 1.5, "beta": 1.5, "gamma": 0.1, "count": 15}


@pytest.mark.parametrize(
    "live",
    [
        LIVE | {"start": "press", "drive": 0.1},
        LIVE | {"start": "press", "drive": 0.5, "gamma": 2, "alpha": 2},
        LIVE | {"start": "strike", "drive": 1, "beta": 2},
        LIVE | {"start": "strike", "drive": 0.1, "gamma": 0},
    ],
)
def test_chain_computed_in_the_page_is_near_the_one_of_the_package(shown, data, live):
    state = "&".join(f"{name}={value}" for name, value in live.items())
    show(shown, f"{data['address']}#scene=live&{state}")
    shown.wait_for(f"explorer?.motions.motion().beads === {live['count']}")
    assert shown.evaluate("!document.querySelector('.live.warning').hidden")
    page_holds = "explorer.motions.motion()"
    times = np.array(shown.evaluate(f"{page_holds}.times"))
    pressed = live["start"] == "press"
    beads = live["count"]
    given = {"relative_displacement": [0.0] * (beads - 1)}
    given["velocity"] = [float(live["drive"])] + [0.0] * (beads - 1)
    exact = gf.simulate_chain(
        {
            "law": {name: live[name] for name in ("alpha", "beta", "gamma")},
            "beads": beads,
            "boundary": {"kind": "pressure", "left": live["drive"] * pressed, "right": 0.0},
            "start": {"kind": "rest"} if pressed else {"kind": "given", **given},
            "end_time": times[-1],
            "tolerance": {"relative": 1.0e-9, "absolute": 1.0e-12},
            "record": {"snapshots": times[::12].tolist()},
        }
    )
    for field in FIELDS:
        rows = shown.evaluate(f"{page_holds}.{field}.rows.map(row => Array.from(row))")
        computed = np.array(rows)[::12]
        difference = np.abs(computed - exact[field].values[:, : computed.shape[1]]).max()
        assert difference < 1e-3
        # It states how far it may be wrong, and is not exact.
        assert 0.0 < difference < shown.evaluate(f"{page_holds}.{field}.error")
    assert np.abs(exact["velocity"]).max() > 0.01
    assert shown.complaints() == []


def test_every_control_and_picture_has_a_name(page):
    nodes = page.call("Accessibility.getFullAXTree")["nodes"]
    named = {"slider": [], "combobox": [], "button": [], "image": []}
    for node in nodes:
        if (role := node.get("role", {}).get("value")) in named:
            named[role].append(node.get("name", {}).get("value", ""))
    counts = {role: len(names) for role, names in named.items()}
    assert counts == {"slider": 4, "combobox": 2, "button": 4, "image": 8}
    assert all(name for names in named.values() for name in names)


@pytest.mark.parametrize("width", [400, 1280, 1920])
def test_nothing_is_wider_than_the_window(page, width):
    page.resize(width, 900)
    page.wait_for(f"innerWidth === {width} && document.documentElement.scrollWidth <= innerWidth")
    page.evaluate("setControl(document.getElementById('scene'), 'live')")
    page.wait_for("document.documentElement.scrollWidth <= innerWidth")
