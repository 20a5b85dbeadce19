"""The page to explore in a browser: it answers hands and keys, and asks the network for nothing."""

import re

import numpy as np
import pytest
from browser import CHROMIUM, browser
from chains import driven_scene, given
from explored import SCENE, TOLERANCE, write_page

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


def show(page, address):
    page.open(address, 1280, 900)
    page.wait_for("typeof explorer !== 'undefined' && explorer !== null")


def text(page, name):
    return page.evaluate(f"document.getElementById('{name}').textContent")


def choose(page, name, value):
    page.evaluate(f"setControl(document.getElementById('{name}'), '{value}')")


def place_on(page, plot, x, y):
    """Where on the screen the axes of a plot say x and y."""
    return page.evaluate(
        f"(() => {{ const plot = explorer.{plot}; plot.canvas.scrollIntoView({{block: 'center'}});"
        "const b = plot.canvas.getBoundingClientRect();"
        f"return [b.left + plot.x({x}), b.top + plot.y({y})] }})()"
    )


def drag(page, plot, start, stop):
    page.drag(place_on(page, plot, *start), place_on(page, plot, *stop))


def expect_motion(page, motion):
    """The words below the motion are true of the dataset within the errors that they state."""
    t, bead, *numbers, opened = READING.fullmatch(text(page, "motion-reading")).groups()
    moment = motion.sel(t_grid=float(t), method="nearest")
    for field, value, error in zip(FIELDS, numbers[::2], numbers[1::2], strict=True):
        # The last bead has no contact.
        assert (value is None) == (field == FIELDS[0] and int(bead) == motion.sizes["bead"])
        if value is not None:
            exact = float(moment[f"{field}_grid"].sel(bead=int(bead)))
            assert abs(float(value) - exact) <= float(error) < 1e-3
    gaps = -moment["relative_displacement_grid"]
    assert (gaps > 1e-4).sum() <= int(opened or 0) <= (gaps > 0.0).sum()
    return float(t), int(bead), int(opened or 0)


def test_words_and_beads_follow_time_and_bead_and_a_held_end_is_no_contact(page, data):
    motion = data["flying"]
    u = motion["relative_displacement_grid"].isel(t_grid=36)
    choose(page, "time", 36)
    for bead in (10, 20):
        choose(page, "bead", bead)
        assert expect_motion(page, motion)[:2] == (72.0, bead)
    assert expect_motion(page, motion)[2] > 0
    spoken = page.evaluate("document.getElementById('time').getAttribute('aria-valuetext')")
    assert text(page, "time-value") == spoken == "t = 72"
    shown, place = (page.evaluate(f"explorer.motions.beads.{name}") for name in ("shown", "place"))
    largest = float(motion["relative_displacement_grid"].max())
    apart = np.diff([place[str(n)] for n in shown])
    expected = 1.0 - 0.4 * u.sel(bead=shown[:-1]) / largest
    np.testing.assert_allclose(apart, expected, rtol=0, atol=1e-4 / largest)
    # Contacts that are extended by less than the error are not open.
    page.evaluate("explorer.motion().relative_displacement.error = 1e3")
    choose(page, "bead", 10)
    assert "No contact is open." in text(page, "motion-reading")


def test_time_runs_by_keys_and_by_itself_and_play_follows_the_front(page, data):
    before, *_ = expect_motion(page, data["flying"])
    page.evaluate("document.getElementById('time').focus()")
    page.press("ArrowRight", 39)
    assert expect_motion(page, data["flying"])[0] == before + 2.0
    page.evaluate("document.getElementById('play').click()")
    assert page.evaluate("document.getElementById('motion-reading').ariaLive") == "off"
    page.wait_for("document.getElementById('time').value > 9")
    page.evaluate("document.getElementById('play').click()")
    t, bead, _ = expect_motion(page, data["flying"])
    assert page.evaluate("document.getElementById('motion-reading').ariaLive") == "polite"
    # The front of jump δ moves with the speed δ^((α − 1)/2) and ends at the last contact.
    assert bead == pytest.approx(min(0.1**0.25 * t, SCENE["beads"]), abs=3.0)


def test_crosshair_is_dragged_by_mouse_and_by_touch(page, data):
    drag(page, "motions.spacetime", (3, 20), (7.2, 60.7))
    assert expect_motion(page, data["flying"])[:2] == (60.0, 7)
    drag(page, "motions.u", (4, 0), (12.1, 0))
    assert expect_motion(page, data["flying"])[:2] == (60.0, 12)
    for kind, at in {"Start": (5, 30), "Move": (9.1, 40.3), "End": None}.items():
        x, y = place_on(page, "motions.spacetime", *at) if at else (0, 0)
        points = [{"x": x, "y": y}] if at else []
        page.call("Input.dispatchTouchEvent", type=f"touch{kind}", touchPoints=points)
    page.wait_for("document.getElementById('bead').value === '9'")
    assert expect_motion(page, data["flying"])[:2] == (40.0, 9)


