"""What a campaign file may ask for, and how it is cut into chunks."""

import json
import math

import numpy as np
import pytest
from campaigns import CHAINS, ROOT, all_chunks, campaign, pretend_solved, refusal, solve
from configurations import assert_refused

from granular_fronts.campaign import chunks, definition
from granular_fronts.campaign.definition import expand_axis
from granular_fronts.errors import InputError

# Axes.


@pytest.mark.parametrize(
    ("spacing", "start", "stop", "expected"),
    [("linspace", 0.0, 1.0, np.linspace), ("logspace", 0.013, 1.7, np.geomspace)],
)
def test_spacings_are_those_of_numpy_and_meet_refined_ones_to_the_last_bit(
    spacing, start, stop, expected
):
    coarse, fine = (expand_axis({spacing: [start, stop, count]}) for count in (11, 21))
    assert fine[::2] == coarse
    np.testing.assert_allclose(fine, expected(start, stop, 21), rtol=1e-11)
    assert expand_axis({spacing: [0.5, stop, 1]}) == [0.5]
    assert expand_axis([0.1234567890123456]) == [0.1234567890123456]


def gammas(values, **axes):
    return {"axes": {"delta": [1.0], "gamma": values, **axes}}


def fixed(**values):
    return {"fixed": {"alpha": 1.5, "beads": 30, **values}}


def profile(start, stop, count):
    return {"record": {"profile": {"start": start, "stop": stop, "count": count}}}


REFUSED = [
    (gammas([]), "axes.gamma is empty"),
    (gammas(0.5), "axes.gamma is 0.5"),
    (gammas([0.1, 0.3, 0.2]), "axes.gamma has 0.2 after 0.3"),
    (gammas([0.3, 0.3]), "axes.gamma has 0.3 after 0.3"),
    (gammas({"linspace": [1.0, 0.1, 5]}), "axes.gamma has"),
    (gammas({"linspace": [0.1, 1.0, 2.5]}), "axes.gamma.linspace asks for 2.5 values"),
    (gammas({"linspace": [0.1, 1.0]}), "linspace has 2 entries: list 3 (start, stop, count)"),
    (gammas({"logspace": [0.0, 1.0, 5]}), "axes.gamma.logspace runs from 0.0 to 1.0"),
    (gammas([0.1, math.inf]), "axes.gamma (entry 2) is inf"),
    (gammas([1.0], mu=[1.0]), "axes.mu is given"),
    (gammas([1.0], gama=[1.0]), "did you mean gamma"),
    (gammas([-0.1, 1.0]), "axes.gamma reaches down to -0.1 | must be 0 or more"),
    (gammas([1.0], alpha=[1.0, 1.5]), "alpha is given under axes and under fixed"),
    (gammas({"linspace": [0.1, 1.0, 10**10]}), "axes.gamma is {'linspace' | 894 GiB"),
    (fixed(alpha=1.0), "fixed.alpha reaches down to 1 | above 1"),
    (fixed(beads=30.5), "fixed.beads holds 30.5"),
    (fixed(beads=10**9), "fixed.beads is 1000000000 | 477 GiB"),
    ({"fixed": {"alpha": 1.5}}, "beads is missing | number of beads N"),
    ({"record": {"scalars": ["speed"]}}, "record.scalars names speed | front_speed"),
    (profile(3, 1, 2), "record.profile.start is 3"),
    (profile(1, 1e9, 10**9), "record.profile.count is 1000000000 | 100000 or less"),
    ({"kind": "frnt"}, 'kind is "frnt" | chain or front or motion or ring'),
    ({"colour": 1}, "colour is no key"),
]


@pytest.mark.parametrize(("changes", "words"), REFUSED, ids=[words for _, words in REFUSED])
def test_impossible_campaign_is_refused(changes, words):
    assert_refused(refusal(**changes), words)


