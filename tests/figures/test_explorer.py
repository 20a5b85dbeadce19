"""The page to explore shows what its datasets hold, within the errors that it states."""

import gzip
import json
import re
from base64 import b64decode

import numpy as np
import pytest
import write_explorer as script
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


def expect_values(held, values):
    """What is held are some values with four significant digits, null where these are missing."""
    held = np.array(held, dtype=values.dtype)
    if values.dtype.kind == "U":
        assert (held == values).all()
    else:
        # A number whose first digit is 1 is rounded most.
        np.testing.assert_allclose(held, values, rtol=ROUNDING, atol=0)
        assert (np.sign(np.nan_to_num(held)) == np.sign(np.nan_to_num(values))).all()


ROUNDING = 0.5e-3 * (1 + 1e-9)


def test_page_holds_the_motion(written, content):
    data, motion = written[2]["flying"], content["motions"]["flying"]
    expect_values(motion["times"], data["t_grid"].values)
    contacts = slice(data.attrs["contacts"])
    for field, beads in {"relative_displacement": contacts, "velocity": slice(None)}.items():
        values = data[f"{field}_grid"].isel(bead=beads)
        expect_values(motion[field]["rows"], values.values)
        with pytest.raises(AssertionError):
            expect_values(motion[field]["rows"], values.values[::-1])
        assert motion[field]["error"] == pytest.approx(values.attrs["error_estimate"], 1e-3)
    # Extended contacts are open only where no force holds them.
    assert motion["opens"] is True
    assert script.motion_for_page(data.assign_attrs(contacts_open=0))["opens"] is False


def test_page_holds_the_fronts(written, content):
    for part, name in {"fronts": "collection", "plane": "critical_damping"}.items():
        for variable, values in written[2][name].variables.items():
            expect_values(content[part][variable], values.values)


def test_a_scene_is_titled_with_its_law(written):
    data = written[2]["flying"]
    law = {"elastic": {"kind": "toda", "rate": 2}, "viscous": {"kind": "linear", "gamma": 0.3}}
    scene = json.loads(data.attrs["config"]) | {"law": law}
    titled = script.title_of(data.assign_attrs(scene="any_scene", config=json.dumps(scene)))
    words = "any scene, chain of 20 beads, elastic: {kind: toda, rate: 2}, "
    assert titled == words + "viscous: {kind: linear, gamma: 0.3}"


def test_page_is_one_file_with_a_record_of_what_it_was_made_from(written):
    page, html, data = written
    markup = re.sub(r"<script.*?</script>", "", html, flags=re.S)
    assert re.findall(r"<(?:img|iframe|object)\b|@import|url\(", markup) == []
    assert re.findall(r'<link[^>]*href="(?!data:)', markup) == []
    assert re.search(r"<script[^>]*\ssrc=", html) is None
    record = read_json(page.with_suffix(".json"))
    sources = [source_of(one) for one in data.values()]
    assert sorted(record["made_from"], key=str) == sorted(sources, key=str)
    assert record["files"] == {page.name: digest(page.read_bytes())}
    assert record["code_version"] in html


def test_what_datasets_say_is_escaped(tmp_path, monkeypatch):
    monkeypatch.setattr(script, "code_version", lambda: "<script>run()</script>")
    html = write_page(tmp_path)[0].read_text(encoding="utf-8")
    assert "<script>run()" not in html
    assert "Code &lt;script&gt;run()" in html
