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

from granular_fronts.output.files import read_json
from granular_fronts.output.provenance import digest, source_of


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The page, its text, and the datasets that it was made from."""
    page, data = write_page(tmp_path_factory.mktemp("explorer"))
    return page, page.read_text(encoding="utf-8"), data


@pytest.fixture(scope="module")
def content(written):
    """What the page holds, as it unpacks it."""
    [packed] = re.findall(r'id="content">(.*?)</script>', written[1])
    return json.loads(gzip.decompress(b64decode(packed)))


def differences(held, values):
    """Between numbers that are held and some values; missing ones are missing in both."""
    found = np.array(held["rows"], dtype=float) - np.reshape(values, np.shape(held["rows"]))
    np.testing.assert_array_equal(np.isnan(found), np.isnan(np.reshape(values, found.shape)))
    return np.nan_to_num(found)


@pytest.mark.parametrize("size", [1e-8, 0.14, 1.0, 30.0])
def test_rounded_numbers_are_within_the_error_that_they_state(size):
    generator = np.random.default_rng(1)
    values = xr.DataArray(size * generator.uniform(-1, 1, (4, 9)), attrs={"error_estimate": 0.0})
    values[0, :3] = [size, 0.0, np.nan]
    held = script.round_array(values)
    assert 0.5 * held["error"] < np.abs(differences(held, values.values)).max() <= held["error"]
    assert held["error"] < 1e-5 * size
    assert held["rows"][0, 1] == 0.0
    solved = script.round_array(values.assign_attrs(error_estimate=size))
    assert solved["error"] == size + held["error"]


def test_page_holds_the_motion(written, content):
    data, motion = written[2]["flying"], content["motions"]["flying"]
    np.testing.assert_array_equal(motion["times"], data["t_grid"])
    u = data["relative_displacement_grid"].isel(bead=slice(data.attrs["contacts"]))
    velocity = data["velocity_grid"]
    for field, values in {"relative_displacement": u, "velocity": velocity}.items():
        error = motion[field]["error"]
        assert np.abs(differences(motion[field], values.values)).max() <= error < 1e-4
        assert np.abs(differences(motion[field], values.values[::-1])).max() > error
    opened = u.values < 0.0
    assert opened.any()
    assert not (np.array(motion["relative_displacement"]["rows"]) < 0)[~opened].any()
    extremes = u.max(), velocity.min(), velocity.max()
    assert [motion[name] for name in ("largest", "slowest", "fastest")] == [*map(float, extremes)]
    # Extended contacts are open only where no force holds them.
    assert motion["opens"] is True
    assert script.motion_for_page(data.assign_attrs(contacts_open=0))["opens"] is False


def test_page_holds_the_fronts(written, content):
    data, fronts = written[2]["collection"], content["fronts"]
    for name in (*script.PROFILES, *script.MULTIPLIERS):
        assert np.abs(differences(fronts[name], data[name].values)).max() <= fronts[name]["error"]
    for name in {"alpha", "gamma", *script.READINGS} - {"verdict"}:
        held = np.array(fronts[name], dtype=float)
        np.testing.assert_array_equal(held.ravel(), data[name].values.ravel())
    assert fronts["verdict"] == data["verdict"].values.ravel().tolist()
    np.testing.assert_array_equal(
        np.ravel(fronts["window"]), data["xi"].isel(place=[0, -1]).values.ravel()
    )


def test_a_scene_is_titled_with_its_law(written):
    data = written[2]["flying"]
    law = {"elastic": {"kind": "toda", "rate": 2}, "viscous": {"kind": "linear", "gamma": 0.3}}
    scene = json.loads(data.attrs["config"]) | {"law": law}
    titled = script.describe_scene(data.assign_attrs(scene="any_scene", config=json.dumps(scene)))
    words = "any scene, chain of 20 beads, elastic: {kind: toda, rate: 2}, "
    assert titled["title"] == words + "viscous: {kind: linear, gamma: 0.3}"


def test_page_is_one_file_that_says_what_it_was_made_from(written):
    page, html, data = written
    markup = re.sub(r"<script.*?</script>", "", html, flags=re.S)
    assert re.findall(r"<(?:img|iframe|object)\b|@import|url\(", markup) == []
    assert re.findall(r'<link[^>]*href="(?!data:)', markup) == []
    assert re.search(r"<script[^>]*\ssrc=", html) is None
    [kept] = re.findall(r'id="made-from">(.*?)</script>', html)
    assert json.loads(kept) == [source_of(one) for one in data.values()]
    record = read_json(page.with_suffix(".json"))
    assert record["files"] == {page.name: digest(page.read_bytes())}
    assert record["code_version"] in html
    assert "beads is 20 instead of 21" in html
    assert "not one of the paper's" in unescape(html)


def test_what_datasets_say_is_escaped_and_a_page_that_grows_too_large_is_refused(
    tmp_path, monkeypatch
):
    monkeypatch.setattr(script, "code_version", lambda: "<script>run()</script>")
    page = write_page(tmp_path)[0]
    assert "<script>run()" not in page.read_text(encoding="utf-8")
    assert "Code &lt;script&gt;run()" in page.read_text(encoding="utf-8")
    page.unlink()
    monkeypatch.setattr(script, "LARGEST_PAGE", 10_000)
    with pytest.raises(ValueError, match=r"record\.grid\.step of scenes\.chain"):
        write_page(tmp_path)
    assert not page.exists()
