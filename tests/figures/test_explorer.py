"""The page to explore shows what its datasets hold, within the errors that it states."""

import gzip
import json
import re
from base64 import b64decode
from html import unescape

import numpy as np
import pytest
import write_explorer as script
import xarray as xr
from explored import write_page
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from explorer.encoding import decode, encode
from explorer.fronts import MULTIPLIERS, READINGS
from explorer.motions import FIELDS, motion_for_page
from explorer.page import FRONT_ARRAYS, _describe_error, describe_scene
from granular_fronts.output.files import read_json
from granular_fronts.output.provenance import digest, source_of

NUMBERS = st.floats(-1e200, 1e200, allow_subnormal=False) | st.just(np.nan)
ROUNDING = 1.0 + 1e-10
"""Of the products in double precision, beside which the bound of half a step is exact."""


def are_coded(encoded, values):
    """Whether decoded values are within half a step of some values, missing where these are."""
    decoded = decode(encoded)
    np.testing.assert_array_equal(np.isnan(decoded), np.isnan(values))
    differences = np.nan_to_num(np.abs(decoded - values))
    return bool((differences <= 0.5 * ROUNDING * encoded["steps"][..., None]).all())


@given(arrays(float, st.tuples(st.integers(1, 4), st.integers(1, 6)), elements=NUMBERS))
def test_codes_are_within_half_a_step_and_keep_zeros_and_signs(values):
    encoded = encode(values)
    decoded = decode(encoded)
    assert are_coded(encoded, values)
    assert encoded["rounding"] == np.nan_to_num(np.abs(decoded - values)).max()
    assert (np.nan_to_num(decoded * np.sign(values)) >= 0.0).all()
    assert (decoded[values == 0.0] == 0.0).all()