def test_fronts_are_chosen_by_sliders_and_on_the_atlas(page, data):
    choose(page, "exponent", 1)
    choose(page, "damping", 0)
    expect_front(page, data["collection"].isel(alpha=1, gamma=0))
    drag(page, "fronts.atlas", (1.5, 0.2), (1.25, 0.7))
    expect_front(page, data["collection"].isel(alpha=0, gamma=2))


def expect_front(page, front):
    said = text(page, "front-reading")
    names = {"overshoot": "overshoot", "λ =": "tail_root_real"}
    names |= {look.label: f"distance_{name}" for name, look in CONTINUUM_LOOKS.items()}
    for words, name in {"α =": "alpha", "γ =": "gamma", **names}.items():
        exact = float(np.ravel(front[name])[0])
        assert float(re.search(rf"{words} {NUMBER}", said)[1].strip(".")) == pytest.approx(
            exact, 1e-3
        )
    oscillates = float(front["tail_root_imaginary"][0]) > 0.0
    assert ("does not oscillate" in said) == (not oscillates)
    assert str(front["verdict"].values) in said


def test_address_restores_the_state(page, data):
    drag(page, "motions.spacetime", (3, 20), (7, 60))
    for name, value in {"exponent": 1, "damping": 0, "field": "velocity"}.items():
        choose(page, name, value)
    page.wait_for("location.hash.includes('velocity')")
    address = page.evaluate("location.href")
    chosen = {"time=60", "bead=7", "exponent=1.5", "damping=0.1"}
    assert chosen <= set(address.partition("#")[2].split("&"))
    words = [text(page, f"{name}-reading") for name in ("motion", "front")]
    show(page, address)
    assert [text(page, f"{name}-reading") for name in ("motion", "front")] == words
    for state in ("scene=none&field=<b>&time=x&bead=-4", "%%%", "gamma=1e999"):
        show(page, f"{data['address']}#{state}")
        expect_motion(page, data["flying"])


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
    page.wait_for("explorer.motion().beads === 60")
    # Every bead between start and free end is passed by a pulse of the same height.
    heights = np.max(rows_of(page, "velocity"), axis=0)[15:50]
    assert np.ptp(heights) < 0.05 * heights.mean()


def rows_of(page, field):
    """What the page holds of a field, on times and numbers."""
    rows = f"explorer.motion().{field}.rows.map(row => Array.from(row))"
    return np.array(page.evaluate(rows))


@pytest.mark.parametrize(
    "chain",
    [
        {"start": "press", "drive": 0.1},
        {"start": "press", "drive": 0.5, "gamma": 2, "alpha": 2},
        {"start": "strike", "drive": 1, "beta": 2},
        {"start": "strike", "drive": 0.1, "gamma": 0},
    ],
)
def test_chain_computed_in_the_page_is_near_the_one_of_the_package(page, data, chain):
    chain = {"alpha": 1.5, "beta": 1.5, "gamma": 0.1, "count": 15} | chain
    state = "&".join(f"{name}={value}" for name, value in chain.items())
    show(page, f"{data['address']}#scene=live&{state}")
    assert page.evaluate("!document.querySelector('.live.warning').hidden")
    times, beads = page.evaluate("explorer.motion().times"), chain["count"]
    held, law = float(chain["drive"]), [chain[name] for name in ("alpha", "beta")]
    changes = {"tolerance": TOLERANCE, "record": {"snapshots": times[::12]}}
    if chain["start"] == "strike":
        struck = [held] + [0.0] * (beads - 1)
        held, changes["start"] = 0.0, given(struck[1:], struck)
    exact = gf.simulate_chain(driven_scene(chain["gamma"], beads, times[-1], *law, held, **changes))
    for field in FIELDS:
        computed = rows_of(page, field)[::12]
        difference = np.abs(computed - exact[field].values[:, : computed.shape[1]]).max()
        # It states how far it may be wrong, and is not exact.
        assert 0.0 < difference < page.evaluate(f"explorer.motion().{field}.error") < 1e-3
    assert np.abs(exact["velocity"]).max() > 0.01


@pytest.mark.parametrize("width", [400, 1280, 1920])
def test_nothing_is_wider_than_the_window_and_all_has_a_name(page, width):
    page.resize(width, 900)
    page.wait_for(f"innerWidth === {width} && document.documentElement.scrollWidth <= innerWidth")
    choose(page, "scene", "live")
    page.wait_for("document.documentElement.scrollWidth <= innerWidth")
    roles = {"slider": 9, "combobox": 3, "button": 4, "image": 8}
    nodes = page.call("Accessibility.getFullAXTree")["nodes"]
    for role, count in roles.items():
        named = [node["name"]["value"] for node in nodes if node["role"]["value"] == role]
        assert len(named) == count
        assert all(named)
