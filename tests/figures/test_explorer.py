"""The page to explore shows what its datasets hold, within the errors that it states."""

import gzip
import json
import re
from base64 import b64decode
from html import unescape

import numpy as np
import pytest
import write_explorer as script
from explored import write_page
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from explorer.encoding import MISSING, decode, encode
from explorer.motions import FIELDS, encode_motion, motion_for_page
from explorer.page import describe_scene
from granular_fronts.output.files import read_json
from granular_fronts.output.provenance import digest, source_of

NUMBERS = st.floats(-1e200, 1e200, allow_subnormal=False) | st.just(np.nan)
ROUNDING = 1.0 + 1e-10
"""Of the products in double precision, beside which the bound of half a step is exact."""


@given(arrays(float, st.tuples(st.integers(1, 4), st.integers(1, 6)), elements=NUMBERS))
def test_codes_are_within_half_a_step_and_keep_zeros_and_signs(values):
    encoded = encode(values)
    decoded = decode(encoded)
    differences = np.abs(decoded - values)
    np.testing.assert_array_equal(np.isnan(decoded), np.isnan(values))
    assert (np.nan_to_num(differences) <= 0.5 * ROUNDING * encoded.steps[:, None]).all()
    assert encoded.error == np.nan_to_num(differences).max()
    assert (np.nan_to_num(decoded * np.sign(values)) >= 0.0).all()
    assert (decoded[values == 0.0] == 0.0).all()


def test_half_a_step_is_reached_and_a_wrong_code_is_outside():
    """The bound is sharp, so that an encoder that cuts off instead of rounding would break it."""
    values = np.array([[32767.0, 0.5 - 1e-9]])
    encoded = encode(values)
    assert encoded.error == pytest.approx(0.5 * encoded.steps[0], rel=1e-8)
    cut = encoded._replace(codes=encoded.codes - 1)
    assert np.abs(decode(cut) - values).max() > 0.5 * ROUNDING * encoded.steps[0]


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The file of the page and the datasets that it was made from."""
    return write_page(tmp_path_factory.mktemp("explorer"))


@pytest.fixture(scope="module")
def html(written):
    return written[0].read_text(encoding="utf-8")


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
def given_to_scripts(html):
    """The arguments of both scripts as they stand in the page."""
    kept = re.findall(r'<script type="application/json" id="[^"]*">(.*?)</script>', html, re.S)
    found = {}

    def keep_arguments(part):
        if part.get("name") == "CustomJS":
            found.update(plain(part["attributes"]["args"]))
        return part

    for text in kept:
        json.loads(unescape(text), object_hook=keep_arguments)
    return found


def agree(coded, expected):
    """Whether the page computes some values, up to half a step."""
    steps = coded["steps"][:, None]
    values = np.where(coded["codes"] == MISSING, np.nan, coded["codes"] * steps)
    np.testing.assert_array_equal(np.isnan(values), np.isnan(expected))
    return bool((np.nan_to_num(np.abs(values - expected)) <= 0.5 * ROUNDING * steps).all())


def test_page_holds_the_motion(written, given_to_scripts):
    data, motion = written[1]["flying"], given_to_scripts["motions"]["flying"]
    np.testing.assert_array_equal(motion["times"], data["t_grid"])
    for field in FIELDS:
        expected = data[f"{field}_grid"].values
        assert agree(motion[field], expected)
        assert not agree(motion[field], expected[::-1])
        assert motion[field]["error"] == data[f"{field}_grid"].attrs["error_estimate"]
    opened = data["relative_displacement_grid"].values < 0.0
    assert opened.any()
    assert not (motion["relative_displacement"]["codes"] < 0)[~opened].any()


def test_extended_contacts_are_open_only_where_no_force_holds_them(written, given_to_scripts):
    data = written[1]["flying"]
    assert given_to_scripts["motions"]["flying"]["opens"] is True
    held = data.assign_attrs(contacts_open=0)
    assert motion_for_page(held, encode_motion(held))["opens"] is False


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
    data = written[1]["flying"]
    scene = json.loads(data.attrs["config"]) | {"law": law}
    titled = describe_scene(data.assign_attrs(scene="any_scene", config=json.dumps(scene)))
    assert titled == {"name": "any_scene", "title": f"any scene, chain of 20 beads, {words}"}


def test_page_holds_the_fronts(written, given_to_scripts):
    data, fronts = written[1]["collection"], given_to_scripts["fronts"]
    for name in ("relative_displacement", "relative_displacement_heteroclinic", "multiplier_real"):
        expected = data[name].values
        assert agree(fronts[name], expected.reshape(-1, expected.shape[-1]))
    np.testing.assert_array_equal(fronts["alpha"], data["alpha"])
    np.testing.assert_array_equal(fronts["overshoot"], data["overshoot"].values.ravel())
    np.testing.assert_array_equal(
        fronts["tail_root_real"], data["tail_root_real"].values.reshape(-1, data.sizes["root"])
    )


def test_stated_errors_are_those_of_the_encoder(written, html):
    data = written[1]
    stated = dict(
        zip(
            re.findall(r"<tr><td>([^<]*)</td><td>[^<]*</td><td class", html),
            re.findall(r'<td class="rounding">([^<]*)</td>', html),
            strict=True,
        )
    )
    for field in FIELDS:
        rounding = encode(data["flying"][f"{field}_grid"]).error
        assert is_rounded_up(stated[f"{field.replace('_', ' ')}, flying"], rounding)
    collection = data["collection"]
    parts = [encode(collection[f"multiplier_{part}"]).error for part in ("real", "imaginary")]
    assert is_rounded_up(stated["multipliers"], max(parts))


def is_rounded_up(shown, error):
    """Whether an error of two digits is the next that is no smaller than it."""
    return 0.0 <= float(shown) - error < 0.1 * 10.0 ** np.floor(np.log10(error)) * ROUNDING


def test_page_is_one_file_of_moderate_size(written, html):
    assert written[0].stat().st_size <= script.LARGEST_PAGE
    markup = re.sub(r"<script.*?</script>", "", html, flags=re.S)
    assert re.findall(r"<script[^>]*\ssrc=|<(?:img|iframe|object)\b|@import|url\(", markup) == []
    assert re.findall(r'<link[^>]*href="(?!data:)', markup) == []
    assert re.search(r"<script[^>]*\ssrc=", html) is None


def test_page_says_what_it_was_made_from(written, html):
    page, data = written
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
    with pytest.raises(ValueError, match=r"The page has .* MB, more than 1: record fewer times"):
        write_page(tmp_path)
    assert not (tmp_path / "explore.html").exists()