def test_half_a_step_is_reached_and_a_wrong_code_is_outside():
    """The bound is sharp, so that an encoder that cuts off instead of rounding would break it."""
    values = np.array([[32767.0, 0.5 - 1e-9]])
    encoded = encode(values)
    assert encoded["rounding"] == pytest.approx(0.5 * encoded["steps"][0], rel=1e-8)
    assert not are_coded(encoded | {"codes": encoded["codes"] - 1}, values)


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The page, its text, and the datasets that it was made from."""
    page, data = write_page(tmp_path_factory.mktemp("explorer"))
    return page, page.read_text(encoding="utf-8"), data


def test_what_datasets_say_is_escaped(tmp_path, monkeypatch):
    monkeypatch.setattr("explorer.page.code_version", lambda: "<script>run()</script>")
    page = write_page(tmp_path)[0].read_text(encoding="utf-8")
    assert "<script>run()" not in page
    assert "Code &lt;script&gt;run()" in page


def plain(kept):
    """What Bokeh keeps of mappings, lists and arrays; models stay as they are."""
    if isinstance(kept, list):
        return [plain(one) for one in kept]
    if isinstance(kept, dict) and kept.get("type") == "ndarray":
        data = gzip.decompress(b64decode(kept["array"]["data"]))
        return np.frombuffer(data, kept["dtype"]).reshape(kept["shape"])
    if isinstance(kept, dict) and kept.get("type") == "map":
        return {key: plain(value) for key, value in kept["entries"]}
    return kept


@pytest.fixture(scope="module")
def given_to_scripts(written):
    """The arguments of both scripts as they stand in the page."""
    found = {}

    def keep_arguments(part):
        if part.get("name") == "CustomJS":
            found.update(plain(part["attributes"]["args"]))
        return part

    kept = r'<script type="application/json" id="[^"]*">(.*?)</script>'
    for text in re.findall(kept, written[1], re.S):
        json.loads(unescape(text), object_hook=keep_arguments)
    return found


def test_page_holds_the_motion(written, given_to_scripts):
    data, motion = written[2]["flying"], given_to_scripts["motions"]["flying"]
    np.testing.assert_array_equal(motion["times"], data["t_grid"])
    for field in FIELDS:
        expected = data[f"{field}_grid"].values
        assert are_coded(motion[field], expected)
        assert not are_coded(motion[field], expected[::-1])
        assert motion[field]["error"] == data[f"{field}_grid"].attrs["error_estimate"]
    opened = data["relative_displacement_grid"].values < 0.0
    assert opened.any()
    assert not (motion["relative_displacement"]["codes"] < 0)[~opened].any()
    velocity = data["velocity_grid"].values
    extremes = data["relative_displacement_grid"].max(), velocity.min(), velocity.max()
    assert [motion[name] for name in ("largest", "slowest", "fastest")] == [*map(float, extremes)]
    # Extended contacts are open only where no force holds them.
    assert motion["opens"] is True
    assert motion_for_page(data.assign_attrs(contacts_open=0))["opens"] is False


def test_page_holds_the_fronts(written, given_to_scripts):
    data, fronts = written[2]["collection"], given_to_scripts["fronts"]
    continuum = "relative_displacement_heteroclinic"
    for name in ("relative_displacement", continuum, *MULTIPLIERS):
        expected = data[name].values
        assert are_coded(fronts[name], expected.reshape(-1, expected.shape[-1]))
    for name in ("alpha", "gamma", *READINGS):
        np.testing.assert_array_equal(np.ravel(fronts[name]), data[name].values.ravel())
    np.testing.assert_array_equal(fronts["first"], data["xi"][..., 0].values.ravel())
    np.testing.assert_array_equal(fronts["last"], data["xi"][..., -1].values.ravel())


@pytest.mark.parametrize(
    ("law", "words"),
    [
        ({"alpha": 1.5, "beta": 2, "gamma": 0.06}, "α = 1.5, β = 2, γ = 0.06"),
        (
            {"elastic": {"kind": "toda", "rate": 2}, "viscous": {"kind": "linear", "gamma": 0.3}},
            "Toda potential (strength = 1, rate = 2), linear damping (γ = 0.3)",
        ),
    ],
)
def test_a_scene_is_titled_with_its_law(written, law, words):
    data = written[2]["flying"]
    scene = json.loads(data.attrs["config"]) | {"law": law}
    titled = describe_scene(data.assign_attrs(scene="any_scene", config=json.dumps(scene)))
    assert titled == {"name": "any_scene", "title": f"any scene, chain of 20 beads, {words}"}


def test_stated_errors_are_the_largest_rounded_up(written):
    _, html, data = written
    cells = r"<tr><td>([^<]*)</td><td>([^<]*)</td><td class=\"rounding\">([^<]*)</td>"
    stated = {words: tuple(map(float, errors)) for words, *errors in re.findall(cells, html)}
    collection, motion = data["collection"], data["flying"]
    behind = {words: [collection[name] for name in names] for words, names in FRONT_ARRAYS.items()}
    for field in FIELDS:
        behind[f"{field.replace('_', ' ')}, flying"] = [motion[f"{field}_grid"]]
    for words, variables in behind.items():
        solver = max(variable.attrs["error_estimate"] for variable in variables)
        rounding = max(encode(variable)["rounding"] for variable in variables)
        for shown, error in zip(stated[words], (solver, rounding), strict=True):
            # Two digits, the next that is no smaller.
            assert 0.0 <= shown - error < 0.1 * 10.0 ** np.floor(np.log10(error)) * ROUNDING


def test_largest_of_several_errors_is_stated():
    solved = [xr.DataArray(0.0, attrs={"error_estimate": error}) for error in (1e-9, 1.01e-3, 1e-6)]
    stated = _describe_error("any_field", solved, [{"rounding": 1e-9}, {"rounding": 2.01e-5}])
    assert stated == {"array": "any field", "solver": "1.1e-3", "rounding": "2.1e-5"}


def test_page_is_one_file_that_says_what_it_was_made_from(written):
    page, html, data = written
    assert page.stat().st_size <= script.LARGEST_PAGE
    markup = re.sub(r"<script.*?</script>", "", html, flags=re.S)
    assert re.findall(r"<script[^>]*\ssrc=|<(?:img|iframe|object)\b|@import|url\(", markup) == []
    assert re.findall(r'<link[^>]*href="(?!data:)', markup) == []
    assert re.search(r"<script[^>]*\ssrc=", html) is None
    sources = [source_of(one) for one in data.values()]
    [kept] = re.findall(r'id="made-from">(.*?)</script>', html)
    assert json.loads(kept) == sources
    record = read_json(page.with_suffix(".json"))
    assert record["files"] == {page.name: digest(page.read_bytes())}
    assert record["made_from"] == sorted(sources, key=lambda made_from: made_from["scene"])
    assert record["code_version"] in html
    assert "beads is 20 instead of 21" in html
    assert "not one of the paper's" in unescape(html)


def test_page_that_grows_too_large_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(script, "LARGEST_PAGE", 1_000_000)
    with pytest.raises(ValueError, match=r"record\.grid\.step of scenes\.chain"):
        write_page(tmp_path)
    assert not (tmp_path / "explore.html").exists()
