"""What a campaign file may ask for, and how it is cut into chunks."""

import json

import numpy as np
import pytest

from campaigns import (
    CHAINS,
    CHAINS_OF_A_LAW,
    ROOT,
    TODA,
    all_chunks,
    campaign,
    pretend_solved,
    solve,
)
from granular_fronts.campaign import chunks, definition
from granular_fronts.campaign.file import Spacing
from granular_fronts.errors import InputError


@pytest.mark.parametrize(
    ("spacing", "expected"), [("linspace", np.linspace), ("logspace", np.geomspace)]
)
def test_spacings_are_those_of_numpy_and_meet_refined_ones_to_the_last_bit(spacing, expected):
    coarse, fine = (Spacing(**{spacing: (0.013, 1.7, count)}).values() for count in (11, 21))
    assert fine[::2] == coarse
    np.testing.assert_allclose(fine, expected(0.013, 1.7, 21), rtol=1e-11)
    assert Spacing(**{spacing: (0.5, 1.7, 1)}).values() == [0.5]
    listed = campaign(axes={"gamma": [0.1234567890123456], "delta": [1]})
    assert listed.grid["gamma"] == (0.1234567890123456,)


def test_campaign_that_is_large_on_purpose_is_accepted():
    axes = {"delta": {"linspace": [0.1, 1, 1001]}, "gamma": {"linspace": [0.1, 1, 1000]}}
    assert campaign(axes=axes, allow_large=True).size == 1_001_000


def test_whole_numbers_may_be_spaced():
    asked = campaign(
        axes={"beads": {"linspace": [20, 60, 5]}}, fixed={"alpha": 1.5, "gamma": 0, "delta": 1}
    )
    assert asked.grid["beads"] == (20, 30, 40, 50, 60)


def test_campaign_is_found_by_its_name(tmp_path):
    """No campaign takes the name of another one's summary."""
    for name in ("smok", "Smoke", "", "../default", 5):
        with pytest.raises(InputError, match=rf"no campaign {name} .*one of .*smoke"):
            definition.load_campaign(ROOT / "config/campaigns", name)
    for name, text, words in (
        ("mine", "kind: chain\nkind: front", "mine.yaml, line 2, column 1"),
        ("mine", "", "Campaign mine is null"),
        ("Mine", "kind: chain", "Campaign Mine: a name"),
        ("smoke_summary", "kind: chain", "Campaign smoke_summary: a name"),
    ):
        (tmp_path / f"{name}.yaml").write_text(f"{text}\n", encoding="utf-8")
        with pytest.raises(InputError, match=words):
            definition.load_campaign(tmp_path, name)


def test_shipped_campaigns_are_accepted():
    for file in (ROOT / "config/campaigns").glob("*.yaml"):
        asked = definition.load_campaign(file.parent, file.stem)
        assert asked.file.kind != "motion" or asked.size * asked.kind.seconds_per_point < 60.0


def test_a_job_takes_the_points_that_its_kind_solves_in_the_time_asked_for():
    assert campaign().points_per_chunk(30.0) == 600
    assert campaign().points_per_chunk(1e-9) == 1
    assert campaign(chunk_points=7).points_per_chunk(30.0) == 7


# Chunks.


@pytest.mark.parametrize("chunk_points", [1, 2, 4, 100])
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


def test_name_of_a_chunk_is_its_content():
    changes = ({}, {"chunk_points": 10}, {"tolerance": 1e-6})
    [chunk], [same], [other] = (all_chunks(campaign(**change), 10) for change in changes)
    assert chunk.name == same.name != other.name
    assert chunks.Chunk(**json.loads(chunk.as_json())).name == chunk.name
    [one], [another] = (
        all_chunks(campaign(CHAINS_OF_A_LAW, law=TODA | {"viscous": viscous}), 10)
        for viscous in ({"kind": "linear", "gamma": 0.3}, {"kind": "none"})
    )
    assert one.name != another.name


def grown(**axes):
    return campaign(axes={**CHAINS["axes"], **axes})


def test_changed_axis_leaves_only_its_new_points(tmp_path):
    pretend_solved(campaign(), tmp_path, 2)
    for changed, new_points in (
        (grown(), 0),
        (grown(delta=[0.05, 0.1, 1.0]), 3),
        (grown(gamma=[0.1, 0.2, 0.3, 0.8]), 2),
        (grown(delta=[0.1, 0.5, 1.0], gamma=[0.1, 0.3, 0.8, 0.9]), 6),
        (grown(delta=[1.0], gamma=[0.3, 0.8]), 0),
        (campaign(axes={"beads": [30, 40], **CHAINS["axes"]}, fixed={"alpha": 1.5}), 6),
        (campaign(axes=dict(reversed(CHAINS["axes"].items()))), 0),
        (campaign(tolerance=1e-6), 6),
        (campaign(record={"scalars": ["overshoot"]}), 6),
    ):
        assert chunks.find_missing(changed, tmp_path)[1].sum() == new_points


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
