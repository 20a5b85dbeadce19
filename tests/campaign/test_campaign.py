"""The grid of a campaign file, and how it is cut into chunks; `test_refusals` has what is wrong."""

import json

import numpy as np
import pytest

from campaigns import (
    CHAINS,
    CHAINS_OF_A_LAW,
    FRONTS,
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
    tenths = [round(0.1 * n, 1) for n in range(1, 11)]
    assert Spacing(linspace=(0.1, 1.0, 10)).values() == tenths, "as they are written in a list"


def test_values_of_a_grid_are_kept_to_the_last_digit_whole_ones_whole_and_beta_is_alpha():
    axes = {"alpha": [1.2, 1.5], "gamma": [0.1234567890123456]}
    beads = {"linspace": [20, 60, 5]}
    asked = campaign(axes={"beads": beads} | axes, fixed={"delta": 1})
    assert asked.grid["gamma"] == (0.1234567890123456,)
    assert asked.grid["beads"] == (20, 30, 40, 50, 60)
    assert campaign(tolerance=...).settings["tolerance"] == 1e-9
    [chunk] = all_chunks(asked, 10)
    np.testing.assert_array_equal(chunk.points()["beta"], chunk.points()["alpha"])


def test_a_large_campaign_is_accepted_on_purpose_and_its_jobs_take_the_time_asked_for():
    axes = {"delta": {"linspace": [0.1, 1, 1001]}, "gamma": {"linspace": [0.1, 1, 1000]}}
    assert campaign(axes=axes, allow_large=True).size == 1_001_000
    assert campaign().points_per_chunk(30.0) == 600
    assert campaign().points_per_chunk(1e-9) == 1
    assert campaign(chunk_points=7).points_per_chunk(30.0) == 7


def test_campaign_is_found_by_its_name(tmp_path):
    """No campaign takes the name of another one's summary."""
    for name in ("smok", "Smoke", "../default", 5):
        with pytest.raises(InputError, match=rf"no campaign {name} .*one of .*smoke"):
            definition.load_campaign(ROOT / "config/campaigns", name)
    for name in ("Mine", "smoke_summary"):
        (tmp_path / f"{name}.yaml").write_text("kind: chain\n", encoding="utf-8")
        with pytest.raises(InputError, match=f"Campaign {name}: a name"):
            definition.load_campaign(tmp_path, name)


def test_shipped_campaigns_are_accepted():
    for file in (ROOT / "config/campaigns").glob("*.yaml"):
        assert definition.load_campaign(file.parent, file.stem).size > 1


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


def test_name_of_a_chunk_is_its_content():
    laws = [TODA | {"viscous": {"kind": "linear", "gamma": 0.3}}, TODA | {"viscous": None}]
    asked = [campaign(**change) for change in ({}, {"chunk_points": 10}, {"tolerance": 1e-6})]
    asked += [campaign(CHAINS_OF_A_LAW, law=law) for law in laws]
    made = [all_chunks(each, 10)[0] for each in asked]
    assert made[0].name == made[1].name
    assert len({chunk.name for chunk in made}) == 4
    assert chunks.Chunk(**json.loads(made[0].as_json())).name == made[0].name


def grown(**axes):
    return campaign(axes={**CHAINS["axes"], **axes})


def test_changed_axis_leaves_only_its_new_points(tmp_path):
    pretend_solved(campaign(), tmp_path, 2)
    for changed, new_points in (
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


def test_chunks_may_overlap_and_those_with_other_numbers_of_a_law_are_not_taken(tmp_path):
    for gammas in ([0.1, 0.3], [0.3, 0.8]):
        [chunk] = all_chunks(grown(gamma=gammas), 10)
        chunks.write_request(chunk, tmp_path)
        (tmp_path / f"{chunk.name}.nc").touch()
    assert not chunks.find_missing(campaign(), tmp_path)[1].any()
    pretend_solved(campaign(CHAINS_OF_A_LAW), tmp_path, 10)
    one_law = campaign(CHAINS_OF_A_LAW, axes={"delta": [0.1, 0.5]})
    assert chunks.find_missing(one_law, tmp_path)[1].all()


def test_points_beside_the_grid_are_nowhere_in_it():
    axes, fixed = {"beads": [30, 40], "delta": [0.1, 0.2], "gamma": [0.3]}, {"alpha": 1.5}
    [chunk] = all_chunks(campaign(axes=axes, fixed=fixed), 10)
    part = campaign(axes=axes | {"delta": [0.2]}, fixed=fixed)
    np.testing.assert_array_equal(chunks.locate(chunk, part), [[-1], [0], [-1], [1]])


@pytest.mark.parametrize("chunk_points", [2, 30])
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


def test_request_is_read_from_the_data_of_a_chunk_where_it_is_damaged_or_lost(tmp_path):
    asked = campaign(FRONTS, axes={"alpha": [1.5], "gamma": [0.3]})
    [chunk] = all_chunks(asked, 1)
    file = solve(chunk, tmp_path)
    request = file.with_suffix(".json")
    for spoil in (lambda: request.write_text('{"kind": "front", "sett'), request.unlink):
        spoil()
        known, missing = chunks.find_missing(asked, tmp_path)
        assert (known, missing.any()) == ([chunk], False)
    file.write_text("cut")
    assert chunks.find_missing(asked, tmp_path)[1].all(), "without either it is cut anew"