@pytest.mark.parametrize("start", [1, 1.5, 2.25])
@pytest.mark.parametrize("stop", [7, 7.5, 9.75])
def test_profile_of_a_chain_keeps_no_bead_twice(start, stop):
    most = math.floor(stop) - math.ceil(start) + 1
    asked = campaign(**profile(start, stop, most))
    assert np.all(np.diff(asked.kind.profile_points(asked.settings["profile"])) >= 1)
    assert f"there are {most} beads" in refusal(**profile(start, stop, most + 1))


def test_large_campaign_says_how_large_it_is():
    axes = {"delta": {"linspace": [0.1, 1, 1001]}, "gamma": {"linspace": [0.1, 1, 1000]}}
    assert_refused(refusal(axes=axes), "1,001,000 points | 1,000,000 | allow_large")
    assert campaign(axes=axes, allow_large=True).size == 1_001_000


@pytest.mark.parametrize("name", ["smok", "Smoke", "", "../default", 5])
def test_unknown_campaign_names_those_there_are(name):
    with pytest.raises(InputError, match=rf"There is no campaign {name} .*one of .*smoke"):
        definition.load_campaign(ROOT / "config/campaigns", name)


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("mine", "kind: chain\nkind: front", "mine.yaml, line 2, column 1"),
        ("mine", "", "Campaign mine: the file is null"),
        ("Mine", "kind: chain", "Campaign Mine: a name"),
    ],
)
def test_unreadable_campaign_file_is_refused(tmp_path, name, text, words):
    (tmp_path / f"{name}.yaml").write_text(f"{text}\n", encoding="utf-8")
    with pytest.raises(InputError) as caught:
        definition.load_campaign(tmp_path, name)
    assert words in str(caught.value)


@pytest.mark.parametrize("file", sorted((ROOT / "config/campaigns").glob("*.yaml")), ids=str)
def test_shipped_campaigns_are_accepted(file):
    definition.load_campaign(file.parent, file.stem)


def test_a_job_takes_the_points_that_its_kind_solves_in_the_time_asked_for():
    assert campaign(CHAINS).points_per_chunk(30.0) == 600
    assert campaign(CHAINS).points_per_chunk(1e-9) == 1
    assert campaign(CHAINS, chunk_points=7).points_per_chunk(30.0) == 7


# Chunks.


@pytest.mark.parametrize("chunk_points", [1, 2, 3, 4, 6, 100])
def test_chunks_hold_every_point_of_the_grid_once_and_none_is_too_large(chunk_points):
    asked = campaign()
    grid = dict(zip(asked.grid, np.meshgrid(*asked.grid.values(), indexing="ij"), strict=True))
    parts, found = all_chunks(asked, chunk_points), []
    assert max(chunk.size for chunk in parts) <= chunk_points
    for chunk in parts:
        where = chunks.locate(chunk, asked)
        found.extend(where.ravel())
        for name in ("delta", "gamma", "alpha", "beads"):
            np.testing.assert_array_equal(chunk.points()[name], grid[name].ravel()[where])
    assert sorted(found) == list(range(asked.size))


def test_beta_is_alpha_unless_given():
    axes, others = {"alpha": [1.2, 1.5], "gamma": [0.1, 0.2]}, {"delta": 1.0, "beads": 30}
    [chunk] = all_chunks(campaign(axes=axes, fixed=others), 10)
    np.testing.assert_array_equal(chunk.points()["beta"], [[1.2, 1.2], [1.5, 1.5]])


def test_no_campaign_takes_the_files_of_another_ones_summary(tmp_path):
    file = tmp_path / "smoke_summary.yaml"
    file.write_bytes((ROOT / "config/campaigns/smoke.yaml").read_bytes())
    with pytest.raises(InputError, match="smoke_summary"):
        definition.load_campaign(tmp_path, file.stem)


