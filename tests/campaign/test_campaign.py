"""What a campaign file may ask for, and how it is cut into chunks."""

import json

import numpy as np
import pytest
from configurations import assert_refused

from campaigns import (
    CHAINS,
    CHAINS_OF_A_LAW,
    PULSE,
    RATIOS,
    RINGS,
    ROOT,
    SCENE,
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


def gammas(values, **axes):
    return {"axes": {"delta": [1.0], "gamma": values, **axes}}


def fixed(given=CHAINS, **changes):
    return {"fixed": {**given["fixed"], "delta": 1.0, **changes}}


def profile(start, stop, count):
    return {"record": {"profile": {"start": start, "stop": stop, "count": count}}}


def listed(*force):
    bare = {"damping": 0.5, "half_length": 8.1}
    return {"start": {"profile": "given", "rescaled_force": [*force]}, "fixed": bare}


BARE = {"elastic": {"kind": "toda"}, "viscous": None}


def rates(*values, **axes):
    return {"axes": {"law.elastic.rate": [*values], "delta": [1.0], **axes}}


def sensors(value):
    record = {"snapshots": [], "sensors": value}
    return {"scene": SCENE | {"record": record}}


REFUSED = {
    "chain": (
        CHAINS,
        [
            (gammas([]), "axes.gamma is empty"),
            (gammas(0.5), "axes.gamma is 0.5 | a list"),
            (gammas([0.1, 0.3, 0.2]), "gamma has 0.2 after 0.3 | must increase"),
            (gammas([0.3, 0.3]), "gamma has 0.3 after 0.3"),
            (gammas({"linspace": [1.0, 0.1, 5]}), "gamma has 0.775 after 1"),
            (
                gammas({"linspace": [0.1, 1.0, 2.5]}),
                "axes.gamma.linspace (entry 3) is 2.5 | a whole number",
            ),
            (gammas({"linspace": [0.1, 1.0]}), "has 2 entries: list 3 (start, stop, count)"),
            (gammas({"logspace": [0.0, 1, 5]}), "axes.gamma.logspace (entry 1) is 0.0 | above 0"),
            (gammas({}), "axes.gamma has no spacing | linspace or logspace"),
            (gammas([0.1, float("inf")]), "axes.gamma (entry 2) is inf"),
            (gammas([1.0], gama=[1.0]), "gama is no key | did you mean gamma"),
            (gammas([-0.2, -0.1, 1.0]), "gamma (entry 1) is -0.2 | give 0 or more"),
            (gammas([1.0], alpha=[1.0, 1.5]), "alpha is given under axes and under fixed"),
            (gammas({"linspace": [0, 1, 10**10]}), "10,000,000,000 points\n10000000000 | GiB"),
            (gammas({"linspace": [0, 1, 10**6 + 1]}), "1,000,001 points | 1,000,000 | allow_large"),
            (fixed(alpha=1.0) | gammas([1.0]), "delta is given under axes and under fixed"),
            ({"fixed": {"alpha": 1.0, "beads": 30}}, "alpha is 1.0, but must be above 1"),
            ({"fixed": {"alpha": 1.5, "beads": 30.5}}, "beads is 30.5 | a whole number"),
            ({"fixed": {"alpha": 1.5, "beads": 10**9}}, "beads is 1000000000 | 477 GiB"),
            ({"fixed": {"alpha": 1.5}}, "beads is missing | number of beads N"),
            ({"axes": {"beads": {"linspace": [20, 41, 3]}}}, "beads is given under axes and"),
            ({"record": {"scalars": ["speed"]}}, "(entry 1) is 'speed' | front_speed"),
            (profile(3, 1, 2), "record.profile.start is 3 | stop 1"),
            (profile(1, 7.5, 8), "there are 7 beads"),
            (profile(1, 1e9, 10**9), "record.profile.count is 1000000000 | 100000 or less"),
            ({"kind": "frnt"}, 'kind is "frnt" | chain or front or motion or ring'),
            ({"colour": 1}, "colour is no key"),
            ({"start": {"profile": "pulse"}}, "start is given, but kind chain has none"),
            (rates(1.0, gamma=[1.0]), "law.elastic.rate is no key"),
        ],
    ),
    "law": (
        CHAINS_OF_A_LAW,
        [
            ({"law": {"elastic": {"kind": "tode"}}}, "'tode' is no kind of elastic potential"),
            ({"law": {"viscous": {"kind": "none"}}}, "law.elastic is missing"),
            ({"law": TODA | {"elastic": {"kind": "toda", "rate": "2"}}}, "law.elastic.rate is"),
            (rates(-1.0, 1.0), "rate is -1.0 | above 0"),
            (rates(1.0, **{"law.elastic.rat": [1.0]}), "'rat' is no parameter of toda"),
            (rates(1.0, alpha=[1.5]), "alpha is no key"),
            (
                rates(1.0, **{"law.viscous.gamma": [1]}) | {"law": BARE},
                "law.viscous.kind is missing",
            ),
        ],
    ),
    "ring": (
        RINGS,
        [
            (fixed(RINGS, mu=2), "damping and mu: keep one"),
            ({"fixed": PULSE}, "exactly one of gamma | have none"),
            (fixed(RINGS, half_beads=80), "half_beads and half_length: keep one"),
            ({"axes": {"alpha": [1e6], "slow_time": [1]}}, "alpha (entry 1) is | 10 or less"),
            (fixed(RINGS, half_width=1e-6), "half_width is 1e-06 | 0.01 or more"),
            ({"start": {"profile": "given"}}, "start has profile given, but rescaled_force"),
            ({"start": ...}, "start is missing, but kind ring needs one"),
            (listed(1, 1, 2, 1, 3), "start.rescaled_force begins with 1 and ends with 3"),
            (listed(0, 0, 0, 0, 0), "start.rescaled_force has one value"),
            (listed(1, 2, 3, 2, 1) | fixed(RINGS), "half_width is no key\nbase is no key"),
            ({"law": TODA}, "law is given, but kind ring has none"),
        ],
    ),
    "motion": (
        RATIOS,
        [
            ({"axes": {"start.velocty": [1.0]}}, "start.velocty | did you mean start.velocity"),
            ({"axes": {"start.velocity": [0.0, 1.0]}}, "start.velocity is 0,"),
            ({"axes": {"beads.count": [20, 20.5]}}, "beads.count is 20.5"),
            ({"axes": {"beads.mass.cell.2": [-1.0, 1.0]}}, "beads.mass.cell (entry 2) is -1,"),
            ({"tolerance": 1e-8}, "tolerance is given, but kind motion has none"),
            ({"fixed": {"beads": 30}}, "fixed is given, but kind motion has none"),
            (sensors({}), "sensors has 0 entries"),
            (sensors({"a": 3}), "record.sensors.a is 3"),
            ({"scene": ...}, "scene is missing, but kind motion needs one"),
        ],
    ),
}


@pytest.mark.parametrize("kind", REFUSED)
def test_impossible_campaign_is_refused(kind):
    given, rows = REFUSED[kind]
    for changes, words in rows:
        with pytest.raises(InputError) as caught:
            campaign(given, **changes)
        assert str(caught.value).startswith("Campaign mine: ")
        assert_refused(str(caught.value), words)


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