def test_name_of_a_chunk_is_its_content():
    [chunk], [same], [other] = (
        all_chunks(campaign(**changes), 10)
        for changes in ({}, {"chunk_points": 10}, {"tolerance": 1e-6})
    )
    assert chunk.name == same.name != other.name
    assert chunks.Chunk(**json.loads(chunk.as_json())).name == chunk.name


def grown(**axes):
    return campaign(axes={**CHAINS["axes"], **axes})


@pytest.mark.parametrize(
    ("changed", "new_points"),
    [
        (grown(), 0),
        (grown(delta=[0.05, 0.1, 1.0]), 3),
        (grown(gamma=[0.1, 0.2, 0.3, 0.8]), 2),
        (grown(delta=[0.1, 0.5, 1.0], gamma=[0.1, 0.3, 0.8, 0.9]), 6),
        (grown(delta=[1.0], gamma=[0.3, 0.8]), 0),
        (campaign(axes={"beads": [30, 40], **CHAINS["axes"]}, fixed={"alpha": 1.5}), 6),
        (campaign(axes=dict(reversed(CHAINS["axes"].items()))), 0),
        (campaign(tolerance=1e-6), 6),
        (campaign(record={"scalars": ["overshoot"]}), 6),
    ],
    ids=["same", "slow", "fast", "both", "fewer", "fixed", "turned", "tolerance", "record"],
)
@pytest.mark.parametrize("chunk_points", [1, 2, 100])
def test_changed_axis_leaves_only_its_new_points(tmp_path, changed, new_points, chunk_points):
    pretend_solved(campaign(), tmp_path, chunk_points)
    _, missing = chunks.find_missing(changed, tmp_path)
    assert missing.sum() == new_points


@pytest.mark.parametrize("chunk_points", [2, 7, 30])
def test_chunks_stay_the_same_while_some_are_solved_and_others_again(tmp_path, chunk_points):
    """A job on a cluster cuts a campaign anew, whatever others have done, and finds its own."""
    values = [round(0.1 * n, 1) for n in range(1, 16)]
    pretend_solved(grown(delta=values[::2], gamma=[0.1, 0.3]), tmp_path, chunk_points)
    asked = grown(delta=values)
    every = chunks.chunks_of(asked, tmp_path, chunk_points)
    for file in tmp_path.glob("*.nc"):
        file.unlink()
        assert chunks.chunks_of(asked, tmp_path, chunk_points) == every
    _, missing = chunks.find_missing(asked, tmp_path)
    for chunk in chunks.cut(asked, missing, chunk_points):
        chunks.write_request(chunk, tmp_path)
        assert chunks.chunks_of(asked, tmp_path, chunk_points) == every
    assert not chunks.find_missing(asked, tmp_path)[1].any()


def test_few_new_values_are_gathered_in_few_chunks(tmp_path):
    """Every second line is missing: the gaps do not make a chunk each."""
    values = [round(0.1 * n, 1) for n in range(1, 41)]
    pretend_solved(grown(delta=values[::2]), tmp_path, 30)
    asked = grown(delta=values)
    _, missing = chunks.find_missing(asked, tmp_path)
    assert [chunk.size for chunk in chunks.cut(asked, missing, 30)] == [15, 15, 15, 15]


@pytest.mark.parametrize("content", [None, '{"kind": "chain", "sett'])
def test_request_is_read_from_the_data_of_a_chunk_where_it_is_lost(tmp_path, content):
    asked = campaign(axes={"delta": [1.0], "gamma": [0.3]})
    [chunk] = all_chunks(asked, 1)
    file = solve(chunk, tmp_path)
    request = file.with_suffix(".json")
    request.unlink() if content is None else request.write_text(content)
    known, missing = chunks.find_missing(asked, tmp_path)
    assert (known, missing.any()) == ([chunk], False)
    file.write_text("cut")
    assert chunks.find_missing(asked, tmp_path)[1].all(), "without either it is cut anew"
    assert list(chunks.chunks_of(asked, tmp_path, 1)) == [chunk.name]
